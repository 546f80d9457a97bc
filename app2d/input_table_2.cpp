// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/input_table_2.h"

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

void Input_model_2::set_inputs(const Inputs& inputs) {
  auto points = is_disks() ? nullptr : inputs.get(points_input);
  auto disks = is_disks() ? inputs.get(disks_input) : nullptr;
  if (points == points_ && disks == disks_) return;
  const int before = rowCount();
  const auto after = static_cast<int>((points ? points->size() : 0) + (disks ? disks->size() : 0));
  const auto take = [&] {
    points_ = std::move(points);
    disks_ = std::move(disks);
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

int Input_model_2::rowCount(const QModelIndex& parent) const {
  if (parent.isValid()) return 0;
  return static_cast<int>((points_ ? points_->size() : 0) + (disks_ ? disks_->size() : 0));
}

int Input_model_2::columnCount(const QModelIndex& parent) const {
  if (parent.isValid()) return 0;
  return is_disks() ? 3 : 2;
}

Disk_2 Input_model_2::row(int number) const {
  const auto index = static_cast<std::size_t>(number);
  return is_disks() ? (*disks_)[index] : Disk_2{(*points_)[index], 0};
}

QVariant Input_model_2::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role != Qt::DisplayRole && role != Qt::EditRole && role != Qt::ToolTipRole) return {};
  const Disk_2 disk = row(index.row());
  const double numbers[] = {disk.center.x, disk.center.y, disk.radius};
  return QString::fromStdString(format_number(numbers[index.column()]));
}

QVariant Input_model_2::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole) return {};
  if (orientation == Qt::Vertical) return section;
  const QString names[] = {QStringLiteral("x"), QStringLiteral("y"), tr("radius")};
  return section < 3 ? names[section] : QVariant();
}

Qt::ItemFlags Input_model_2::flags(const QModelIndex& index) const {
  return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

bool Input_model_2::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount()) return false;
  const QString text = value.toString().trimmed();
  const std::optional<double> number = parse_number(text.toStdString());
  const bool is_radius = index.column() == 2;
  if (!number || !std::isfinite(*number) || (is_radius && *number < 0)) {
    const QString name = is_disks() ? tr("Disk %1").arg(index.row()) : tr("Point %1").arg(index.row());
    const QString expected = is_radius ? tr("a radius of at least 0") : tr("a number such as 1.5");
    Q_EMIT rejected(tr("%1: expected %2, found \"%3\".").arg(name, expected, text));
    return false;
  }
  Disk_2 disk = row(index.row());
  double* const numbers[] = {&disk.center.x, &disk.center.y, &disk.radius};
  *numbers[index.column()] = *number;
  const auto edited = static_cast<std::size_t>(index.row());
  if (is_disks()) {
    Q_EMIT disk_edited(edited, disk);
  } else {
    Q_EMIT point_edited(edited, disk.center);
  }
  return true;
}

Input_table_2::Input_table_2(Rows_2 rows, Editor_2& editor, QWidget* parent)
    : QTableView(parent), rows_(rows), editor_(editor), model_(new Input_model_2(rows, this)) {
  setModel(model_);
  setObjectName(rows == Rows_2::disks ? QStringLiteral("disks-table") : QStringLiteral("points-table"));
  setAccessibleName(rows == Rows_2::disks ? tr("Centers and radii of the disks") : tr("Coordinates of the points"));
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
  connect(&editor_, &Editor_2::selection_changed, this, &Input_table_2::show_selection);
  connect(model_, &Input_model_2::point_edited, this,
          [this](std::size_t index, const Point_2& position) { editor_.place_point(index, position); });
  connect(model_, &Input_model_2::disk_edited, this,
          [this](std::size_t index, const Disk_2& disk) { editor_.change_disk(index, disk); });
  connect(model_, &Input_model_2::rejected, &editor_, &Editor_2::failed);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &Input_table_2::take_selection);
}

void Input_table_2::showEvent(QShowEvent* event) {
  refresh();
  show_selection();
  QTableView::showEvent(event);
}

void Input_table_2::refresh() {
  if (!isVisible() && model_->rowCount() == 0) return;
  // Rows that go must not look as if the user had changed the selection.
  is_showing_selection_ = true;
  model_->set_inputs(editor_.document().inputs());
  is_showing_selection_ = false;
}

void Input_table_2::show_selection() {
  if (is_showing_selection_ || !isVisible()) return;
  model_->set_inputs(editor_.document().inputs());
  QItemSelection rows;
  Selection_2 selection = editor_.selection();
  const std::vector<std::size_t>& selected = rows_of(selection, rows_);
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

void Input_table_2::take_selection() {
  if (is_showing_selection_) return;
  Selection_2 selection = editor_.selection();
  std::vector<std::size_t>& selected = rows_of(selection, rows_);
  selected.clear();
  for (const QItemSelectionRange& range : selectionModel()->selection())
    for (int row = range.top(); row <= range.bottom(); ++row) selected.push_back(static_cast<std::size_t>(row));
  std::ranges::sort(selected);
  selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
  is_showing_selection_ = true;
  editor_.select(std::move(selection));
  is_showing_selection_ = false;
}

std::vector<std::size_t>& Input_table_2::rows_of(Selection_2& selection, Rows_2 rows) {
  return rows == Rows_2::disks ? selection.disks : selection.points;
}

}  // namespace mesecina
