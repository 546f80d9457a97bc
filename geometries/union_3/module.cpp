// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/module.h"

#include <algorithm>
#include <utility>

#include "core/graph.h"
#include "geometries/primitives_3.h"
#include "geometries/samples_3/module.h"
#include "geometries/union_3/power_diagram_3.h"

namespace mesecina {

namespace {

std::vector<Point_3> centers_of(const std::vector<Ball_3>& balls) {
  std::vector<Point_3> centers;
  centers.reserve(balls.size());
  for (const Ball_3& ball : balls) centers.push_back(ball.center);
  return centers;
}

/// The simplices of the dual complex that are wanted.
template <class Wants_triangle, class Wants_edge, class Wants_vertex>
Primitive_set dual_primitives(const Dual_3& dual, const Wants_triangle& wants_triangle, const Wants_edge& wants_edge,
                              const Wants_vertex& wants_vertex) {
  Primitive_set set = primitives_in_space();
  set.vertices = centers_of(dual.regular->balls);
  for (std::size_t v = 0; v < dual.vertices.size(); ++v)
    if (wants_vertex(dual.vertices[v])) set.points.push_back(static_cast<int>(v));
  for (const Dual_3::Edge& edge : dual.edges)
    if (wants_edge(edge.kind)) set.segments.push_back(edge.balls);
  for (const Dual_3::Triangle& triangle : dual.triangles)
    if (wants_triangle(triangle.kind)) set.triangles.push_back(triangle.balls);
  return select(set, std::vector<bool>(set.element_count(), true));
}

bool none(Simplex_kind_3) { return false; }
bool any(Simplex_kind_3 kind) { return kind != Simplex_kind_3::outside; }
bool is_singular(Simplex_kind_3 kind) { return kind == Simplex_kind_3::singular; }
bool is_regular(Simplex_kind_3 kind) { return kind == Simplex_kind_3::regular; }

Primitive_set regular_layer(Context& context) {
  const auto regular = context.get(regular_3_key);
  Primitive_set set = primitives_in_space();
  set.vertices = centers_of(regular->balls);
  set.segments = edges_of(*regular);
  for (std::size_t b = 0; b < regular->cell_of_ball.size(); ++b)
    if (regular->cell_of_ball[b] >= 0) set.points.push_back(static_cast<int>(b));
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set power_layer(Context& context) {
  const auto dual = context.get(dual_3_key);
  Power_faces_3 faces = bounded_power_faces(*dual->regular, context.progress());
  if (faces.size() == 0) throw Unavailable("all faces of the power diagram are unbounded: no ball lies between others");
  std::vector<std::array<int, 2>> met;
  met.reserve(dual->edges.size());
  for (const Dual_3::Edge& edge : dual->edges)
    met.push_back({std::min(edge.balls[0], edge.balls[1]), std::max(edge.balls[0], edge.balls[1])});
  std::ranges::sort(met);
  Values meets{"meets-union", "", {}};
  for (const auto& [a, b] : faces.balls)
    meets.data.push_back(std::ranges::binary_search(met, std::array{std::min(a, b), std::max(a, b)}) ? 1 : 0);
  Primitive_set set = primitives_in_space();
  set.vertices = std::move(faces.vertices);
  set.polygon_offsets = std::move(faces.offsets);
  set.polygon_vertices = std::move(faces.corners);
  set.values.push_back(std::move(meets));
  set.is_complex = true;
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set union_vertex_layer(Context& context) {
  const auto vertices = context.get(union_vertices_3_key);
  Primitive_set set = point_primitives(vertices->points);
  Values balls{"balls", "", {}};
  for (std::size_t v = 0; v < vertices->points.size(); ++v)
    balls.data.push_back(static_cast<double>(vertices->balls_of(static_cast<int>(v)).size()));
  const std::vector<std::uint8_t> singular = have_singular_triangles(*vertices);
  set.values = {std::move(balls), {"singular", "", std::vector<double>(singular.begin(), singular.end())}};
  return set;
}

std::string betti_text(const Topology& topology) {
  const auto& b = topology.betti;
  return std::to_string(b[0]) + " components, " + std::to_string(b[1]) + " tunnels, " + std::to_string(b[2]) +
         " cavities";
}

Regular_3 compute_regular(Context& context) {
  if (are_balls_of_mesh(context)) return *context.get(ball_approximation_3_key)->regular;
  return regular_triangulation(*context.get(balls_3_key), context.progress());
}

Dual_3 compute_dual(Context& context) {
  if (!are_balls_of_mesh(context)) return dual_complex(context.get(regular_3_key), context.progress());
  Dual_3 dual = *context.get(ball_approximation_3_key)->dual;
  const auto solid = context.get(solid_3_key);
  if (const Topology found = topology(dual); solid->topology && solid->topology->betti != found.betti)
    context.warn("The union of balls has " + betti_text(found) + ", the solid " + betti_text(*solid->topology) +
                 ": parts of it are thinner than the samples can carry. Choose a smaller delta.");
  return dual;
}

void add_dual_layers(Registry& registry) {
  const char* stage = "Dual complex";
  registry.add_layer(make_layer(
      "dual", "Dual complex", stage,
      "The simplices of the regular triangulation whose power faces meet the union; it has the homotopy type of the "
      "union. Its tetrahedra are not drawn, but count. [H. Edelsbrunner: The union of balls and its dual shape, 1995]",
      {110, 90, 160}, [](Context& context) {
        const auto dual = context.get(dual_3_key);
        Primitive_set set = dual_primitives(*dual, any, any, any);
        set.is_complex = true;
        set.known_topology = topology(*dual);
        return set;
      }));
  registry.add_layer(
      make_layer("dual-faces", "Dual: tetrahedra", stage,
                 "The boundary of the tetrahedra of the dual complex: triangles with one on one side.", {150, 130, 200},
                 [](Context& context) { return dual_primitives(*context.get(dual_3_key), is_regular, none, none); }));
  registry.add_layer(
      make_layer("dual-triangles", "Dual: triangles", stage, "All triangles of the dual complex.", {150, 130, 200},
                 [](Context& context) { return dual_primitives(*context.get(dual_3_key), any, none, none); }));
  registry.add_layer(
      make_layer("dual-edges", "Dual: edges", stage, "All edges of the dual complex.", {110, 90, 160},
                 [](Context& context) { return dual_primitives(*context.get(dual_3_key), none, any, none); }));
  registry.add_layer(
      make_layer("dual-singular-triangles", "Dual: singular triangles", stage,
                 "Triangles of the dual complex that no tetrahedron of it has.", {190, 110, 60},
                 [](Context& context) { return dual_primitives(*context.get(dual_3_key), is_singular, none, none); }));
  registry.add_layer(
      make_layer("dual-singular-edges", "Dual: singular edges", stage,
                 "Edges of the dual complex that no triangle of it has.", {190, 60, 60},
                 [](Context& context) { return dual_primitives(*context.get(dual_3_key), none, is_singular, none); }));
  registry.add_layer(
      make_layer("dual-singular-vertices", "Dual: singular vertices", stage,
                 "Balls that meet no other: vertices of the dual complex without edges.", {120, 20, 20},
                 [](Context& context) { return dual_primitives(*context.get(dual_3_key), none, none, is_singular); }));
}

}  // namespace

void warn_of_special_positions(Context& context, const Medial_complex_3& axis, const Dual_3& dual) {
  if (has_topology_of_union(axis, dual)) return;
  context.warn(
      "The medial axis has not the topology of the union: more than three spheres meet in points within rounding. To "
      "mend that, let balls be moved a little: " +
      std::string(context.input(balls_input)
                      ? "set given-perturbation to 1e-6, or to 1e-4 for balls that come from samples."
                      : "set perturbation to more than it is."));
}

void register_union_3(Registry& registry) {
  registry.begin_module({"union-3", "Union of balls", "Structures of the union of the balls."});
  registry.add_structure<Regular_3>(regular_3_key, compute_regular);
  registry.add_structure<Dual_3>(dual_3_key, compute_dual);
  registry.add_structure<Union_vertices_3>(union_vertices_3_key, [](Context& context) {
    return union_vertices(context.get(dual_3_key), context.progress());
  });
  registry.add_structure<Medial_complex_3>(medial_axis_3_key, [](Context& context) {
    const auto vertices = context.get(union_vertices_3_key);
    Medial_complex_3 axis = union_medial_axis(*vertices, context.progress());
    warn_of_special_positions(context, axis, *vertices->dual);
    return axis;
  });
  registry.add_layer(make_layer("regular-triangulation", "Regular triangulation", "Power diagram",
                                "The dual of the power diagram of the balls. [F. Aurenhammer: Power diagrams, 1987]",
                                {120, 120, 130}, regular_layer));
  Layer_spec power = make_layer("power-diagram", "Power diagram", "Power diagram",
                                "Where two balls are nearest in the power distance, the squared distance of the center "
                                "less the squared radius: the bounded faces. Their value is 1 where a face meets the "
                                "union of the balls, 0 where it does not. [F. Aurenhammer: Power diagrams, 1987]",
                                {150, 160, 200}, power_layer);
  power.style.opacity = 0.4;
  registry.add_layer(std::move(power));
  add_dual_layers(registry);
  registry.add_layer(make_layer(
      "union-vertices", "Vertices of the union", "Union of balls",
      "V(U): where three spheres meet on the boundary of the union. Values are how many balls have the vertex on their "
      "sphere, and whether three of these balls make a singular triangle of the dual complex (1), so that their "
      "spheres meet in two vertices, or not (0). [N. Amenta, R. Kolluri: The medial axis of a union of balls, 2001]",
      {180, 40, 40}, union_vertex_layer));
}

}  // namespace mesecina
