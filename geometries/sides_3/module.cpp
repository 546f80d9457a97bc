// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/sides_3/module.h"

#include <utility>

#include "core/graph.h"
#include "geometries/delaunay_3/module.h"
#include "geometries/delaunay_parts_3/delaunay_parts_3.h"
#include "geometries/power_crust_3/module.h"
#include "geometries/primitives_3.h"
#include "geometries/samples_3/module.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

namespace {

constexpr const char* nothing_inside =
    "no Voronoi vertex lies inside of the shape: the samples are too few (choose a smaller {delta}), or enclose "
    "nothing";

Voronoi_sides_3 compute_sides(Context& context) {
  const auto triangulation = context.get(delaunay_3_key);
  if (context.input(mesh_input)) return sides_of_solid(*triangulation, *context.get(solid_3_key), context.progress());
  return sides_of_power_crust(*triangulation, *context.get(polar_balls_3_key), context.progress());
}

Primitive_set vertex_layer(Context& context, bool inner) {
  const auto triangulation = context.get(delaunay_3_key);
  const auto sides = context.get(voronoi_sides_3_key);
  Primitive_set set = primitives_in_space();
  Values radius{"radius", "units of the input", {}};
  for (std::size_t c = 0; c < triangulation->cells.size(); ++c) {
    if (sides->vertex_of_cell[c] != static_cast<int>(c) || (sides->is_inner[c] != 0) != inner) continue;
    set.points.push_back(static_cast<int>(set.vertices.size()));
    set.vertices.push_back(triangulation->circumcenters[c]);
    radius.data.push_back(triangulation->circumradii[c]);
    set.ids.push_back(static_cast<std::int64_t>(c));
  }
  if (inner && set.is_empty()) throw Unavailable(nothing_inside);
  set.radii = radius.data;
  set.values.push_back(std::move(radius));
  return set;
}

Primitive_set cell_layer(Context& context) {
  const auto triangulation = context.get(delaunay_3_key);
  Primitive_set set = primitives_in_space();
  set.vertices = triangulation->points;
  set.triangles = boundary_of_inner_cells(*triangulation, *context.get(voronoi_sides_3_key));
  if (set.is_empty()) throw Unavailable(nothing_inside);
  set.is_complex = true;
  Values radius{"radius", "units of the input", {}};
  for (const auto& [a, b, c] : set.triangles)
    radius.data.push_back(circle_radius(set.vertices[a], set.vertices[b], set.vertices[c]));
  set.values.push_back(std::move(radius));
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set face_layer(Context& context) {
  const auto triangulation = context.get(delaunay_3_key);
  Voronoi_faces_3 faces = inner_voronoi_faces(*triangulation, *context.get(voronoi_sides_3_key), context.progress());
  if (faces.size() == 0) throw Unavailable(nothing_inside);
  Medial_complex_3 axis;
  axis.centers = triangulation->circumcenters;
  axis.face_offsets = std::move(faces.offsets);
  axis.face_vertices = std::move(faces.vertices);
  for (const auto& [a, b] : faces.sites) axis.contacts.push_back({triangulation->points[a], triangulation->points[b]});
  Primitive_set set = primitives_in_space();
  set.values.push_back({"angle", "degrees", angle_of_faces(axis, context.progress())});
  set.values.push_back({"lambda", "units of the input", lambda_of_faces(axis)});
  set.vertices = std::move(axis.centers);
  set.radii = triangulation->circumradii;
  set.polygon_offsets = std::move(axis.face_offsets);
  set.polygon_vertices = std::move(axis.face_vertices);
  set.is_complex = true;
  return select(set, std::vector<bool>(set.element_count(), true));
}

}  // namespace

void register_sides_3(Registry& registry) {
  registry.begin_module({"sides-3", "Inside and outside",
                         "Which Voronoi vertices of the samples lie inside of the shape: by the solid where there is a "
                         "mesh, else by the power crust."});
  registry.add_structure<Voronoi_sides_3>(voronoi_sides_3_key, compute_sides);
  const char* stage = "Inside and outside";
  Layer_spec outer = make_layer("outer-voronoi-vertices", "Outer Voronoi vertices", stage,
                                "The Voronoi vertices outside of the shape (of points: outside of their power crust), "
                                "with the distance of the samples nearest to them. They can be very far away.",
                                {85, 150, 175}, [](Context& context) { return vertex_layer(context, false); });
  Layer_spec inner =
      make_layer("inner-voronoi-vertices", "Inner Voronoi vertices", stage,
                 "The Voronoi vertices inside of the shape (of points: inside of their power crust), with the distance "
                 "of the samples nearest to them: the balls of that radius hold no sample and fill the shape. [N. "
                 "Amenta, M. Bern: Surface reconstruction by Voronoi filtering, 1999]",
                 {220, 130, 70}, [](Context& context) { return vertex_layer(context, true); });
  for (Layer_spec* layer : {&outer, &inner}) {
    layer->style.point_size = 4;
    registry.add_layer(std::move(*layer));
  }
  registry.add_layer(make_layer(
      "inner-delaunay", "Inner Delaunay tetrahedra", stage,
      "The boundary of the Delaunay tetrahedra whose Voronoi vertex lies inside of the shape, with normals outward: "
      "triangles between samples, with the radius of the circle through their corners. Of dense samples it is near the "
      "surface. [T. K. Dey, S. Goswami: Tight Cocone, a water-tight surface reconstructor, 2003]",
      {120, 150, 110}, cell_layer));
  registry.add_layer(make_layer(
      "inner-voronoi", "Inner Voronoi faces", stage,
      "The Voronoi faces whose vertices all lie inside of the shape, with the angle under which their two nearest "
      "samples are seen, at its largest on the face, and lambda, half the distance of these samples. Faces of large "
      "angle approximate the medial axis; those of small angle reach to the surface. [T. K. Dey, W. Zhao: "
      "Approximating the medial axis from the Voronoi diagram with a convergence guarantee, 2004]",
      {75, 125, 165}, face_layer));
}

}  // namespace mesecina
