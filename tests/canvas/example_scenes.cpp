// SPDX-License-Identifier: GPL-3.0-or-later
#include "example_scenes.h"

#include <cmath>
#include <numbers>

namespace mesecina {

namespace {

void number_elements(Primitive_set& set) {
  Values values{"number", "", {}};
  for (std::size_t i = 0; i < set.element_count(); ++i) values.data.push_back(static_cast<double>(i) + 0.5);
  set.values.push_back(std::move(values));
}

void add_arc(Primitive_set& set, const Point_2& center, double radius, double start, double end,
             bool counterclockwise) {
  const double degree = std::numbers::pi / 180;
  const int from =
      add_vertex(set, center.x + radius * std::cos(start * degree), center.y + radius * std::sin(start * degree));
  const int to =
      add_vertex(set, center.x + radius * std::cos(end * degree), center.y + radius * std::sin(end * degree));
  set.arcs.push_back({center, radius, from, to, counterclockwise});
}

}  // namespace

int add_vertex(Primitive_set& set, double x, double y) {
  set.vertices.push_back({x, y, 0});
  return static_cast<int>(set.vertices.size()) - 1;
}

void add_polygon(Primitive_set& set, std::initializer_list<Point_2> ring) {
  if (set.polygon_offsets.empty()) set.polygon_offsets.push_back(0);
  for (const Point_2& p : ring) set.polygon_vertices.push_back(add_vertex(set, p.x, p.y));
  set.polygon_offsets.push_back(static_cast<int>(set.polygon_vertices.size()));
}

Scene_layer make_layer(std::string id, std::shared_ptr<const Primitive_set> set, Color color, double opacity) {
  Scene_layer layer;
  layer.label = id;
  layer.id = std::move(id);
  layer.primitives = std::move(set);
  layer.style.visible = true;
  layer.style.color = color;
  layer.style.opacity = opacity;
  return layer;
}

std::shared_ptr<Primitive_set> every_kind() {
  auto set = std::make_shared<Primitive_set>();
  for (int i = 0; i < 6; ++i) set->points.push_back(add_vertex(*set, 5 + 3 * i, 5 + i));
  for (int i = 0; i < 5; ++i)
    set->segments.push_back({add_vertex(*set, 30, 5 + 2 * i), add_vertex(*set, 45 + 2 * i, 3 + 4 * i)});
  for (int i = 0; i < 5; ++i) {
    const double angle = 0.3 + 0.25 * i;
    set->rays.push_back({add_vertex(*set, 70, 10), {std::cos(angle), std::sin(angle), 0}});
  }
  add_arc(*set, {15, 30}, 8, 20, 250, true);
  add_arc(*set, {15, 30}, 6, 20, 250, false);
  add_arc(*set, {35, 32}, 7, 300, 60, true);
  add_arc(*set, {35, 32}, 5, 100, 140, false);
  const int start = add_vertex(*set, 60, 30);
  set->arcs.push_back({{55, 30}, 5, start, start, true});
  set->triangles.push_back({add_vertex(*set, 5, 45), add_vertex(*set, 20, 45), add_vertex(*set, 10, 58)});
  set->triangles.push_back({add_vertex(*set, 22, 46), add_vertex(*set, 30, 48), add_vertex(*set, 25, 60)});
  add_polygon(*set, {{35, 45}, {50, 44}, {55, 55}, {45, 50}, {36, 60}});
  for (int i = 0; i < 6; ++i) set->balls.push_back({add_vertex(*set, 10 + 9 * i, 70), 1.0 + 1.4 * i});
  number_elements(*set);
  return set;
}

std::shared_ptr<Primitive_set> areas() {
  auto set = std::make_shared<Primitive_set>();
  set->triangles.push_back({add_vertex(*set, 62, 20), add_vertex(*set, 80, 22), add_vertex(*set, 70, 34)});
  set->triangles.push_back({add_vertex(*set, 80, 22), add_vertex(*set, 90, 38), add_vertex(*set, 70, 34)});
  add_polygon(*set, {{2, 2}, {60, 4}, {55, 40}, {30, 25}, {4, 42}});
  add_polygon(*set, {{10, 8}, {45, 8}, {45, 24}, {12, 22}});
  add_polygon(*set, {{20, 11}, {35, 11}, {33, 18}});
  for (int i = 0; i < 5; ++i) set->balls.push_back({add_vertex(*set, 15 + 12 * i, 55), 2.0 + 2 * i});
  number_elements(*set);
  return set;
}

std::shared_ptr<Primitive_set> picture() {
  auto image = std::make_shared<Image>();
  image->width = 6;
  image->height = 4;
  image->lower_left = {60, 50};
  image->pixel_size = 5;
  for (int y = 0; y < image->height; ++y) {
    for (int x = 0; x < image->width; ++x) {
      for (int component : {50 * x, 80 * y, 255 - 40 * x, x == 2 ? 100 : 255})
        image->rgba.push_back(static_cast<std::uint8_t>(component));
    }
  }
  auto set = std::make_shared<Primitive_set>();
  set->image = image;
  return set;
}

Scene example_scene() {
  Scene scene;
  scene.layers.push_back(make_layer("picture", picture(), {}, 0.8));
  scene.layers.push_back(make_layer("areas", areas(), {240, 170, 60}, 0.6));
  scene.layers.back().style.filled = true;
  scene.layers.push_back(make_layer("lines", every_kind(), {20, 60, 140}));
  scene.layers.back().style.line_width = 2.5;
  scene.layers.back().style.point_size = 9;
  return scene;
}

}  // namespace mesecina
