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

std::shared_ptr<const Primitive_set> as_disks(const std::vector<Disk_2>& disks) {
  auto set = std::make_shared<Primitive_set>();
  for (const Disk_2& disk : disks) {
    set->balls.push_back({static_cast<int>(set->vertices.size()), disk.radius});
    set->vertices.push_back({disk.center.x, disk.center.y, 0});
  }
  return set;
}

std::shared_ptr<const Primitive_set> as_line(const std::vector<Point_2>& points) {
  auto set = vertices_of(points);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    set->segments.push_back({static_cast<int>(i), static_cast<int>(i + 1)});
  return set;
}

}  // namespace

std::vector<Scene_layer> make_overlay(const Overlay_2& overlay) {
  std::vector<Scene_layer> layers;
  constexpr double rim = 3;
  constexpr double thick = 2.5;
  const double size = overlay.marker_size;
  const Hovered_2* hovered = overlay.hovered;
  if (hovered && hovered->dual)
    layers.push_back(overlay_layer("hover-dual", hovered->dual, dual_color, size + rim, thick, 0.85));
  if (hovered) layers.push_back(overlay_layer("hover", hovered->highlight, hover_color, size + rim, 3.5, 0.9));
  if (!overlay.selected_disks.empty())
    layers.push_back(overlay_layer("selected-disks", as_disks(overlay.selected_disks), selection_color, size, thick));
  const Preview_2& preview = overlay.preview;
  if (preview.disk)
    layers.push_back(overlay_layer("drawn-disk", as_disks({*preview.disk}), selection_color, size, thick));
  if (!preview.line.empty()) {
    layers.push_back(overlay_layer("drawn-line", as_line(preview.line), selection_color, size, preview.disk ? 1 : 2));
    layers.push_back(overlay_layer("drawn-vertices", as_points(preview.line), selection_color, size, 1));
  }
  if (!overlay.selected.empty()) {
    const auto points = as_points(overlay.selected);
    layers.push_back(overlay_layer("selection-rim", points, overlay.background, size + 2 * rim, 1));
    layers.push_back(overlay_layer("selection", points, selection_color, size + rim, 1));
  }
  if (!overlay.handles.empty()) {
    constexpr double handle_size = 12;
    std::vector<Point_2> places;
    for (const Disk_handle_2& handle : overlay.handles) places.push_back(handle.position);
    const auto points = as_points(places);
    layers.push_back(overlay_layer("handle-rims", points, selection_color, handle_size, 1));
    layers.push_back(overlay_layer("handles", points, overlay.background, handle_size - 2 * thick, 1));
  }
  return layers;
}

}  // namespace mesecina
