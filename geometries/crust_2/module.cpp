// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/crust_2/module.h"

#include "core/graph.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/primitives_2.h"

namespace mesecina {

namespace {

Primitive_set crust_layer(Context& context) {
  const auto triangulation = context.get(delaunay_2_key);
  if (triangulation->dimension < 1) throw Unavailable("needs at least 2 distinct points");
  const auto crust = context.get(crust_2_key);
  Primitive_set set;
  set.vertices = lifted(triangulation->points);
  set.segments = crust->edges;
  set.is_complex = true;
  return set;
}

Element_description describe_crust_edge(Context& context, std::size_t element) {
  const auto triangulation = context.get(delaunay_2_key);
  const auto crust = context.get(crust_2_key);
  Element_description description;
  if (element >= crust->edges.size()) return description;
  const auto [a, b] = crust->edges[element];
  description.facts.push_back({"joins samples", enumeration(crust->edges[element])});
  description.facts.push_back(fact("length", distance(triangulation->points[a], triangulation->points[b])));
  add_point(description.dual, triangulation->points[a]);
  add_point(description.dual, triangulation->points[b]);
  return description;
}

}  // namespace

void register_crust_2(Registry& registry) {
  registry.begin_module({"crust-2", "One-step crust", "Reconstruction of a curve from its samples."});
  registry.add_structure<Crust_2>(
      crust_2_key, [](Context& context) { return one_step_crust(*context.get(delaunay_2_key), context.progress()); });
  Layer_spec layer;
  layer.id = "one-step-crust";
  layer.label = "One-step crust";
  layer.stage = "Reconstruction";
  layer.help =
      "The Delaunay edges whose two Voronoi vertices lie on different sides and far apart: cot a cot b >= 1 for the "
      "two "
      "opposite angles. On a dense sample of a smooth closed curve, exactly the polygon through consecutive samples. "
      "[C. Gold, J. Snoeyink: A one-step crust and skeleton extraction algorithm, 2001]";
  layer.style = look({0, 90, 160}, 2);
  layer.build = crust_layer;
  layer.describe = describe_crust_edge;
  registry.add_layer(std::move(layer));
}

}  // namespace mesecina
