// SPDX-License-Identifier: GPL-3.0-or-later
#include "example_scenes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

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

void add_union_boundary(Primitive_set& set, const std::vector<Disk_2>& disks) {
  struct Crossing {
    double angle = 0;
    int vertex = 0;
  };
  std::vector<std::size_t> by_left(disks.size());
  for (std::size_t i = 0; i < disks.size(); ++i) by_left[i] = i;
  std::sort(by_left.begin(), by_left.end(), [&](std::size_t i, std::size_t j) {
    return disks[i].center.x - disks[i].radius < disks[j].center.x - disks[j].radius;
  });
  std::vector<std::vector<std::size_t>> neighbours(disks.size());
  for (std::size_t a = 0; a < by_left.size(); ++a) {
    const Disk_2& disk = disks[by_left[a]];
    for (std::size_t b = a + 1; b < by_left.size(); ++b) {
      const Disk_2& other = disks[by_left[b]];
      if (other.center.x - other.radius > disk.center.x + disk.radius) break;
      if (distance(disk.center, other.center) >= disk.radius + other.radius) continue;
      neighbours[by_left[a]].push_back(by_left[b]);
      neighbours[by_left[b]].push_back(by_left[a]);
    }
  }
  const auto is_inside_another = [&](std::size_t i, const Point_2& p, std::size_t but) {
    return std::any_of(neighbours[i].begin(), neighbours[i].end(),
                       [&](std::size_t j) { return j != but && distance(p, disks[j].center) < disks[j].radius; });
  };
  // Of two circles, the crossing to the left of the way from one to the other.
  std::map<std::pair<std::size_t, std::size_t>, int> vertices;
  for (std::size_t i = 0; i < disks.size(); ++i) {
    const auto& [center, radius] = disks[i];
    const auto at = [&, c = center, r = radius](double angle) {
      return Point_2{c.x + r * std::cos(angle), c.y + r * std::sin(angle)};
    };
    std::vector<Crossing> crossings;
    for (const std::size_t j : neighbours[i]) {
      const double away = distance(center, disks[j].center);
      if (away <= std::abs(radius - disks[j].radius)) continue;
      const double half =
          std::acos((away * away + radius * radius - disks[j].radius * disks[j].radius) / (2 * away * radius));
      const double middle = std::atan2(disks[j].center.y - center.y, disks[j].center.x - center.x);
      for (const bool left : {true, false}) {
        const double angle = left ? middle + half : middle - half;
        if (is_inside_another(i, at(angle), j)) continue;
        const auto [known, is_new] = vertices.try_emplace(left ? std::pair(i, j) : std::pair(j, i), 0);
        if (is_new) known->second = add_vertex(set, at(angle).x, at(angle).y);
        crossings.push_back({angle - 2 * std::numbers::pi * std::floor(angle / (2 * std::numbers::pi)), known->second});
      }
    }
    if (crossings.empty()) {
      if (is_inside_another(i, at(0), i)) continue;
      const int start = add_vertex(set, at(0).x, at(0).y);
      set.arcs.push_back({center, radius, start, start, true});
      continue;
    }
    std::sort(crossings.begin(), crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.angle < b.angle; });
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      const Crossing& from = crossings[k];
      Crossing to = crossings[(k + 1) % crossings.size()];
      if (k + 1 == crossings.size()) to.angle += 2 * std::numbers::pi;
      if (!is_inside_another(i, at((from.angle + to.angle) / 2), i))
        set.arcs.push_back({center, radius, from.vertex, to.vertex, true});
    }
  }
}

std::shared_ptr<Primitive_set> closed_arcs() {
  auto set = std::make_shared<Primitive_set>();
  std::vector<Disk_2> ring;
  for (int i = 0; i < 9; ++i) {
    const double angle = 2 * std::numbers::pi * i / 9;
    ring.push_back({{22 + 14 * std::cos(angle), 22 + 14 * std::sin(angle)}, 5 + 0.3 * i});
  }
  ring.push_back({{22, 22}, 3});
  add_union_boundary(*set, ring);
  add_union_boundary(*set, {{{50, 15}, 8}, {{60, 18}, 6}, {{53, 26}, 5}, {{58, 15}, 1}});

  const auto add_lens = [&](const Point_2& center, double half_length, double half_width) {
    const double radius = (half_length * half_length + half_width * half_width) / (2 * half_width);
    const int left = add_vertex(*set, center.x - half_length, center.y);
    const int right = add_vertex(*set, center.x + half_length, center.y);
    set->arcs.push_back({{center.x, center.y + radius - half_width}, radius, left, right, true});
    set->arcs.push_back({{center.x, center.y - radius + half_width}, radius, left, right, false});
  };
  add_lens({82, 10}, 14, 4);
  add_lens({82, 20}, 14, 0.08);

  const auto add_circle = [&](const Point_2& center, double radius, int vertex) {
    set->arcs.push_back({center, radius, vertex, vertex, set->arcs.size() % 2 == 0});
  };
  for (const double radius : {12.0, 9.0, 6.0, 2.5}) add_circle({82, 38}, radius, add_vertex(*set, 82, 38 + radius));

  const int touching = add_vertex(*set, 20, 60);
  add_circle({20, 68}, 8, touching);
  add_circle({20, 64}, 4, touching);
  add_circle({20, 53}, 7, touching);

  const int middle = add_vertex(*set, 50, 60);
  const int right = add_vertex(*set, 58, 60);
  const int left = add_vertex(*set, 42, 60);
  set->arcs.push_back({{54, 60}, 4, middle, right, true});
  set->arcs.push_back({{46, 60}, 4, left, middle, true});
  set->arcs.push_back({{54, 57}, 5, right, middle, true});
  set->arcs.push_back({{46, 63}, 5, left, middle, true});

  add_arc(*set, {75, 66}, 8, 30, 300, true);
  const int fork = add_vertex(*set, 92, 60);
  const int top = add_vertex(*set, 92, 76);
  set->arcs.push_back({{92, 68}, 8, fork, top, true});
  set->arcs.push_back({{92, 68}, 8, fork, top, false});
  set->arcs.push_back({{72, 68}, std::sqrt(464.0), fork, top, true});
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
