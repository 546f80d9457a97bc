// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_parts_3/module.h"

#include <utility>

#include "core/graph.h"
#include "geometries/delaunay_3/module.h"
#include "geometries/delaunay_parts_3/delaunay_parts_3.h"
#include "geometries/primitives_3.h"

namespace mesecina {

namespace {

Primitive_set hull_layer(Context& context) {
  const auto triangulation = context.get(delaunay_3_key);
  Primitive_set set = primitives_in_space();
  set.vertices = triangulation->points;
  set.triangles = hull_triangles(*triangulation);
  set.is_complex = true;
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set gabriel_layer(Context& context) {
  const auto triangulation = context.get(delaunay_3_key);
  Gabriel_complex_3 complex = gabriel_complex(*triangulation, context.progress());
  Primitive_set set = primitives_in_space();
  set.vertices = triangulation->points;
  set.segments = std::move(complex.edges);
  set.triangles = std::move(complex.triangles);
  set.is_complex = true;
  Values radius{"radius", "units of the input", {}};
  radius.data.reserve(set.element_count());
  const auto& points = set.vertices;
  for (const auto& [a, b] : set.segments) radius.data.push_back(distance(points[a], points[b]) / 2);
  for (const auto& [a, b, c] : set.triangles) radius.data.push_back(circle_radius(points[a], points[b], points[c]));
  set.values.push_back(std::move(radius));
  return select(set, std::vector<bool>(set.element_count(), true));
}

}  // namespace

void register_delaunay_parts_3(Registry& registry) {
  registry.begin_module({"delaunay-parts-3", "Parts of the Delaunay triangulation",
                         "Simplices of the Delaunay triangulation that are something of their own."});
  const char* stage = "Diagram";
  Layer_spec hull =
      make_layer("convex-hull", "Convex hull", stage,
                 "The boundary of the smallest convex set around the samples: the Delaunay triangles with a "
                 "tetrahedron on one side only, with their normals outward. [CGAL, 3D Triangulations]",
                 {190, 165, 135}, hull_layer);
  hull.style.opacity = 0.4;
  registry.add_layer(std::move(hull));
  registry.add_layer(
      make_layer("gabriel-complex", "Gabriel complex", stage,
                 "The Delaunay edges and triangles whose smallest circumscribed ball has no sample inside, with the "
                 "radius of that ball; the edges of these triangles belong to it. [K. R. Gabriel, R. R. Sokal: A new "
                 "statistical approach to geographic variation analysis, 1969]",
                 {105, 140, 150}, gabriel_layer));
}

}  // namespace mesecina
