// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/dual_2/module.h"

#include "core/graph.h"
#include "geometries/balls_2/module.h"
#include "geometries/primitives_2.h"
#include "geometries/regular_2/module.h"

namespace mesecina {

namespace {

void add_triangles(Primitive_set& set, const Dual_2& dual) {
  for (std::size_t t = 0; t < dual.has_triangle.size(); ++t)
    if (dual.has_triangle[t] != 0) set.triangles.push_back(dual.regular->triangles[t]);
}

void add_edges(Primitive_set& set, const Dual_2& dual, Dual_kind kind) {
  for (const Dual_edge& edge : dual.edges)
    if (edge.kind == kind) set.segments.push_back({edge.a, edge.b});
}

void add_singular_vertices(Primitive_set& set, const Dual_2& dual) {
  for (std::size_t b = 0; b < dual.vertices.size(); ++b)
    if (dual.vertices[b] == Dual_kind::singular) set.points.push_back(static_cast<int>(b));
}

Primitive_set centers_of(const Dual_2& dual) {
  Primitive_set set;
  set.vertices = lifted(dual.regular->balls->centers);
  set.is_complex = true;
  return set;
}

/// What an element of such a layer is made of: its disks.
Element_description describe_simplex(const Dual_2& dual, const Primitive_set& set, std::size_t element) {
  Element_description description;
  const Balls_2& balls = *dual.regular->balls;
  std::vector<int> corners;
  if (element < set.points.size()) {
    corners = {set.points[element]};
  } else if (element -= set.points.size(); element < set.segments.size()) {
    corners.assign(set.segments[element].begin(), set.segments[element].end());
  } else if (element -= set.segments.size(); element < set.triangles.size()) {
    corners.assign(set.triangles[element].begin(), set.triangles[element].end());
  }
  if (corners.empty()) return description;
  description.facts.push_back({corners.size() == 1 ? "disk" : "disks", enumeration(corners)});
  std::string radii;
  for (const int ball : corners) radii += (radii.empty() ? "" : ", ") + format_number(balls.radii[ball]);
  description.facts.push_back({corners.size() == 1 ? "radius" : "radii", radii});
  for (const int ball : corners) add_disk(description.dual, balls.centers[ball], balls.radii[ball]);
  return description;
}

struct Dual_layer {
  const char* id;
  const char* label;
  const char* help;
  Color color;
  double size;
  bool filled;
  void (*add)(Primitive_set&, const Dual_2&);
};

void add_dual_layer(Registry& registry, const Dual_layer& of) {
  Layer_spec layer;
  layer.id = of.id;
  layer.label = of.label;
  layer.stage = "Dual complex";
  layer.help = of.help;
  layer.style = look(of.color, of.size);
  layer.style.point_size = 7;
  layer.style.filled = of.filled;
  if (of.filled) layer.style.opacity = 0.5;
  layer.build = [add = of.add](Context& context) {
    const auto dual = context.get(dual_2_key);
    Primitive_set set = centers_of(*dual);
    add(set, *dual);
    return without_unused_vertices(set);
  };
  layer.describe = [add = of.add](Context& context, std::size_t element) {
    const auto dual = context.get(dual_2_key);
    Primitive_set set;
    add(set, *dual);
    return describe_simplex(*dual, set, element);
  };
  registry.add_layer(std::move(layer));
}

}  // namespace

void register_dual_2(Registry& registry) {
  registry.begin_module({"dual-2", "Dual complex", "The simplicial complex with the topology of the union of disks."});
  {
    Setting_spec setting;
    setting.id = alpha_setting.id;
    setting.label = "Alpha";
    setting.help =
        "Added to the squared radius of every disk before their union is taken. 0: the disks as they are; larger: they "
        "grow as in the alpha filtration; negative: they shrink, and vanish. [H. Edelsbrunner: The union of balls and "
        "its dual shape, 1995]";
    setting.unit = "squared units";
    setting.default_value = 0.0;
    setting.tags = {"union", "dual"};
    registry.add_setting(std::move(setting));
  }
  registry.add_structure<Dual_2>(dual_2_key, [](Context& context) {
    return dual_complex(context.get(regular_2_key), context.setting(alpha_setting), context.progress());
  });
  add_dual_layer(registry,
                 {"dual",
                  "Dual complex",
                  "The whole dual complex: triangles, singular edges and singular vertices. Its Betti numbers "
                  "are those of the union. [H. Edelsbrunner 1995]",
                  {70, 130, 180},
                  1.5,
                  true,
                  [](Primitive_set& set, const Dual_2& dual) {
                    add_singular_vertices(set, dual);
                    add_edges(set, dual, Dual_kind::singular);
                    add_triangles(set, dual);
                  }});
  add_dual_layer(registry, {"dual-faces",
                            "Dual faces",
                            "The triangles of the dual complex: three disks with a common point in the power cells of "
                            "all of them. [H. Edelsbrunner 1995]",
                            {100, 160, 205},
                            1,
                            true,
                            add_triangles});
  add_dual_layer(registry, {"dual-interior-edges",
                            "Dual interior edges",
                            "Edges of the dual complex between two of its triangles. They give no vertex of the union.",
                            {110, 120, 140},
                            1.5,
                            false,
                            [](Primitive_set& set, const Dual_2& dual) { add_edges(set, dual, Dual_kind::interior); }});
  add_dual_layer(registry, {"dual-regular-edges",
                            "Dual regular edges",
                            "Edges of the dual complex with one triangle of it. Each gives one vertex of the union, on "
                            "the side away from the triangle.",
                            {35, 95, 150},
                            2,
                            false,
                            [](Primitive_set& set, const Dual_2& dual) { add_edges(set, dual, Dual_kind::regular); }});
  add_dual_layer(registry, {"dual-singular-edges",
                            "Dual singular edges",
                            "Edges of the dual complex without a triangle of it. Each gives two vertices of the union, "
                            "and belongs to its medial axis.",
                            {200, 110, 30},
                            2.5,
                            false,
                            [](Primitive_set& set, const Dual_2& dual) { add_edges(set, dual, Dual_kind::singular); }});
  add_dual_layer(registry, {"dual-singular-vertices",
                            "Dual singular vertices",
                            "Vertices of the dual complex without an edge of it: isolated disks.",
                            {200, 50, 30},
                            1,
                            false,
                            add_singular_vertices});
}

}  // namespace mesecina
