// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/labels_2/module.h"

#include <cmath>

#include "core/graph.h"
#include "geometries/crust_2/module.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/primitives_2.h"
#include "geometries/samples_2/module.h"

namespace mesecina {

namespace {

Labels_2 compute_labels(Context& context) {
  const auto triangulation = context.get(delaunay_2_key);
  if (triangulation->dimension < 2) throw Unavailable("needs at least 3 samples that are not on one line");
  const auto crust = context.get(crust_2_key);
  const auto outline = context.get(samples_2_key)->outline;
  Labels_2 labels =
      outline ? outline_labels(*triangulation, *context.get(voronoi_2_key), *crust, *outline, context.progress())
              : flood_labels(*triangulation, *crust, context.progress());
  if (!labels.conflicts.empty()) {
    std::vector<Place> places;
    for (const auto& [first, second] : labels.conflicts) {
      if (places.size() == most_places) break;
      const Point_2 middle = midpoint(triangulation->points[first], triangulation->points[second]);
      places.push_back({{middle.x, middle.y, 0}});
    }
    const std::string where = " (layer {label-conflicts} shows where)";
    context.warn(outline ? "the outline is sampled too sparsely at " + std::to_string(labels.conflicts.size()) +
                               " places: a smaller {sampling-step} follows it better" + where
                         : "inside and outside contradict each other at " + std::to_string(labels.conflicts.size()) +
                               " edges: the curve is open, noisy or too sparsely sampled there" + where,
                 std::move(places));
  }
  return labels;
}

/// Voronoi vertices of one side, as points or as disks.
Primitive_set side_layer(Context& context, bool inner, bool as_disks) {
  const auto labels = context.get(labels_2_key);
  const auto voronoi = context.get(voronoi_2_key);
  Primitive_set set;
  Values radius{"radius", "units of the input", {}};
  for (std::size_t t = 0; t < voronoi->vertices.size(); ++t) {
    if ((labels->is_inner[t] != 0) != inner) continue;
    if (as_disks) {
      add_disk(set, voronoi->vertices[t], voronoi->radii[t]);
    } else {
      add_point(set, voronoi->vertices[t]);
    }
    radius.data.push_back(voronoi->radii[t]);
    set.ids.push_back(static_cast<std::int64_t>(t));
  }
  set.values.push_back(std::move(radius));
  return set;
}

Element_description describe_vertex(Context& context, std::size_t element, bool inner) {
  const auto labels = context.get(labels_2_key);
  const auto triangulation = context.get(delaunay_2_key);
  const auto voronoi = context.get(voronoi_2_key);
  Element_description description;
  for (std::size_t t = 0; t < labels->is_inner.size(); ++t) {
    if ((labels->is_inner[t] != 0) != inner || element-- != 0) continue;
    const auto& [a, b, c] = triangulation->triangles[t];
    description.facts.push_back({"touches samples", enumeration(triangulation->triangles[t])});
    description.facts.push_back(fact("center", voronoi->vertices[t]));
    for (const int corner : {a, b, c}) add_point(description.dual, triangulation->points[corner]);
    description.dual.triangles.push_back({0, 1, 2});
    break;
  }
  return description;
}

Primitive_set conflict_layer(Context& context) {
  const auto labels = context.get(labels_2_key);
  const auto triangulation = context.get(delaunay_2_key);
  Primitive_set set;
  for (const auto& [a, b] : labels->conflicts) add_segment(set, triangulation->points[a], triangulation->points[b]);
  return set;
}

/// At each sample on the crust, the mean of the outward normals of its crust edges.
Primitive_set normal_layer(Context& context) {
  const auto labels = context.get(labels_2_key);
  const auto crust = context.get(crust_2_key);
  const auto triangulation = context.get(delaunay_2_key);
  Box box;
  for (const Point_2& p : triangulation->points) box.add(p);
  const double length = context.setting(normal_length_setting) * box.diagonal();

  std::vector<Point_2> sums(triangulation->points.size());
  for (int t = 0; t < static_cast<int>(triangulation->triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!crust->contains(t, i) || !triangulation->edge_is_listed(t, i)) continue;
      const int u = triangulation->neighbors[t][i];
      const bool other_is_inner = u >= 0 && labels->is_inner[u] != 0;
      if ((labels->is_inner[t] != 0) == other_is_inner) continue;
      const Point_2 away = ray_direction(*triangulation, t, i);
      const double sign = labels->is_inner[t] != 0 ? 1 : -1;
      for (const int sample : triangulation->edge(t, i))
        sums[sample] = {sums[sample].x + sign * away.x, sums[sample].y + sign * away.y};
    }
  }
  Primitive_set set;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const double norm = std::hypot(sums[i].x, sums[i].y);
    if (norm == 0) continue;
    const Point_2& p = triangulation->points[i];
    add_segment(set, p, {p.x + length * sums[i].x / norm, p.y + length * sums[i].y / norm});
    set.ids.push_back(static_cast<std::int64_t>(i));
  }
  return set;
}

void add_side_layers(Registry& registry, bool inner) {
  const std::string side = inner ? "inner" : "outer";
  const Color color = inner ? Color{200, 120, 60} : Color{110, 140, 120};
  {
    Layer_spec layer;
    layer.id = side + "-voronoi-disks";
    layer.label = inner ? "Inner Voronoi disks" : "Outer Voronoi disks";
    layer.stage = "Reconstruction";
    layer.help = inner ? "The Voronoi disks centered inside the shape; their union approximates it."
                       : "The Voronoi disks centered outside the shape; their union approximates its complement.";
    layer.style = look(color, 1);
    layer.style.opacity = 0.6;
    layer.build = [inner](Context& context) { return side_layer(context, inner, true); };
    layer.describe = [inner](Context& context, std::size_t e) { return describe_vertex(context, e, inner); };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = side + "-voronoi-vertices";
    layer.label = inner ? "Inner Voronoi vertices" : "Outer Voronoi vertices";
    layer.stage = "Reconstruction";
    layer.help = inner ? "The Voronoi vertices inside the shape: centers of its medial disks."
                       : "The Voronoi vertices outside the shape.";
    layer.style = look(color);
    layer.style.point_size = 4;
    layer.build = [inner](Context& context) { return side_layer(context, inner, false); };
    layer.describe = [inner](Context& context, std::size_t e) { return describe_vertex(context, e, inner); };
    registry.add_layer(std::move(layer));
  }
}

}  // namespace

void register_labels_2(Registry& registry) {
  registry.begin_module({"labels-2", "Inside and outside", "Which Voronoi vertices lie inside the shape."});
  {
    Setting_spec setting;
    setting.id = normal_length_setting.id;
    setting.label = "Length of normals";
    setting.help = "Length at which curve normals are drawn, as a fraction of the diagonal of the samples.";
    setting.unit = "fraction of the diagonal";
    setting.default_value = 0.02;
    setting.minimum = 0;
    setting.maximum = 1;
    setting.tags = {"display"};
    registry.add_setting(std::move(setting));
  }
  registry.add_structure<Labels_2>(labels_2_key, compute_labels);
  add_side_layers(registry, false);
  add_side_layers(registry, true);
  {
    Layer_spec layer;
    layer.id = "curve-normals";
    layer.label = "Curve normals";
    layer.stage = "Reconstruction";
    layer.help = "Outward normals at the samples on the crust: the mean of those of its crust edges.";
    layer.style = look({90, 90, 150}, 1);
    layer.build = normal_layer;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "label-conflicts";
    layer.label = "Label conflicts";
    layer.stage = "Reconstruction";
    layer.help =
        "Delaunay edges where inside and outside disagree with the crust: the curve is open, noisy, or too sparsely "
        "sampled there. Empty for a well sampled closed curve.";
    layer.style = look({215, 30, 50}, 3);
    layer.build = conflict_layer;
    registry.add_layer(std::move(layer));
  }
}

}  // namespace mesecina
