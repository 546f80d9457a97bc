// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_axis_2/module.h"

#include "core/graph.h"
#include "geometries/crust_2/module.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/labels_2/module.h"
#include "geometries/primitives_2.h"

namespace mesecina {

std::vector<int> isolated_balls(const Medial_axis_2& axis) {
  std::vector<bool> has_edge(axis.centers.size(), false);
  for (const auto& [a, b] : axis.edges) has_edge[a] = has_edge[b] = true;
  std::vector<int> isolated;
  for (std::size_t b = 0; b < has_edge.size(); ++b)
    if (!has_edge[b]) isolated.push_back(static_cast<int>(b));
  return isolated;
}

Primitive_set axis_primitives(const Medial_axis_2& axis, const std::vector<int>& isolated) {
  Primitive_set set;
  set.vertices = lifted(axis.centers);
  set.segments = axis.edges;
  set.points = isolated;
  set.is_complex = true;
  return set;
}

Element_description describe_axis_element(Context& context, std::size_t element) {
  const auto axis = context.get(medial_axis_2_key);
  const auto triangulation = context.get(delaunay_2_key);
  const std::vector<int> isolated = isolated_balls(*axis);
  Element_description description;
  const auto add_contact = [&](int sample) { add_point(description.dual, triangulation->points[sample]); };
  if (element < isolated.size()) {
    const int ball = isolated[element];
    description.facts.push_back(fact("center", axis->centers[ball]));
    description.facts.push_back(fact("radius", axis->radii[ball]));
    for (const int contact : contacts_of_ball(*triangulation, *axis, ball)) add_contact(contact);
    add_disk(description.dual, axis->centers[ball], axis->radii[ball]);
    return description;
  }
  const std::size_t e = element - isolated.size();
  if (e >= axis->edges.size()) return description;
  const auto [a, b] = axis->edges[e];
  const auto [p, q] = axis->contacts[e];
  description.facts.push_back({"contact samples", enumeration(axis->contacts[e])});
  description.facts.push_back(
      {"radii at the ends", format_number(axis->radii[a]) + " and " + format_number(axis->radii[b])});
  description.facts.push_back(fact("length", distance(axis->centers[a], axis->centers[b])));
  add_contact(p);
  add_contact(q);
  description.dual.segments.push_back({0, 1});
  add_disk(description.dual, axis->centers[a], axis->radii[a]);
  add_disk(description.dual, axis->centers[b], axis->radii[b]);
  return description;
}

namespace {

Primitive_set axis_layer(Context& context) {
  const auto axis = context.get(medial_axis_2_key);
  const auto lambda = context.get(lambda_2_key);
  const auto angle = context.get(angle_2_key);
  const std::vector<int> isolated = isolated_balls(*axis);
  Primitive_set set = axis_primitives(*axis, isolated);
  const auto add_values = [&](const char* name, const char* unit, const Importance_2& importance) {
    Values values{name, unit, {}};
    values.data.reserve(set.element_count());
    for (const int ball : isolated) values.data.push_back(importance.balls[ball]);
    values.data.insert(values.data.end(), importance.edges.begin(), importance.edges.end());
    set.values.push_back(std::move(values));
  };
  add_values("lambda", "units of the input", *lambda);
  add_values("angle", "degrees", *angle);
  return set;
}

/// Voronoi edges that do not cross the crust, on both sides of the curve.
Primitive_set full_axis_layer(Context& context) {
  const auto triangulation = context.get(delaunay_2_key);
  if (triangulation->dimension < 2) throw Unavailable("needs at least 3 samples that are not on one line");
  const auto crust = context.get(crust_2_key);
  const auto voronoi = context.get(voronoi_2_key);
  Primitive_set set;
  set.vertices = lifted(voronoi->vertices);
  std::vector<std::int64_t> ray_ids;
  for (int t = 0; t < static_cast<int>(triangulation->triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!triangulation->edge_is_listed(t, i) || crust->contains(t, i)) continue;
      add_dual_edge(set, *triangulation, t, i, 0);
      (triangulation->neighbors[t][i] < 0 ? ray_ids : set.ids).push_back(edge_id(t, i));
    }
  }
  set.ids.insert(set.ids.end(), ray_ids.begin(), ray_ids.end());
  return set;
}

}  // namespace

void register_medial_axis_2(Registry& registry) {
  registry.begin_module(
      {"medial-axis-2", "Medial axis", "The centers of the largest disks inside the shape, from its samples."});
  registry.add_structure<Medial_axis_2>(medial_axis_2_key, [](Context& context) {
    Medial_axis_2 axis = medial_axis(*context.get(delaunay_2_key), *context.get(voronoi_2_key),
                                     *context.get(labels_2_key), context.progress());
    if (axis.centers.empty())
      throw Unavailable("no Voronoi vertex lies inside: the samples enclose nothing (is the curve closed?)");
    return axis;
  });
  registry.add_structure<Importance_2>(lambda_2_key, [](Context& context) {
    const auto axis = context.get(medial_axis_2_key);
    const auto triangulation = context.get(delaunay_2_key);
    return Importance_2{lambda_of_edges(*triangulation, *axis, context.progress()),
                        lambda_of_balls(*triangulation, *axis, context.progress())};
  });
  registry.add_structure<Importance_2>(angle_2_key, [](Context& context) {
    const auto axis = context.get(medial_axis_2_key);
    const auto triangulation = context.get(delaunay_2_key);
    return Importance_2{angle_of_edges(*triangulation, *axis, context.progress()),
                        angle_of_balls(*triangulation, *axis, context.progress())};
  });
  {
    Layer_spec layer;
    layer.id = "full-medial-axis";
    layer.label = "Medial axis, both sides";
    layer.stage = "Medial axis";
    layer.help =
        "The Voronoi edges that do not cross the one-step crust: the medial axis of the curve, inside and outside.";
    layer.style = look({170, 110, 150}, 1);
    layer.build = full_axis_layer;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "medial-axis";
    layer.label = "Medial axis";
    layer.stage = "Medial axis";
    layer.help =
        "The inner Voronoi vertices and the Voronoi edges between them: the medial axis of the union of the inner "
        "Voronoi "
        "disks, for a dense sample. [B. Miklos: The Scale Axis Transform, 2010, Theorem 8 and section 4.3.3]";
    layer.style = look({200, 40, 90}, 1.5);
    layer.build = axis_layer;
    layer.describe = describe_axis_element;
    registry.add_layer(std::move(layer));
  }
}

}  // namespace mesecina
