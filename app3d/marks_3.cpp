// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/marks_3.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <utility>

namespace mesecina {

namespace {

constexpr Color selection_color{240, 110, 0};
constexpr Color ghost_color{0, 140, 255};
constexpr double size_of_points = 9;
constexpr double size_of_many_points = 5;
constexpr double faint = 0.45;
constexpr std::size_t most_outlines = 300;
/// Beyond, an outline is no circle that one sees.
constexpr double largest_outline = 20000;

Scene_layer mark(const char* id, std::shared_ptr<const Primitive_set> set, Color color) {
  Scene_layer layer{id, {}, std::move(set), {}, {}};
  layer.style.visible = true;
  layer.style.color = color;
  layer.style.point_size = size_of_points;
  layer.style.filled = true;
  layer.style.opacity = faint;
  return layer;
}

QColor painted(Color color) { return {color.red, color.green, color.blue}; }

}  // namespace

std::vector<Scene_layer> selection_marks_3(const Inputs& inputs, const Selection_3& selection) {
  std::vector<Scene_layer> layers;
  const auto in_space = [] {
    auto set = std::make_shared<Primitive_set>();
    set->dimension = 3;
    return set;
  };
  const std::vector<Point_3> points = positions(inputs, {selection.points, {}});
  if (!points.empty()) {
    auto set = in_space();
    set->vertices = points;
    for (std::size_t i = 0; i < points.size(); ++i) set->points.push_back(static_cast<int>(i));
    Scene_layer layer = mark("selected-points", std::move(set), selection_color);
    layer.style.opacity = 1;
    if (points.size() > most_outlines) layer.style.point_size = size_of_many_points;
    layers.push_back(std::move(layer));
  }
  const std::vector<Ball_3> balls = selected_balls(inputs, selection);
  if (!balls.empty()) {
    auto set = in_space();
    for (const Ball_3& ball : balls) {
      set->balls.push_back({static_cast<int>(set->vertices.size()), ball.radius});
      set->vertices.push_back(ball.center);
    }
    layers.push_back(mark("selected-balls", std::move(set), selection_color));
  }
  return layers;
}

Scene_layer ghost_layer_3(std::shared_ptr<const Primitive_set> primitives) {
  Scene_layer layer = mark("ghost", std::move(primitives), ghost_color);
  layer.style.sliced = false;
  return layer;
}

void paint_outlines_3(QPainter& painter, const Sight_3& sight, const Inputs& inputs, const Selection_3& selection) {
  if (selection.size() > most_outlines) return;
  const auto paint_circle = [&](const Point_3& center, double radius) {
    const auto pixel = sight.pixel(center);
    if (pixel && radius < largest_outline) painter.drawEllipse(QPointF(pixel->x, pixel->y), radius, radius);
  };
  painter.setBrush(Qt::NoBrush);
  constexpr double wide = 1.6;
  painter.setPen(QPen(painted(selection_color), wide));
  for (const Point_3& point : positions(inputs, {selection.points, {}})) paint_circle(point, size_of_points / 2);
  for (const Ball_3& ball : selected_balls(inputs, selection))
    paint_circle(ball.center, sight.outline_radius(ball.center, ball.radius));
}

void paint_handle_3(QPainter& painter, const QPointF& pixel) {
  constexpr double half_side = 4;
  constexpr double wide = 1.6;
  painter.setPen(QPen(painted(selection_color), wide));
  painter.setBrush(Qt::white);
  painter.drawRect(QRectF(pixel - QPointF(half_side, half_side), pixel + QPointF(half_side, half_side)));
}

void paint_rectangle_3(QPainter& painter, const QRectF& rectangle) {
  QColor color = painted(ghost_color);
  painter.setPen(QPen(color, 1, Qt::DashLine));
  constexpr int almost_clear = 30;
  color.setAlpha(almost_clear);
  painter.setBrush(color);
  painter.drawRect(rectangle);
}

QString radius_readout_3(double radius) {
  constexpr int digits = 5;
  return QCoreApplication::translate("tools", "radius %1").arg(QString::number(radius, 'g', digits));
}

}  // namespace mesecina
