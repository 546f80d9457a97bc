// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/input_table_2.h"

#include <utility>

namespace mesecina {

namespace {

Number_model::Words words_of(Rows_2 rows) {
  const auto tr = [](const char* text) { return Input_table_2::tr(text); };
  if (rows == Rows_2::points) return {{QStringLiteral("x"), QStringLiteral("y")}, tr("Point %1"), -1, {}};
  constexpr int radius = 2;
  return {
      {QStringLiteral("x"), QStringLiteral("y"), tr("radius")}, tr("Disk %1"), radius, tr("a radius of at least 0")};
}

std::vector<std::size_t>& rows_of(Selection_2& selection, Rows_2 rows) {
  return rows == Rows_2::disks ? selection.disks : selection.points;
}

}  // namespace

Input_table_2::Input_table_2(Rows_2 rows, Editor_2& editor, QWidget* parent)
    : Number_table(words_of(rows),
                   {[this](Number_model& model) { fill(model); },
                    [this] {
                      Selection_2 selection = editor_.selection();
                      return std::move(rows_of(selection, rows_));
                    },
                    [this](std::vector<std::size_t> selected) {
                      Selection_2 selection = editor_.selection();
                      rows_of(selection, rows_) = std::move(selected);
                      editor_.select(std::move(selection));
                    }},
                   parent),
      rows_(rows),
      editor_(editor) {
  setObjectName(rows == Rows_2::disks ? QStringLiteral("disks-table") : QStringLiteral("points-table"));
  setAccessibleName(rows == Rows_2::disks ? tr("Centers and radii of the disks") : tr("Coordinates of the points"));
  connect(&editor_.document(), &Document::changed, this, [this](const Document_change& change) {
    if (change.inputs) refresh();
  });
  connect(&editor_, &Editor_2::selection_changed, this, &Input_table_2::show_selection);
  connect(&numbers(), &Number_model::edited, this, &Input_table_2::edit);
  connect(&numbers(), &Number_model::rejected, &editor_, &Editor_2::failed);
}

void Input_table_2::fill(Number_model& model) {
  const Inputs& inputs = editor_.document().inputs();
  if (rows_ == Rows_2::points) {
    if (inputs.get(points_input) == points_) return;
    points_ = inputs.get(points_input);
    model.set_rows(points_ ? points_->size() : 0, [points = points_](std::size_t row, int column) {
      const Point_2& p = (*points)[row];
      return column == 0 ? p.x : p.y;
    });
  } else {
    if (inputs.get(disks_input) == disks_) return;
    disks_ = inputs.get(disks_input);
    model.set_rows(disks_ ? disks_->size() : 0, [disks = disks_](std::size_t row, int column) {
      const Disk_2& disk = (*disks)[row];
      return column == 0 ? disk.center.x : column == 1 ? disk.center.y : disk.radius;
    });
  }
}

void Input_table_2::edit(std::size_t row, int column, double number) {
  if (rows_ == Rows_2::points) {
    Point_2 point = (*points_)[row];
    (column == 0 ? point.x : point.y) = number;
    editor_.place_point(row, point);
  } else {
    Disk_2 disk = (*disks_)[row];
    (column == 0 ? disk.center.x : column == 1 ? disk.center.y : disk.radius) = number;
    editor_.change_disk(row, disk);
  }
}

}  // namespace mesecina
