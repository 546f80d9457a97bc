// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/points_table_2.h"

#include <QHeaderView>
#include <QItemSelection>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/number.h"

namespace mesecina {

namespace {
/// More separate runs of rows than this take the view long and tell the user nothing.
constexpr int most_runs = 2000;
}  // namespace

void Points_model_2::set_points(std::shared_ptr<const std::vector<Point_2>> points) {
  if (points == points_) return;
  const int before = rowCount();
  const int after = points ? static_cast<int>(points->size()) : 0;
  if (after > before) {
    beginInsertRows({}, before, after - 1);
    points_ = std::move(points);
    endInsertRows();
  } else if (after < before) {
    beginRemoveRows({}, after, before - 1);
    points_ = std::move(points);
    endRemoveRows();
  } else {
    points_ = std::move(points);
  }
  if (after > 0) Q_EMIT dataChanged(index(0, 0), index(after - 1, 1));
}

int Points_model_2::rowCount(const QModelIndex& parent) const {
  return points_ && !parent.isValid() ? static_cast<int>(points_->size()) : 0;
}

int Points_model_2::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 2; }

QVariant Points_model_2::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole) return {};
  const Point_2& p = (*points_)[static_cast<std::size_t>(index.row())];
  return QString::fromStdString(format_number(index.column() == 0 ? p.x : p.y));
}

QVariant Points_model_2::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section;
  return section == 0 ? QStringLiteral("x") : QStringLiteral("y");
}

Qt::ItemFlags Points_model_2::flags(const QModelIndex& index) const {
  return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

bool Points_model_2::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount()) return false;
  const QString text = value.toString().trimmed();
  const std::optional<double> number = parse_number(text.toStdString());
  if (!number || !std::isfinite(*number)) {
    Q_EMIT rejected(tr("Point %1: expected a number such as 1.5, found \"%2\".").arg(index.row()).arg(text));
    return false;
  }
  Point_2 position = (*points_)[static_cast<std::size_t>(index.row())];
  (index.column() == 0 ? position.x : position.y) = *number;
  Q_EMIT point_edited(static_cast<std::size_t>(index.row()), position);
  return true;
}

Points_table_2::Points_table_2(Editor_2& editor, QWidget* parent)
    : QTableView(parent), editor_(editor), model_(new Points_model_2(this)) {
  setModel(model_);
  setObjectName(QStringLiteral("points-table"));
  setAccessibleName(tr("Coordinates of the points"));
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setAlternatingRowColors(true);
  setWordWrap(false);
  // Cut off at the end, a number would look as if it had no exponent.
  setTextElideMode(Qt::ElideMiddle);
  setFrameShape(QFrame::NoFrame);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  horizontalHeader()->setHighlightSections(false);
  verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() * 3 / 2);
  verticalHeader()->setHighlightSections(false);
  setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                  QAbstractItemView::AnyKeyPressed);
  connect(&editor_.document(), &Document::changed, this, [this](const Document_change& change) {
    if (change.inputs) refresh();
  });
  connect(&editor_, &Editor_2::selection_changed, this, &Points_table_2::show_selection);
  connect(model_, &Points_model_2::point_edited, this,
          [this](std::size_t index, const Point_2& position) { editor_.place_point(index, position); });
  connect(model_, &Points_model_2::rejected, &editor_, &Editor_2::failed);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &Points_table_2::take_selection);
}

void Points_table_2::edit_point(std::size_t index) {
  const QModelIndex cell = model_->index(static_cast<int>(index), 0);
  scrollTo(cell);
  setFocus();
  setCurrentIndex(cell);
  edit(cell);
}

void Points_table_2::showEvent(QShowEvent* event) {
  refresh();
  show_selection();
  QTableView::showEvent(event);
}

void Points_table_2::refresh() {
  if (!isVisible() && model_->rowCount() == 0) return;
  // Rows that go must not look as if the user had changed the selection.
  is_showing_selection_ = true;
  model_->set_points(editor_.document().inputs().get(points_input));
  is_showing_selection_ = false;
}

void Points_table_2::show_selection() {
  if (is_showing_selection_ || !isVisible()) return;
  model_->set_points(editor_.document().inputs().get(points_input));
  QItemSelection rows;
  const std::vector<std::size_t>& points = editor_.selection().points;
  for (std::size_t i = 0; i < points.size() && rows.size() < most_runs;) {
    std::size_t end = i + 1;
    while (end < points.size() && points[end] == points[end - 1] + 1) ++end;
    rows.append(QItemSelectionRange(model_->index(static_cast<int>(points[i]), 0),
                                    model_->index(static_cast<int>(points[end - 1]), 1)));
    i = end;
  }
  is_showing_selection_ = true;
  selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (!points.empty() && !hasFocus()) scrollTo(model_->index(static_cast<int>(points.front()), 0));
  is_showing_selection_ = false;
}

void Points_table_2::take_selection() {
  if (is_showing_selection_) return;
  Selection_2 selection;
  selection.vertices = editor_.selection().vertices;
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row) selection.points.push_back(static_cast<std::size_t>(row));
  std::ranges::sort(selection.points);
  selection.points.erase(std::unique(selection.points.begin(), selection.points.end()), selection.points.end());
  is_showing_selection_ = true;
  editor_.select(std::move(selection));
  is_showing_selection_ = false;
}

}  // namespace mesecina
