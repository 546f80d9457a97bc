// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_2/module.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

#include "core/graph.h"
#include "geometries/balls_2/module.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/dual_2/module.h"
#include "geometries/primitives_2.h"

namespace mesecina {

namespace {

Primitive_set vertex_layer(Context& context) {
  const auto boundary = context.get(union_boundary_2_key);
  Primitive_set set;
  set.vertices = lifted(boundary->vertices);
  set.points.resize(boundary->vertices.size());
  std::iota(set.points.begin(), set.points.end(), 0);
  Values sources{"disks", "circles through the vertex", {}};
  for (int v = 0; v < static_cast<int>(boundary->vertices.size()); ++v)
    sources.data.push_back(static_cast<double>(boundary->sources_of(v).size()));
  set.values.push_back(std::move(sources));
  return set;
}

Element_description describe_vertex(Context& context, std::size_t element) {
  const auto boundary = context.get(union_boundary_2_key);
  Element_description description;
  if (element >= boundary->vertices.size()) return description;
  const int vertex = static_cast<int>(element);
  description.facts.push_back(fact("position", boundary->vertices[vertex]));
  description.facts.push_back({"on the circles of disks", enumeration(boundary->sources_of(vertex))});
  if (boundary->samples[vertex] >= 0)
    description.facts.push_back({"is sample", std::to_string(boundary->samples[vertex])});
  const Balls_2& balls = *boundary->dual->regular->balls;
  for (const int ball : boundary->sources_of(vertex))
    add_disk(description.dual, balls.centers[ball], boundary->radii[ball]);
  return description;
}

Primitive_set origin_layer(Context& context) {
  const auto boundary = context.get(union_boundary_2_key);
  const Balls_2& balls = *boundary->dual->regular->balls;
  Primitive_set set;
  set.vertices = lifted(boundary->vertices);
  const int first_center = static_cast<int>(set.vertices.size());
  for (const Point_2& center : balls.centers) set.vertices.push_back(lifted(center));
  for (int v = 0; v < first_center; ++v) {
    for (const int ball : boundary->sources_of(v)) {
      set.segments.push_back({v, first_center + ball});
      set.ids.push_back(v);
    }
  }
  return without_unused_vertices(set);
}

Primitive_set delaunay_layer(Context& context) {
  const auto voronoi = context.get(union_voronoi_2_key);
  const Delaunay_2& delaunay = voronoi->delaunay;
  if (delaunay.dimension < 1) throw Unavailable("the union has less than 2 vertices");
  Primitive_set set;
  set.vertices = lifted(delaunay.points);
  set.is_complex = true;
  for (std::size_t i = 1; i < delaunay.line.size(); ++i)
    set.segments.push_back({delaunay.line[i - 1], delaunay.line[i]});
  for (int t = 0; t < static_cast<int>(delaunay.triangles.size()); ++t)
    for (int i = 0; i < 3; ++i)
      if (delaunay.edge_is_listed(t, i)) set.segments.push_back(delaunay.edge(t, i));
  return set;
}

/// The disks that have both vertices on their circle, ascending.
std::vector<int> common_sources(const Union_boundary_2& boundary, int p, int q) {
  const auto of_p = boundary.sources_of(p);
  const auto of_q = boundary.sources_of(q);
  std::vector<int> result;
  std::ranges::set_intersection(of_p, of_q, std::back_inserter(result));
  return result;
}

/// The vertices of the union between which the Voronoi edge of this id lies.
std::array<int, 2> edge_of(const Delaunay_2& delaunay, std::int64_t id) {
  return delaunay.edge(static_cast<int>(id / 3), static_cast<int>(id % 3));
}

/// Voronoi edges of the vertices of the union that `keeps` wants, given its Delaunay edge.
template <class Keeps>
Primitive_set voronoi_edges(Context& context, const Keeps& keeps) {
  const auto voronoi = context.get(union_voronoi_2_key);
  const Delaunay_2& delaunay = voronoi->delaunay;
  if (delaunay.dimension < 2) throw Unavailable("the vertices of the union are less than 3, or on one line");
  Primitive_set set;
  set.vertices = lifted(voronoi->vertices);
  std::vector<std::int64_t> ray_ids;
  for (int t = 0; t < static_cast<int>(delaunay.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!delaunay.edge_is_listed(t, i)) continue;
      if (!keeps(*voronoi, delaunay.edge(t, i))) continue;
      add_dual_edge(set, delaunay, t, i, 0);
      (delaunay.neighbors[t][i] < 0 ? ray_ids : set.ids).push_back(edge_id(t, i));
    }
  }
  set.ids.insert(set.ids.end(), ray_ids.begin(), ray_ids.end());
  return without_unused_vertices(set);
}

Element_description describe_voronoi_edge(Context& context, const Primitive_set& edges, std::size_t element) {
  if (element >= edges.element_count()) return {};
  const auto voronoi = context.get(union_voronoi_2_key);
  const Union_boundary_2& boundary = *voronoi->boundary;
  const auto [p, q] = edge_of(voronoi->delaunay, edges.id(element));
  Element_description description;
  description.facts.push_back({"between vertices of the union", enumeration(std::array{p, q})});
  add_point(description.dual, boundary.vertices[p]);
  add_point(description.dual, boundary.vertices[q]);
  const std::vector<int> disks = common_sources(boundary, p, q);
  if (disks.empty()) return description;
  description.facts.push_back(
      {disks.size() == 1 ? "both on the circle of disk" : "both on the circles of disks", enumeration(disks)});
  const Balls_2& balls = *boundary.dual->regular->balls;
  for (const int disk : disks) add_disk(description.dual, balls.centers[disk], boundary.radii[disk]);
  return description;
}

Primitive_set voronoi_side_layer(Context& context, bool inner) {
  const auto voronoi = context.get(union_voronoi_2_key);
  Primitive_set set;
  Values radius{"radius", "units of the input", {}};
  for (std::size_t t = 0; t < voronoi->vertices.size(); ++t) {
    if ((voronoi->is_inner[t] != 0) != inner) continue;
    add_point(set, voronoi->vertices[t]);
    set.ids.push_back(static_cast<std::int64_t>(t));
    radius.data.push_back(voronoi->radii[t]);
  }
  set.values.push_back(std::move(radius));
  return set;
}

Primitive_set medial_disk_layer(Context& context) {
  const auto axis = context.get(union_medial_axis_2_key);
  Primitive_set set;
  set.vertices = lifted(axis->centers);
  for (std::size_t b = 0; b < axis->centers.size(); ++b) set.balls.push_back({static_cast<int>(b), axis->radii[b]});
  set.values.push_back({"radius", "units of the input", axis->radii});
  return set;
}

void add_layer(Registry& registry, const char* id, const char* label, const char* help, Style style,
               std::function<Primitive_set(Context&)> build,
               std::function<Element_description(Context&, std::size_t)> describe = {}) {
  Layer_spec layer;
  layer.id = id;
  layer.label = label;
  layer.stage = "Union of balls";
  layer.help = help;
  layer.style = std::move(style);
  layer.build = std::move(build);
  layer.describe = std::move(describe);
  registry.add_layer(std::move(layer));
}

Style dots(Color color, double size) {
  Style style = look(color);
  style.point_size = size;
  return style;
}

void add_vertex_layers(Registry& registry) {
  const auto all_edges = [](Context& context) {
    return voronoi_edges(context, [](const auto&, const auto&) { return true; });
  };
  const auto crossing_edges = [](Context& context) {
    return voronoi_edges(context, [](const auto& of, const auto& edge) {
      return common_sources(*of.boundary, edge[0], edge[1]).size() == 1;
    });
  };
  const auto alpha_edges = [](Context& context) {
    return voronoi_edges(context, [](const auto& of, const auto& edge) {
      return common_sources(*of.boundary, edge[0], edge[1]).size() >= 2;
    });
  };
  const auto describe = [](auto edges) {
    return [edges](Context& context, std::size_t element) {
      return describe_voronoi_edge(context, edges(context), element);
    };
  };
  add_layer(registry, "union-vertices-delaunay", "Delaunay of the union's vertices",
            "Delaunay triangulation of the vertices of the union.", look({180, 165, 135}, 1), delaunay_layer);
  add_layer(registry, "union-vertices-voronoi", "Voronoi of the union's vertices",
            "Voronoi diagram of the vertices of the union: inside the dual complex it is the medial axis of the union. "
            "[N. Amenta, R. Kolluri 2001]",
            look({165, 180, 195}, 1), all_edges, describe(all_edges));
  add_layer(registry, "union-voronoi-exterior", "Exterior Voronoi vertices",
            "Voronoi vertices of the vertices of the union that lie outside of the dual complex.",
            dots({110, 140, 120}, 4), [](Context& context) { return voronoi_side_layer(context, false); });
  add_layer(
      registry, "union-voronoi-interior", "Interior Voronoi vertices",
      "Voronoi vertices of the vertices of the union that lie in the dual complex: they belong to the medial axis.",
      dots({200, 90, 40}, 5), [](Context& context) { return voronoi_side_layer(context, true); });
  add_layer(registry, "union-crossing-edges", "Crossing edges",
            "Voronoi edges whose two vertices of the union lie on the circle of one common disk: they pass through its "
            "center, where they may leave the dual complex. [N. Amenta, R. Kolluri 2001, Lemma 13]",
            look({225, 170, 20}, 2), crossing_edges, describe(crossing_edges));
  add_layer(registry, "union-alpha-edges", "Alpha edges",
            "Voronoi edges whose two vertices of the union lie on the circles of two common disks: they contain a "
            "singular edge of the dual complex. [N. Amenta, R. Kolluri 2001, Lemma 14]",
            look({40, 90, 220}, 2.5), alpha_edges, describe(alpha_edges));
  add_layer(registry, "union-vertices-origin", "Origins of the union's vertices",
            "Joins every vertex of the union to the centers of the disks whose circles meet in it.",
            look({205, 150, 165}, 1), origin_layer, [](Context& context, std::size_t element) {
              const Primitive_set set = origin_layer(context);
              return element < set.segments.size() ? describe_vertex(context, static_cast<std::size_t>(set.id(element)))
                                                   : Element_description{};
            });
  add_layer(registry, "union-vertices", "Vertices of the union",
            "V(U): the points of the boundary of the union where circles meet. [B. Miklos: The Scale Axis Transform, "
            "2010, section 3.2.4]",
            dots({190, 20, 50}, 7), vertex_layer, describe_vertex);
}

}  // namespace

void register_union_2(Registry& registry) {
  registry.begin_module({"union-2", "Union of balls", "Boundary, vertices and medial axis of a union of disks."});
  {
    Setting_spec setting;
    setting.id = complete_faces_only_setting.id;
    setting.label = "Complete faces only";
    setting.help =
        "On: medial axes of unions leave out Voronoi edges that leave the dual complex. These are short ends, drawn to "
        "the center of a disk; topology stays the same. The scale axis never has them. [B. Miklos: The Scale Axis "
        "Transform, 2010, section 6.1.3]";
    setting.default_value = false;
    setting.tags = {"union", "medial axis"};
    registry.add_setting(std::move(setting));
  }
  registry.add_structure<Union_boundary_2>(union_boundary_2_key, [](Context& context) {
    return union_boundary(context.get(dual_2_key), context.progress());
  });
  registry.add_structure<Union_voronoi_2>(union_voronoi_2_key, [](Context& context) {
    Union_voronoi_2 voronoi = union_voronoi(context.get(union_boundary_2_key), context.progress());
    if (voronoi.lost_chords > 0)
      context.warn(std::to_string(voronoi.lost_chords) +
                   " arcs of the boundary are too short for the precision of coordinates: the medial axis may be "
                   "wrong there");
    return voronoi;
  });
  registry.add_structure<Union_medial_axis_2>(union_medial_axis_2_key, [](Context& context) {
    return union_medial_axis(*context.get(union_voronoi_2_key), false, context.progress());
  });
  add_vertex_layers(registry);
  add_layer(
      registry, "union-boundary", "Boundary of the union",
      "The boundary of the union of the disks: circular arcs between the vertices of the union, and whole circles.",
      look({25, 30, 45}, 2.5), [](Context& context) { return boundary_primitives(*context.get(union_boundary_2_key)); },
      [](Context& context, std::size_t element) {
        return describe_boundary_element(*context.get(union_boundary_2_key), element);
      });
  add_layer(registry, "union-medial-disks", "Medial disks of the union",
            "The medial disks at the vertices of the medial axis of the union. Their union is the union itself.",
            look({150, 100, 160}, 1), medial_disk_layer);
  add_layer(
      registry, "union-medial-axis", "Medial axis of the union",
      "The singular faces of the dual complex, and the Voronoi diagram of the vertices of the union inside the rest of "
      "it: exactly the medial axis of the union of the disks. [N. Amenta, R. Kolluri: The medial axis of a union of "
      "balls, 2001]",
      look({170, 20, 110}, 2.5),
      [](Context& context) {
        return union_axis_primitives(*context.get(union_medial_axis_2_key),
                                     context.setting(complete_faces_only_setting));
      },
      [](Context& context, std::size_t element) {
        return describe_union_axis_element(*context.get(union_medial_axis_2_key),
                                           context.setting(complete_faces_only_setting), element);
      });
}

}  // namespace mesecina
