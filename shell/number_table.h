// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <QTableView>
#include <cstddef>
#include <functional>
#include <vector>

namespace mesecina {

/// Rows of numbers, exact and editable. Costs nothing per row but what a view itself keeps.
class Number_model : public QAbstractTableModel {
  Q_OBJECT
 public:
  /// What the columns are called, and a row ("Disk %1", for messages). In a column of `not_negative` no number below 0
  /// is taken.
  struct Words {
    QStringList columns;
    QString row;
    int not_negative = -1;
    QString not_negative_is;  ///< "a radius of at least 0"
  };
  /// number(row, column) is asked for what is in view; it holds what it reads.
  using Numbers = std::function<double(std::size_t row, int column)>;

  explicit Number_model(Words words, QObject* parent = nullptr)
      : QAbstractTableModel(parent), words_(std::move(words)) {}

  /// Other rows, or other numbers in them.
  void set_rows(std::size_t count, Numbers number);
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;
  /// Takes finite numbers in the C locale; says what is wrong with other texts in `rejected`.
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;

 Q_SIGNALS:
  /// The user wants another number there; the rows stay until set_rows.
  void edited(std::size_t row, int column, double number);
  void rejected(const QString& message);

 private:
  Words words_;
  Numbers number_;
  int count_ = 0;
};

/// A table of numbers whose selected rows are selected elsewhere too. Where a number is too long for its column, it is
/// shown with fewer digits.
class Number_table : public QTableView {
  Q_OBJECT
 public:
  /// How the table hears of what it shows and is selected; both are sorted.
  struct Link {
    std::function<void(Number_model&)> fill;  ///< set_rows, where they have changed
    std::function<std::vector<std::size_t>()> selected;
    std::function<void(std::vector<std::size_t>)> select;
  };
  Number_table(Number_model::Words words, Link link, QWidget* parent = nullptr);

  Number_model& numbers() { return *model_; }
  /// What it shows may have changed. Does nothing while the table was never seen.
  void refresh();
  /// What is selected has changed elsewhere.
  void show_selection();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void take_selection();

  Link link_;
  Number_model* model_;
  bool is_showing_selection_ = false;
};

}  // namespace mesecina
