// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/internals_3/module.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/power_crust_3/module.h"
#include "geometries/primitives_3.h"
#include "geometries/union_3/module.h"
#include "geometries/union_3/power_diagram_3.h"

namespace mesecina {

namespace {

Primitive_set polar_layer(Context& context) {
  const auto polar = context.get(polar_balls_3_key);
  Primitive_set set = primitives_in_space();
  Values inner{"inner-poles", "", {}};
  for (const Ball_3& ball : polar->regular->balls) set.vertices.push_back(ball.center);
  for (const auto& edge : edges_of(*polar->regular)) {
    if (polar->poles->is_infinite(edge[0]) || polar->poles->is_infinite(edge[1])) continue;
    set.segments.push_back(edge);
    inner.data.push_back(polar->is_inner[edge[0]] + polar->is_inner[edge[1]]);
  }
  set.values.push_back(std::move(inner));
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set origin_layer(Context& context) {
  const auto vertices = context.get(union_vertices_3_key);
  const auto& balls = vertices->dual->regular->balls;
  Primitive_set set = primitives_in_space();
  set.vertices = vertices->points;
  for (const Ball_3& ball : balls) set.vertices.push_back(ball.center);
  Values number{"ball", "", {}};
  const int first_center = static_cast<int>(vertices->points.size());
  for (int v = 0; v < first_center; ++v) {
    for (const int ball : vertices->balls_of(v)) {
      set.segments.push_back({v, first_center + ball});
      set.ids.push_back(v);
      number.data.push_back(ball);
    }
  }
  set.values.push_back(std::move(number));
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set vertex_delaunay_layer(Context& context) {
  const auto voronoi = context.get(vertex_voronoi_3_key);
  Primitive_set set = primitives_in_space();
  set.vertices = voronoi->points;
  for (std::size_t c = 0; c < voronoi->cells.size(); ++c) {
    if (voronoi->is_inner[c] == 0) continue;
    const auto& corners = voronoi->cells[c];
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j)
        if (std::min(corners[i], corners[j]) >= 0)
          set.segments.push_back({std::min(corners[i], corners[j]), std::max(corners[i], corners[j])});
  }
  std::ranges::sort(set.segments);
  set.segments.erase(std::unique(set.segments.begin(), set.segments.end()), set.segments.end());
  Values common{"common-balls", "", {}};
  for (const auto& edge : set.segments) {
    int count = 0;
    voronoi->for_common_balls(edge, [&](int) { ++count; });
    common.data.push_back(count);
  }
  set.values.push_back(std::move(common));
  return select(set, std::vector<bool>(set.element_count(), true));
}

/// Cells that are the center of one ball are one point.
Primitive_set inner_vertex_layer(Context& context) {
  const auto voronoi = context.get(vertex_voronoi_3_key);
  const auto dual = context.get(dual_3_key);
  const auto& balls = dual->regular->balls;
  std::vector<bool> is_shown(balls.size(), false);
  std::vector<Point_3> points;
  Values number{"ball", "", {}};
  Values radius{"radius", "units of the input", {}};
  for (std::size_t c = 0; c < voronoi->cells.size(); ++c) {
    if (voronoi->is_inner[c] == 0) continue;
    const int ball = voronoi->ball_of_cell[c];
    if (ball < 0) {
      points.push_back(voronoi->centers[c]);
      radius.data.push_back(distance(voronoi->centers[c], voronoi->points[voronoi->cells[c][0]]));
    } else {
      if (is_shown[ball]) continue;
      is_shown[ball] = true;
      points.push_back(balls[ball].center);
      radius.data.push_back(balls[ball].radius);
    }
    number.data.push_back(ball);
  }
  Primitive_set set = point_primitives(std::move(points));
  set.radii = radius.data;
  set.values = {std::move(number), std::move(radius)};
  return set;
}

void add_layer(Registry& registry, const char* id, const char* label, const std::string& help, Color color,
               Primitive_set (*build)(Context&)) {
  Layer_spec layer = make_layer(id, label, "Internals", help.c_str(), color, build);
  layer.style.line_width = 1;
  layer.style.point_size = 4;
  registry.add_layer(std::move(layer));
}

}  // namespace

void register_internals_3(Registry& registry) {
  registry.begin_module(
      {"internals-3", "Internals", "What lies between the structures, to see how one follows from the other."});
  registry.add_structure<Vertex_voronoi_3>(vertex_voronoi_3_key, [](Context& context) {
    return vertex_voronoi(*context.get(union_vertices_3_key), context.progress());
  });
  add_layer(registry, "polar-triangulation", "Polar triangulation",
            "The edges of the regular triangulation of the polar balls, without poles at infinity. Their value is how "
            "many of their ends are inner poles: across those with one runs the power crust. [N. Amenta, S. Choi, R. "
            "Kolluri: The power crust, unions of balls, and the medial axis transform, 2001]",
            {170, 150, 180}, polar_layer);
  const std::string paper = " [N. Amenta, R. Kolluri: The medial axis of a union of balls, 2001]";
  add_layer(registry, "union-vertices-origin", "Origins of the union's vertices",
            "Joins every vertex of the union to the centers of the balls whose spheres meet in it. The id of a segment "
            "is the vertex, its value the ball." +
                paper,
            {205, 150, 165}, origin_layer);
  add_layer(registry, "union-vertices-delaunay", "Delaunay of the union's vertices",
            "The edges of the Delaunay tetrahedra of V(U) whose Voronoi vertex lies in the dual complex: those dual to "
            "the medial axis. Their value is how many balls have both ends on their sphere." +
                paper,
            {180, 165, 135}, vertex_delaunay_layer);
  add_layer(registry, "union-voronoi-interior", "Interior Voronoi vertices",
            "The Voronoi vertices of V(U) that lie in the dual complex: vertices of the medial axis. Where all nearest "
            "vertices of the union are on one ball's sphere it is the center of that ball, whose number is the value; "
            "elsewhere this is -1. The radius is the distance of the nearest vertices." +
                paper,
            {60, 140, 80}, inner_vertex_layer);
}

}  // namespace mesecina
