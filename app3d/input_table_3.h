// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app3d/editor_3.h"
#include "shell/number_table.h"

namespace mesecina {

/// What the rows of a table are.
enum class Rows_3 { points, balls };

/// Table of the numbers of points or given balls, whose selected rows are the selected ones.
class Input_table_3 : public Number_table {
  Q_OBJECT
 public:
  Input_table_3(Rows_3 rows, Editor_3& editor, QWidget* parent = nullptr);

 private:
  void fill(Number_model& model);
  void edit(std::size_t row, int column, double number);

  Rows_3 rows_;
  Editor_3& editor_;
  std::shared_ptr<const std::vector<Point_3>> points_;  ///< that the table shows
  std::shared_ptr<const std::vector<Ball_3>> balls_;
};

}  // namespace mesecina
