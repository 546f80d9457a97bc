// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <memory>
#include <vector>

#include "app2d/editor_2.h"

namespace mesecina {

/// What the rows of a table are.
enum class Rows_2 { points, disks };

/// The numbers of the points or disks, exact and editable. Costs nothing per row but what the view itself keeps.
class Input_model_2 : public QAbstractTableModel {
  Q_OBJECT
 public:
  explicit Input_model_2(Rows_2 rows, QObject* parent = nullptr) : QAbstractTableModel(parent), rows_(rows) {}

  void set_inputs(const Inputs& inputs);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Takes numbers in the C locale, as radius none below 0; says what is wrong with other texts in `rejected`.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void point_edited(std::size_t index, const mesecina::Point_2& position);
  void disk_edited(std::size_t index, const mesecina::Disk_2& disk);
  void rejected(const QString& message);

 private:
  bool is_disks() const { return rows_ == Rows_2::disks; }
  /// A point as one of radius 0.
  Disk_2 row(int number) const;

  Rows_2 rows_;
  std::shared_ptr<const std::vector<Point_2>> points_;
  std::shared_ptr<const std::vector<Disk_2>> disks_;
};

/// Table of the points or disks whose selected rows are the selected ones.
class Input_table_2 : public QTableView {
  Q_OBJECT
 public:
  Input_table_2(Rows_2 rows, Editor_2& editor, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void show_selection();
  void take_selection();
  static std::vector<std::size_t>& rows_of(Selection_2& selection, Rows_2 rows);

  Rows_2 rows_;
  Editor_2& editor_;
  Input_model_2* model_;
  bool is_showing_selection_ = false;
};

}  // namespace mesecina
