// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/input_table_3.h"

#include <utility>

namespace mesecina {

namespace {

Number_model::Words words_of(Rows_3 rows) {
  const auto tr = [](const char* text) { return Input_table_3::tr(text); };
  QStringList columns{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  if (rows == Rows_3::points) return {std::move(columns), tr("Point %1"), -1, {}};
  columns << tr("radius");
  constexpr int radius = 3;
  return {std::move(columns), tr("Ball %1"), radius, tr("a radius of at least 0")};
}

std::vector<std::size_t>& rows_of(Selection_3& selection, Rows_3 rows) {
  return rows == Rows_3::balls ? selection.balls : selection.points;
}

template <class Point>
auto& coordinate(Point& point, int column) {
  return column == 0 ? point.x : column == 1 ? point.y : point.z;
}

}  // namespace

Input_table_3::Input_table_3(Rows_3 rows, Editor_3& editor, QWidget* parent)
    : Number_table(words_of(rows),
                   {[this](Number_model& model) { fill(model); },
                    [this] {
                      Selection_3 selection = editor_.selection();
                      return std::move(rows_of(selection, rows_));
                    },
                    [this](std::vector<std::size_t> selected) {
                      Selection_3 selection = editor_.selection();
                      rows_of(selection, rows_) = std::move(selected);
                      editor_.select(std::move(selection));
                    }},
                   parent),
      rows_(rows),
      editor_(editor) {
  setObjectName(rows == Rows_3::balls ? QStringLiteral("balls-table") : QStringLiteral("points-table"));
  setAccessibleName(rows == Rows_3::balls ? tr("Centers and radii of the given balls")
                                          : tr("Coordinates of the points"));
  connect(&editor_.document(), &Document::changed, this, [this](const Document_change& change) {
    if (change.inputs) refresh();
  });
  connect(&editor_, &Editor_3::selection_changed, this, &Input_table_3::show_selection);
  connect(&numbers(), &Number_model::edited, this, &Input_table_3::edit);
  connect(&numbers(), &Number_model::rejected, &editor_, &Editor_3::failed);
}

void Input_table_3::fill(Number_model& model) {
  const Inputs& inputs = editor_.document().inputs();
  if (rows_ == Rows_3::points) {
    if (inputs.get(cloud_input) == points_) return;
    points_ = inputs.get(cloud_input);
    model.set_rows(points_ ? points_->size() : 0,
                   [points = points_](std::size_t row, int column) { return coordinate((*points)[row], column); });
  } else {
    if (inputs.get(balls_input) == balls_) return;
    balls_ = inputs.get(balls_input);
    constexpr int radius = 3;
    model.set_rows(balls_ ? balls_->size() : 0, [balls = balls_](std::size_t row, int column) {
      return column == radius ? (*balls)[row].radius : coordinate((*balls)[row].center, column);
    });
  }
}

void Input_table_3::edit(std::size_t row, int column, double number) {
  if (rows_ == Rows_3::points) {
    Point_3 point = (*points_)[row];
    coordinate(point, column) = number;
    editor_.change_point(row, point);
  } else {
    Ball_3 ball = (*balls_)[row];
    constexpr int radius = 3;
    (column == radius ? ball.radius : coordinate(ball.center, column)) = number;
    editor_.change_ball(row, ball);
  }
}

}  // namespace mesecina
