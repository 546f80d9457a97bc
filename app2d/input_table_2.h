// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app2d/editor_2.h"
#include "shell/number_table.h"

namespace mesecina {

/// What the rows of a table are.
enum class Rows_2 { points, disks };

/// Table of the numbers of points or disks, whose selected rows are the selected ones.
class Input_table_2 : public Number_table {
  Q_OBJECT
 public:
  Input_table_2(Rows_2 rows, Editor_2& editor, QWidget* parent = nullptr);

 private:
  void fill(Number_model& model);
  void edit(std::size_t row, int column, double number);

  Rows_2 rows_;
  Editor_2& editor_;
  std::shared_ptr<const std::vector<Point_2>> points_;  ///< that the table shows
  std::shared_ptr<const std::vector<Disk_2>> disks_;
};

}  // namespace mesecina
