// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_2/module.h"

#include <cmath>

#include "core/graph.h"
#include "geometries/primitives_2.h"
#include "geometries/samples_2/module.h"

namespace mesecina {

Point_2 ray_direction(const Delaunay_2& triangulation, int triangle, int corner) {
  const auto [a, b] = triangulation.edge(triangle, corner);
  const Point_2& p = triangulation.points[a];
  const Point_2& q = triangulation.points[b];
  const double length = distance(p, q);
  return {(q.y - p.y) / length, (p.x - q.x) / length};
}

void add_dual_edge(Primitive_set& set, const Delaunay_2& triangulation, int triangle, int corner, int first_vertex) {
  const int other = triangulation.neighbors[triangle][corner];
  if (other >= 0) {
    set.segments.push_back({first_vertex + triangle, first_vertex + other});
  } else {
    const Point_2 direction = ray_direction(triangulation, triangle, corner);
    set.rays.push_back({first_vertex + triangle, lifted(direction)});
  }
}

namespace {

constexpr const char* delaunay_paper = " [B. Delaunay 1934; CGAL, 2D Triangulations]";

Primitive_set delaunay_layer(Context& context) {
  const auto triangulation = context.get(delaunay_2_key);
  Primitive_set set;
  set.vertices = lifted(triangulation->points);
  set.is_complex = true;
  if (triangulation->dimension < 2) {
    if (triangulation->dimension < 1) throw Unavailable("needs at least 2 distinct points");
    const auto& line = triangulation->line;
    for (std::size_t i = 1; i < line.size(); ++i) set.segments.push_back({line[i - 1], line[i]});
    return set;
  }
  const int count = static_cast<int>(triangulation->triangles.size());
  set.segments.reserve(3 * triangulation->triangles.size() / 2 + 3);
  set.ids.reserve(3 * triangulation->triangles.size() / 2 + 3);
  for (int t = 0; t < count; ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!triangulation->edge_is_listed(t, i)) continue;
      set.segments.push_back(triangulation->edge(t, i));
      set.ids.push_back(edge_id(t, i));
    }
  }
  return set;
}

/// Sites on one line: the diagram is the lines half way between neighbours, each given as two rays.
Primitive_set parallel_lines(const Delaunay_2& triangulation) {
  Primitive_set set;
  const auto& line = triangulation.line;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point_2& p = triangulation.points[line[i - 1]];
    const Point_2& q = triangulation.points[line[i]];
    const double length = distance(p, q);
    const Point_3 direction{(q.y - p.y) / length, (p.x - q.x) / length, 0};
    const int v = static_cast<int>(set.vertices.size());
    set.vertices.push_back(lifted(midpoint(p, q)));
    set.rays.push_back({v, direction});
    set.rays.push_back({v, {-direction.x, -direction.y, 0}});
  }
  return set;
}

Primitive_set voronoi_layer(Context& context) {
  const auto triangulation = context.get(delaunay_2_key);
  if (triangulation->dimension < 1) throw Unavailable("needs at least 2 distinct points");
  if (triangulation->dimension == 1) return parallel_lines(*triangulation);
  const auto voronoi = context.get(voronoi_2_key);
  Primitive_set set;
  set.vertices = lifted(voronoi->vertices);
  const int count = static_cast<int>(triangulation->triangles.size());
  std::vector<std::int64_t> ray_ids;
  set.segments.reserve(3 * voronoi->vertices.size() / 2);
  set.ids.reserve(3 * voronoi->vertices.size() / 2);
  for (int t = 0; t < count; ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!triangulation->edge_is_listed(t, i)) continue;
      add_dual_edge(set, *triangulation, t, i, 0);
      (triangulation->neighbors[t][i] < 0 ? ray_ids : set.ids).push_back(edge_id(t, i));
    }
  }
  set.ids.insert(set.ids.end(), ray_ids.begin(), ray_ids.end());
  return set;
}

Primitive_set disk_layer(Context& context) {
  const auto triangulation = context.get(delaunay_2_key);
  if (triangulation->dimension < 2) throw Unavailable("needs at least 3 points that are not on one line");
  const auto voronoi = context.get(voronoi_2_key);
  Primitive_set set;
  set.vertices = lifted(voronoi->vertices);
  set.balls.reserve(voronoi->radii.size());
  for (std::size_t t = 0; t < voronoi->radii.size(); ++t) set.balls.push_back({static_cast<int>(t), voronoi->radii[t]});
  set.values.push_back({"radius", "units of the input", voronoi->radii});
  return set;
}

struct Edge {
  int triangle;
  int corner;
};

/// The n-th listed edge; hull edges last when they are shown as rays.
Edge listed_edge(const Delaunay_2& triangulation, std::size_t n, bool hull_last) {
  const int count = static_cast<int>(triangulation.triangles.size());
  for (const bool hull : {false, true}) {
    for (int t = 0; t < count; ++t) {
      for (int i = 0; i < 3; ++i) {
        if (!triangulation.edge_is_listed(t, i)) continue;
        if (hull_last && (triangulation.neighbors[t][i] < 0) != hull) continue;
        if (n-- == 0) return {t, i};
      }
    }
    if (!hull_last) break;
  }
  return {-1, 0};
}

Element_description describe_edge(Context& context, std::size_t element, bool as_voronoi) {
  Element_description description;
  const auto triangulation = context.get(delaunay_2_key);
  if (triangulation->dimension < 2) return description;
  const Edge edge = listed_edge(*triangulation, element, as_voronoi);
  if (edge.triangle < 0) return description;
  const auto voronoi = context.get(voronoi_2_key);
  const auto [a, b] = triangulation->edge(edge.triangle, edge.corner);
  const Point_2& p = triangulation->points[a];
  const Point_2& q = triangulation->points[b];
  description.facts.push_back({"between samples", enumeration(std::array{a, b})});
  description.facts.push_back(fact("distance of the samples", distance(p, q)));
  const int other = triangulation->neighbors[edge.triangle][edge.corner];
  if (other >= 0) {
    description.facts.push_back(
        fact("length of the Voronoi edge", distance(voronoi->vertices[edge.triangle], voronoi->vertices[other])));
  } else {
    description.facts.push_back({"length of the Voronoi edge", "infinite"});
  }
  if (as_voronoi) {
    add_segment(description.dual, p, q);
  } else if (other >= 0) {
    add_segment(description.dual, voronoi->vertices[edge.triangle], voronoi->vertices[other]);
  } else {
    add_point(description.dual, voronoi->vertices[edge.triangle]);
    description.dual.rays.push_back({0, lifted(ray_direction(*triangulation, edge.triangle, edge.corner))});
  }
  add_point(description.dual, p);
  add_point(description.dual, q);
  return description;
}

Element_description describe_disk(Context& context, std::size_t element) {
  const auto triangulation = context.get(delaunay_2_key);
  const auto voronoi = context.get(voronoi_2_key);
  Element_description description;
  if (element >= voronoi->radii.size()) return description;
  const auto& [a, b, c] = triangulation->triangles[element];
  description.facts.push_back({"touches samples", enumeration(triangulation->triangles[element])});
  description.facts.push_back(fact("center", voronoi->vertices[element]));
  for (const int corner : {a, b, c}) add_point(description.dual, triangulation->points[corner]);
  description.dual.triangles.push_back({0, 1, 2});
  return description;
}

std::size_t duplicates(const Delaunay_2& triangulation) {
  return triangulation.points.size() - triangulation.site_count;
}

void warn_of_duplicates(Context& context, const Delaunay_2& triangulation) {
  std::vector<int> merged;
  for (std::size_t i = 0; i < triangulation.site.size(); ++i)
    if (triangulation.site[i] != static_cast<int>(i)) merged.push_back(static_cast<int>(i));
  if (duplicates(triangulation) > 0)
    context.warn(std::to_string(duplicates(triangulation)) + " of " + std::to_string(triangulation.points.size()) +
                     " samples equal another one and are merged with it",
                 sample_places(context, merged));
  if (triangulation.dimension == 1) context.warn("all samples lie on one line");
}

}  // namespace

void register_delaunay_2(Registry& registry) {
  registry.begin_module({"delaunay-2", "Delaunay and Voronoi", "The diagrams that everything else is read from."});
  registry.add_structure<Delaunay_2>(
      delaunay_2_key,
      [](Context& context) {
        Delaunay_2 triangulation = delaunay(context.get(samples_2_key)->points, context.progress());
        warn_of_duplicates(context, triangulation);
        return triangulation;
      },
      [](Context& context, std::shared_ptr<Delaunay_2> previous) {
        const auto samples = context.get(samples_2_key);
        if (previous.use_count() == 1) {
          update(*previous, samples->points, context.progress());
        } else {
          previous = std::make_shared<Delaunay_2>(delaunay(samples->points, context.progress()));
        }
        warn_of_duplicates(context, *previous);
        return previous;
      });
  registry.add_structure<Voronoi_2>(voronoi_2_key, [](Context& context) {
    const auto triangulation = context.get(delaunay_2_key);
    if (triangulation->dimension < 2) throw Unavailable("needs at least 3 samples that are not on one line");
    return voronoi(*triangulation, context.progress());
  });
  {
    Layer_spec layer;
    layer.id = "voronoi-disks";
    layer.label = "Voronoi disks";
    layer.stage = "Diagram";
    layer.help =
        "The disks around the Voronoi vertices that touch three samples and contain none: circumscribed to the "
        "Delaunay triangles.";
    layer.style = look({120, 160, 190}, 1);
    layer.style.opacity = 0.6;
    layer.build = disk_layer;
    layer.describe = describe_disk;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "delaunay";
    layer.label = "Delaunay triangulation";
    layer.stage = "Diagram";
    layer.help = std::string("Joins two samples iff some circle through both has no sample inside.") + delaunay_paper;
    layer.style = look({168, 150, 120}, 1);
    layer.build = delaunay_layer;
    layer.describe = [](Context& context, std::size_t element) { return describe_edge(context, element, false); };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "voronoi";
    layer.label = "Voronoi diagram";
    layer.stage = "Diagram";
    layer.help =
        "The points of the plane that have more than one nearest sample. [G. Voronoi 1908; CGAL, 2D Triangulations]";
    layer.style = look({150, 170, 190}, 1);
    layer.build = voronoi_layer;
    layer.describe = [](Context& context, std::size_t element) { return describe_edge(context, element, true); };
    registry.add_layer(std::move(layer));
  }
}

}  // namespace mesecina
