// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/module.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "core/graph.h"
#include "geometries/primitives_3.h"
#include "geometries/samples_3/module.h"
#include "geometries/union_3/describe_simplex_3.h"
#include "geometries/union_3/power_diagram_3.h"

namespace mesecina {

namespace {

std::vector<Point_3> centers_of(const std::vector<Ball_3>& balls) {
  std::vector<Point_3> centers;
  centers.reserve(balls.size());
  for (const Ball_3& ball : balls) centers.push_back(ball.center);
  return centers;
}

/// Which simplices of the dual complex a layer has.
struct Wanted {
  bool (*triangle)(Simplex_kind_3);
  bool (*edge)(Simplex_kind_3);
  bool (*vertex)(Simplex_kind_3);
};

Primitive_set dual_primitives(const Dual_3& dual, const Wanted& wanted) {
  Primitive_set set = primitives_in_space();
  set.vertices = centers_of(dual.regular->balls);
  for (std::size_t v = 0; v < dual.vertices.size(); ++v)
    if (wanted.vertex(dual.vertices[v])) set.points.push_back(static_cast<int>(v));
  for (const Dual_3::Edge& edge : dual.edges)
    if (wanted.edge(edge.kind)) set.segments.push_back(edge.balls);
  for (const Dual_3::Triangle& triangle : dual.triangles)
    if (wanted.triangle(triangle.kind)) set.triangles.push_back(triangle.balls);
  return select(set, std::vector<bool>(set.element_count(), true));
}

/// Of an element of dual_primitives. O(n).
Element_description describe_in_dual(Context& context, const Wanted& wanted, std::size_t element) {
  const auto dual = context.get(dual_3_key);
  const auto described = [&](std::span<const int> balls, Simplex_kind_3 kind) {
    Element_description description = describe_simplex(*dual->regular, balls);
    description.facts.push_back({"in the dual complex", kind_in_words(kind)});
    return description;
  };
  std::size_t left = element;
  for (std::size_t v = 0; v < dual->vertices.size(); ++v)
    if (wanted.vertex(dual->vertices[v]) && left-- == 0)
      return described(std::array{static_cast<int>(v)}, dual->vertices[v]);
  for (const Dual_3::Edge& edge : dual->edges)
    if (wanted.edge(edge.kind) && left-- == 0) return described(edge.balls, edge.kind);
  for (const Dual_3::Triangle& triangle : dual->triangles)
    if (wanted.triangle(triangle.kind) && left-- == 0) return described(triangle.balls, triangle.kind);
  return {};
}

bool none(Simplex_kind_3) { return false; }
bool any(Simplex_kind_3 kind) { return kind != Simplex_kind_3::outside; }
bool is_singular(Simplex_kind_3 kind) { return kind == Simplex_kind_3::singular; }
bool is_regular(Simplex_kind_3 kind) { return kind == Simplex_kind_3::regular; }

Primitive_set regular_layer(Context& context) {
  const auto regular = context.get(regular_3_key);
  Primitive_set set = primitives_in_space();
  set.vertices = centers_of(regular->balls);
  set.segments = *context.get(regular_edges_3_key);
  for (std::size_t b = 0; b < regular->cell_of_ball.size(); ++b)
    if (regular->cell_of_ball[b] >= 0) set.points.push_back(static_cast<int>(b));
  return select(set, std::vector<bool>(set.element_count(), true));
}

/// Of an element of regular_layer. O(n).
Element_description describe_in_regular(Context& context, std::size_t element) {
  const auto regular = context.get(regular_3_key);
  std::size_t left = element;
  for (std::size_t b = 0; b < regular->cell_of_ball.size(); ++b)
    if (regular->cell_of_ball[b] >= 0 && left-- == 0)
      return describe_simplex(*regular, std::array{static_cast<int>(b)});
  const auto edges = context.get(regular_edges_3_key);
  return left < edges->size() ? describe_simplex(*regular, (*edges)[left]) : Element_description();
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
                 ": parts of it are thinner than the samples can carry. Choose a smaller {delta}.");
  return dual;
}

void add_dual_layer(Registry& registry, const char* id, const char* label, const char* help, Color color,
                    const Wanted& wanted, bool is_whole = false) {
  Layer_spec layer = make_layer(id, label, "Dual complex", help, color, [wanted, is_whole](Context& context) {
    const auto dual = context.get(dual_3_key);
    Primitive_set set = dual_primitives(*dual, wanted);
    set.is_complex = is_whole;
    if (is_whole) set.known_topology = topology(*dual);
    return set;
  });
  layer.describe = [wanted](Context& context, std::size_t element) {
    return describe_in_dual(context, wanted, element);
  };
  registry.add_layer(std::move(layer));
}

void add_dual_layers(Registry& registry) {
  add_dual_layer(
      registry, "dual", "Dual complex",
      "The simplices of the regular triangulation whose power faces meet the union; it has the homotopy type of the "
      "union. Its tetrahedra are not drawn, but count. [H. Edelsbrunner: The union of balls and its dual shape, 1995]",
      {110, 90, 160}, {any, any, any}, true);
  add_dual_layer(registry, "dual-faces", "Dual: tetrahedra",
                 "The boundary of the tetrahedra of the dual complex: triangles with one on one side.", {150, 130, 200},
                 {is_regular, none, none});
  add_dual_layer(registry, "dual-triangles", "Dual: triangles", "All triangles of the dual complex.", {150, 130, 200},
                 {any, none, none});
  add_dual_layer(registry, "dual-edges", "Dual: edges", "All edges of the dual complex.", {110, 90, 160},
                 {none, any, none});
  add_dual_layer(registry, "dual-singular-triangles", "Dual: singular triangles",
                 "Triangles of the dual complex that no tetrahedron of it has.", {190, 110, 60},
                 {is_singular, none, none});
  add_dual_layer(registry, "dual-singular-edges", "Dual: singular edges",
                 "Edges of the dual complex that no triangle of it has.", {190, 60, 60}, {none, is_singular, none});
  add_dual_layer(registry, "dual-singular-vertices", "Dual: singular vertices",
                 "Balls that meet no other: vertices of the dual complex without edges.", {120, 20, 20},
                 {none, none, is_singular});
}

}  // namespace

void warn_of_special_positions(Context& context, const Medial_complex_3& axis, const Dual_3& dual) {
  if (has_topology_of_union(axis, dual, context.progress())) return;
  context.warn(
      "The medial axis has not the topology of the union: more than three spheres meet in points within rounding. To "
      "mend that, let balls be moved a little: " +
      std::string(context.input(balls_input) && !are_balls_of_mesh(context)
                      ? "set {given-perturbation} to 1e-6, or to 1e-4 for balls that come from samples."
                      : "set perturbation to more than it is."));
}

void register_union_3(Registry& registry) {
  registry.begin_module({"union-3", "Union of balls", "Structures of the union of the balls."});
  registry.add_structure<Regular_3>(regular_3_key, compute_regular);
  registry.add_structure<std::vector<std::array<int, 2>>>(
      regular_edges_3_key, [](Context& context) { return edges_of(*context.get(regular_3_key)); });
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
  Layer_spec regular = make_layer("regular-triangulation", "Regular triangulation", "Power diagram",
                                  "The dual of the power diagram of the balls. [F. Aurenhammer: Power diagrams, 1987]",
                                  {120, 120, 130}, regular_layer);
  regular.describe = describe_in_regular;
  registry.add_layer(std::move(regular));
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
