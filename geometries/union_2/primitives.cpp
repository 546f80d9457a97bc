// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "geometries/balls_2/module.h"
#include "geometries/primitives_2.h"
#include "geometries/union_2/module.h"

namespace mesecina {

Primitive_set boundary_primitives(const Union_boundary_2& boundary) {
  const Balls_2& balls = *boundary.dual->regular->balls;
  Primitive_set set;
  set.is_complex = true;
  set.vertices = lifted(boundary.vertices);
  std::vector<std::int64_t> arc_ids;
  for (const Boundary_arc& arc : boundary.arcs) {
    const Point_2& center = balls.centers[arc.ball];
    const double radius = boundary.radii[arc.ball];
    int from = arc.from;
    if (from < 0) {
      from = static_cast<int>(set.vertices.size());
      set.vertices.push_back(lifted(Point_2{center.x + radius, center.y}));
      if (radius == 0) {
        set.points.push_back(from);
        set.ids.push_back(arc.ball);
        continue;
      }
    }
    set.arcs.push_back({center, radius, from, arc.to < 0 ? from : arc.to, true});
    arc_ids.push_back(arc.ball);
  }
  set.ids.insert(set.ids.end(), arc_ids.begin(), arc_ids.end());
  return set;
}

Element_description describe_boundary_element(const Union_boundary_2& boundary, std::size_t element) {
  const Primitive_set set = boundary_primitives(boundary);
  if (element >= set.element_count()) return {};
  return describe_ball(*boundary.dual->regular->balls, static_cast<std::size_t>(set.id(element)));
}

namespace {

struct Axis_elements {
  std::vector<int> isolated;  ///< medial disks
  std::vector<int> edges;
};

Axis_elements axis_elements(const Union_medial_axis_2& axis, bool complete_only) {
  Axis_elements elements;
  std::vector<bool> has_edge(axis.centers.size(), false);
  // The far end of an incomplete edge goes with it.
  std::vector<bool> is_left_out(axis.centers.size(), false);
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    if (complete_only && axis.kinds[e] == Axis_edge_kind::incomplete) {
      is_left_out[axis.edges[e][1]] = true;
      continue;
    }
    elements.edges.push_back(static_cast<int>(e));
    for (const int ball : axis.edges[e]) has_edge[ball] = true;
  }
  for (std::size_t b = 0; b < has_edge.size(); ++b)
    if (!has_edge[b] && !is_left_out[b]) elements.isolated.push_back(static_cast<int>(b));
  return elements;
}

}  // namespace

Primitive_set union_axis_primitives(const Union_medial_axis_2& axis, bool complete_only) {
  const Axis_elements elements = axis_elements(axis, complete_only);
  const std::vector<double> lambda_of_edge = lambda_of_edges(axis);
  const std::vector<double> angle_of_edge = angle_of_edges(axis);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Primitive_set set;
  set.is_complex = true;
  set.vertices = lifted(axis.centers);
  set.points = elements.isolated;
  Values lambda{"lambda", "units of the input", {}};
  Values angle{"angle", "degrees", {}};
  lambda.data.assign(elements.isolated.size(), infinity);
  angle.data.assign(elements.isolated.size(), infinity);
  for (const int e : elements.edges) {
    set.segments.push_back(axis.edges[e]);
    lambda.data.push_back(lambda_of_edge[e]);
    angle.data.push_back(angle_of_edge[e]);
  }
  set.ids.assign(elements.isolated.begin(), elements.isolated.end());
  set.ids.insert(set.ids.end(), elements.edges.begin(), elements.edges.end());
  set.values.push_back(std::move(lambda));
  set.values.push_back(std::move(angle));
  return without_unused_vertices(set);
}

Element_description describe_union_axis_element(const Union_medial_axis_2& axis, bool complete_only,
                                                std::size_t element) {
  const Axis_elements elements = axis_elements(axis, complete_only);
  Element_description description;
  const auto add_medial_disk = [&](int ball) { add_disk(description.dual, axis.centers[ball], axis.radii[ball]); };
  if (element < elements.isolated.size()) {
    const int ball = elements.isolated[element];
    description.facts.push_back(fact("center", axis.centers[ball]));
    description.facts.push_back(fact("radius", axis.radii[ball]));
    if (axis.balls[ball] >= 0) description.facts.push_back({"is disk", std::to_string(axis.balls[ball])});
    add_medial_disk(ball);
    return description;
  }
  element -= elements.isolated.size();
  if (element >= elements.edges.size()) return description;
  const int e = elements.edges[element];
  const auto [a, b] = axis.edges[e];
  const char* kind = axis.kinds[e] == Axis_edge_kind::singular     ? "singular edge of the dual complex"
                     : axis.kinds[e] == Axis_edge_kind::incomplete ? "part of a Voronoi edge, ends at a center"
                                                                   : "Voronoi edge";
  description.facts.push_back({"kind", kind});
  description.facts.push_back({"contact vertices of the union", enumeration(axis.contacts[e])});
  description.facts.push_back(
      {"radii at the ends", format_number(axis.radii[a]) + " and " + format_number(axis.radii[b])});
  add_point(description.dual, axis.boundary->vertices[axis.contacts[e][0]]);
  add_point(description.dual, axis.boundary->vertices[axis.contacts[e][1]]);
  description.dual.segments.push_back({0, 1});
  add_medial_disk(a);
  add_medial_disk(b);
  return description;
}

}  // namespace mesecina
