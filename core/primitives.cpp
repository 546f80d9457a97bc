// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/primitives.h"

#include <algorithm>

namespace mesecina {

const Values* Primitive_set::find_values(std::string_view name) const {
  const auto it = std::ranges::find(values, name, &Values::name);
  return it == values.end() ? nullptr : &*it;
}

Box Primitive_set::bounding_box() const {
  Box box;
  for (const Point_3& p : vertices) box.add(p);
  const auto add_ball = [&](const Point_3& c, double r) {
    const double rz = dimension == 3 ? r : 0;
    box.add(Point_3{c.x - r, c.y - r, c.z - rz});
    box.add(Point_3{c.x + r, c.y + r, c.z + rz});
  };
  for (const Ball& ball : balls) add_ball(vertices[ball.center], ball.radius);
  for (const Arc& arc : arcs) box.add(mesecina::bounding_box(*this, arc));
  if (image) {
    box.add(image->lower_left);
    box.add(Point_2{image->lower_left.x + image->width * image->pixel_size,
                    image->lower_left.y + image->height * image->pixel_size});
  }
  return box;
}

Box bounding_box(const Primitive_set& set, const Arc& arc) {
  Box box;
  box.add(set.vertices[arc.from]);
  box.add(set.vertices[arc.to]);
  const auto from_center = [&](int vertex) {
    return Point_2{set.vertices[vertex].x - arc.center.x, set.vertices[vertex].y - arc.center.y};
  };
  const auto cross = [](const Point_2& p, const Point_2& q) { return p.x * q.y - p.y * q.x; };
  const Point_2 start = from_center(arc.counterclockwise ? arc.from : arc.to);
  const Point_2 end = from_center(arc.counterclockwise ? arc.to : arc.from);
  const double turn = cross(start, end);
  const bool is_whole = arc.from == arc.to;
  if (!is_whole && turn == 0 && start.x * end.x + start.y * end.y >= 0) return box;
  for (const Point_2& direction : {Point_2{1, 0}, Point_2{0, 1}, Point_2{-1, 0}, Point_2{0, -1}}) {
    const bool is_passed = is_whole || (turn >= 0 ? cross(start, direction) >= 0 && cross(direction, end) >= 0
                                                  : cross(end, direction) <= 0 || cross(direction, start) <= 0);
    if (is_passed) box.add(Point_2{arc.center.x + arc.radius * direction.x, arc.center.y + arc.radius * direction.y});
  }
  return box;
}

Primitive_set select(const Primitive_set& set, const std::vector<bool>& keep) {
  Primitive_set result;
  result.dimension = set.dimension;
  result.image = set.image;
  result.is_complex = set.is_complex;

  std::vector<bool> used(set.vertices.size(), false);
  std::size_t element = 0;
  const auto each = [&](std::size_t count, auto&& use) {
    for (std::size_t i = 0; i < count; ++i, ++element)
      if (keep[element]) use(i);
  };
  each(set.points.size(), [&](std::size_t i) { used[set.points[i]] = true; });
  each(set.segments.size(), [&](std::size_t i) {
    for (int v : set.segments[i]) used[v] = true;
  });
  each(set.rays.size(), [&](std::size_t i) { used[set.rays[i].from] = true; });
  each(set.arcs.size(), [&](std::size_t i) { used[set.arcs[i].from] = used[set.arcs[i].to] = true; });
  each(set.triangles.size(), [&](std::size_t i) {
    for (int v : set.triangles[i]) used[v] = true;
  });
  each(set.polygon_count(), [&](std::size_t i) {
    for (int v : set.polygon(i)) used[v] = true;
  });
  each(set.balls.size(), [&](std::size_t i) { used[set.balls[i].center] = true; });

  std::vector<int> renamed(set.vertices.size(), -1);
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    renamed[v] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(set.vertices[v]);
    if (!set.radii.empty()) result.radii.push_back(set.radii[v]);
  }

  element = 0;
  each(set.points.size(), [&](std::size_t i) { result.points.push_back(renamed[set.points[i]]); });
  each(set.segments.size(), [&](std::size_t i) {
    result.segments.push_back({renamed[set.segments[i][0]], renamed[set.segments[i][1]]});
  });
  each(set.rays.size(), [&](std::size_t i) {
    result.rays.push_back({renamed[set.rays[i].from], set.rays[i].direction});
  });
  each(set.arcs.size(), [&](std::size_t i) {
    Arc arc = set.arcs[i];
    arc.from = renamed[arc.from];
    arc.to = renamed[arc.to];
    result.arcs.push_back(arc);
  });
  each(set.triangles.size(), [&](std::size_t i) {
    const auto& t = set.triangles[i];
    result.triangles.push_back({renamed[t[0]], renamed[t[1]], renamed[t[2]]});
  });
  each(set.polygon_count(), [&](std::size_t i) {
    if (result.polygon_offsets.empty()) result.polygon_offsets.push_back(0);
    for (int v : set.polygon(i)) result.polygon_vertices.push_back(renamed[v]);
    result.polygon_offsets.push_back(static_cast<int>(result.polygon_vertices.size()));
  });
  each(set.balls.size(), [&](std::size_t i) {
    result.balls.push_back({renamed[set.balls[i].center], set.balls[i].radius});
  });

  for (const Values& values : set.values) {
    Values kept{values.name, values.unit, {}};
    for (std::size_t i = 0; i < values.data.size(); ++i)
      if (keep[i]) kept.data.push_back(values.data[i]);
    result.values.push_back(std::move(kept));
  }
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) result.ids.push_back(set.id(i));
  return result;
}

Primitive_set apply_cut(const Primitive_set& set, const Cut& cut) {
  const Values* values = set.find_values(cut.value);
  if (!values) return set;
  std::vector<bool> keep(values->data.size());
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = values->data[i] >= cut.minimum;
  return select(set, keep);
}

}  // namespace mesecina
