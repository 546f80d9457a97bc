// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/overlay_2.h"

#include <utility>

namespace mesecina {

namespace {

constexpr Color selection_color{240, 110, 0};
constexpr Color hover_color{0, 140, 255};
constexpr Color dual_color{230, 0, 140};

Scene_layer overlay_layer(std::string id, std::shared_ptr<const Primitive_set> set, Color color, double size,
                          double width, double opacity = 1) {
  Scene_layer layer;
  layer.id = std::move(id);
  layer.primitives = std::move(set);
  layer.style.visible = true;
  layer.style.color = color;
  layer.style.point_size = size;
  layer.style.line_width = width;
  layer.style.opacity = opacity;
  return layer;
}

std::shared_ptr<Primitive_set> vertices_of(const std::vector<Point_2>& points) {
  auto set = std::make_shared<Primitive_set>();
  set->vertices.reserve(points.size());
  for (const Point_2& p : points) set->vertices.push_back({p.x, p.y, 0});
  return set;
}

std::shared_ptr<const Primitive_set> as_points(const std::vector<Point_2>& points) {
  auto set = vertices_of(points);
  set->points.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) set->points[i] = static_cast<int>(i);
  return set;
}

std::shared_ptr<const Primitive_set> as_line(const std::vector<Point_2>& points) {
  auto set = vertices_of(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    set->segments.push_back({static_cast<int>(i), static_cast<int>(i + 1)});
  return set;
}

}  // namespace

std::vector<Scene_layer> make_overlay(const std::vector<Point_2>& selected, const std::vector<Point_2>& line,
                                      const Hovered_2* hovered, Color background, double marker_size) {
  std::vector<Scene_layer> overlay;
  constexpr double rim = 3;
  if (hovered && hovered->dual)
    overlay.push_back(overlay_layer("hover-dual", hovered->dual, dual_color, marker_size + rim, 2.5, 0.85));
  if (hovered) overlay.push_back(overlay_layer("hover", hovered->highlight, hover_color, marker_size + rim, 3.5, 0.9));
  if (!line.empty()) {
    overlay.push_back(overlay_layer("drawn-line", as_line(line), selection_color, marker_size, 2));
    overlay.push_back(overlay_layer("drawn-vertices", as_points(line), selection_color, marker_size, 1));
  }
  if (!selected.empty()) {
    const auto points = as_points(selected);
    overlay.push_back(overlay_layer("selection-rim", points, background, marker_size + 2 * rim, 1));
    overlay.push_back(overlay_layer("selection", points, selection_color, marker_size + rim, 1));
  }
  return overlay;
}

}  // namespace mesecina
