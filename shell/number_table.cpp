// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/number_table.h"

#include <QApplication>
#include <QHeaderView>
#include <QItemSelection>
#include <QStyledItemDelegate>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/formats/number.h"

namespace mesecina {

namespace {
/// More separate runs of rows than this take the view long and tell the user nothing.
constexpr int most_runs = 2000;

/// Shows as many digits as there is room for; the editor and the tip have all.
class Number_delegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const QStyle* style = option->widget ? option->widget->style() : QApplication::style();
    const int margin = style->pixelMetric(QStyle::PM_FocusFrameHMargin, option, option->widget) + 1;
    const auto fits = [&] {
      return option->fontMetrics.horizontalAdvance(option->text) <= option->rect.width() - 2 * margin;
    };
    const double number = option->text.toDouble();
    constexpr int most_digits = 15;
    constexpr int least_digits = 3;
    for (int digits = most_digits; digits >= least_digits && !fits(); --digits)
      option->text = QString::number(number, 'g', digits);
  }
};

}  // namespace

void Number_model::set_rows(std::size_t count, Numbers number) {
  const int before = count_;
  const auto after = static_cast<int>(count);
  const auto take = [&] {
    count_ = after;
    number_ = std::move(number);
  };
  if (after > before) {
    beginInsertRows({}, before, after - 1);
    take();
    endInsertRows();
  } else if (after < before) {
    beginRemoveRows({}, after, before - 1);
    take();
    endRemoveRows();
  } else {
    take();
  }
  if (after > 0) Q_EMIT dataChanged(index(0, 0), index(after - 1, columnCount() - 1));
}

int Number_model::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : count_; }

int Number_model::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(words_.columns.size());
}

QVariant Number_model::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole) return {};
  return QString::fromStdString(format_number(number_(static_cast<std::size_t>(index.row()), index.column())));
}

QVariant Number_model::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section;
  return section < words_.columns.size() ? words_.columns[section] : QVariant();
}

Qt::ItemFlags Number_model::flags(const QModelIndex& index) const {
  return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

bool Number_model::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount()) return false;
  const QString text = value.toString().trimmed();
  const std::optional<double> number = parse_number(text.toStdString());
  const bool is_not_negative = index.column() == words_.not_negative;
  if (!number || !std::isfinite(*number) || (is_not_negative && *number < 0)) {
    const QString expected = is_not_negative ? words_.not_negative_is : tr("a number such as 1.5");
    Q_EMIT rejected(tr("%1: expected %2, found \"%3\".").arg(words_.row.arg(index.row()), expected, text));
    return false;
  }
  Q_EMIT edited(static_cast<std::size_t>(index.row()), index.column(), *number);
  return true;
}

Number_table::Number_table(Number_model::Words words, Link link, QWidget* parent)
    : QTableView(parent), link_(std::move(link)), model_(new Number_model(std::move(words), this)) {
  setModel(model_);
  setItemDelegate(new Number_delegate(this));
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setAlternatingRowColors(true);
  setWordWrap(false);
  // Cut off at the end, a number would look as if it had no exponent.
  setTextElideMode(Qt::ElideMiddle);
  setFrameShape(QFrame::NoFrame);
  setWhatsThis(
      tr("The exact numbers of the data. Choose a row to select it in the picture; type into it to change it."));
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  horizontalHeader()->setHighlightSections(false);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  verticalHeader()->setHighlightSections(false);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                  QAbstractItemView::AnyKeyPressed);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &Number_table::take_selection);
}

void Number_table::showEvent(QShowEvent* event) {
  refresh();
  show_selection();
  QTableView::showEvent(event);
}

void Number_table::refresh() {
  if (!isVisible() && model_->rowCount() == 0) return;
  // Rows that go must not look as if the user had changed the selection.
  is_showing_selection_ = true;
  link_.fill(*model_);
  is_showing_selection_ = false;
}

void Number_table::show_selection() {
  if (is_showing_selection_ || !isVisible()) return;
  link_.fill(*model_);
  QItemSelection rows;
  const std::vector<std::size_t> selected = link_.selected();
  for (std::size_t i = 0; i < selected.size() && rows.size() < most_runs;) {
    std::size_t end = i + 1;
    while (end < selected.size() && selected[end] == selected[end - 1] + 1) ++end;
    rows.append(QItemSelectionRange(model_->index(static_cast<int>(selected[i]), 0),
                                    model_->index(static_cast<int>(selected[end - 1]), model_->columnCount() - 1)));
    i = end;
  }
  is_showing_selection_ = true;
  selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (!selected.empty() && !hasFocus()) scrollTo(model_->index(static_cast<int>(selected.front()), 0));
  is_showing_selection_ = false;
}

void Number_table::take_selection() {
  if (is_showing_selection_) return;
  std::vector<std::size_t> selected;
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row) selected.push_back(static_cast<std::size_t>(row));
  std::ranges::sort(selected);
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  is_showing_selection_ = true;
  link_.select(std::move(selected));
  is_showing_selection_ = false;
}

}  // namespace mesecina
