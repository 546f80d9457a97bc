// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <memory>
#include <vector>

#include "app2d/editor_2.h"

namespace mesecina {

/// The coordinates of the points, exact and editable. Costs nothing per point but what the view itself keeps.
class Points_model_2 : public QAbstractTableModel {
  Q_OBJECT
 public:
  using QAbstractTableModel::QAbstractTableModel;

  void set_points(std::shared_ptr<const std::vector<Point_2>> points);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Takes numbers in the C locale; says what is wrong with other texts in `rejected`.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  void point_edited(std::size_t index, const mesecina::Point_2& position);
  void rejected(const QString& message);

 private:
  std::shared_ptr<const std::vector<Point_2>> points_;
};

/// Table of the points whose selected rows are the selected points.
class Points_table_2 : public QTableView {
  Q_OBJECT
 public:
  explicit Points_table_2(Editor_2& editor, QWidget* parent = nullptr);

  /// Starts editing the coordinates of a point.
  void edit_point(std::size_t index);

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void refresh();
  void show_selection();
  void take_selection();

  Editor_2& editor_;
  Points_model_2* model_;
  bool is_showing_selection_ = false;
};

}  // namespace mesecina
