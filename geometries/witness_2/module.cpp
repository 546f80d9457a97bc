// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/witness_2/module.h"

#include <numeric>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/primitives_2.h"
#include "geometries/samples_2/module.h"

namespace mesecina {

namespace {

std::shared_ptr<const std::vector<Point_2>> landmarks(Context& context) {
  auto result = context.input(landmarks_input);
  if (!result || result->empty())
    throw Unavailable("there are no landmarks: go steps of the evolution {max-min-landmarks}");
  return result;
}

Primitive_set landmark_layer(Context& context) {
  Primitive_set set;
  set.vertices = lifted(*landmarks(context));
  set.points.resize(set.vertices.size());
  std::iota(set.points.begin(), set.points.end(), 0);
  set.values.push_back({"order", "", {set.points.begin(), set.points.end()}});
  return set;
}

Primitive_set delaunay_layer(Context& context) {
  const auto points = landmarks(context);
  const Delaunay_2 triangulation = delaunay(*points, context.progress());
  if (triangulation.dimension < 1) throw Unavailable("needs at least 2 landmarks");
  Primitive_set set;
  set.vertices = lifted(*points);
  set.triangles = triangulation.triangles;
  for (std::size_t i = 0; i + 1 < triangulation.line.size(); ++i)
    set.segments.push_back({triangulation.line[i], triangulation.line[i + 1]});
  set.is_complex = true;
  return set;
}

Primitive_set witness_layer(Context& context) {
  const auto points = landmarks(context);
  const auto witnesses = context.get(witnesses_2_key);
  Primitive_set set;
  set.vertices = lifted(*points);
  Values count{"witnesses", "", {}};
  for (const Witnesses_2::Edge& edge : witnesses->edges) {
    set.segments.push_back(edge.landmarks);
    count.data.push_back(edge.witnesses);
  }
  if (set.segments.empty()) throw Unavailable("needs at least 2 landmarks");
  set.values.push_back(std::move(count));
  set.is_complex = true;
  return set;
}

Element_description describe_landmark(Context& context, std::size_t element) {
  const auto points = landmarks(context);
  Element_description description;
  if (element >= points->size()) return description;
  description.facts.push_back({"landmark", std::to_string(element)});
  description.facts.push_back(fact("position", (*points)[element]));
  return description;
}

Element_description describe_witness_edge(Context& context, std::size_t element) {
  const auto points = landmarks(context);
  const auto witnesses = context.get(witnesses_2_key);
  Element_description description;
  if (element >= witnesses->edges.size()) return description;
  const auto& [ends, count] = witnesses->edges[element];
  description.facts.push_back({"joins landmarks", enumeration(ends)});
  description.facts.push_back({"witnesses", std::to_string(count)});
  const auto samples = context.get(samples_2_key);
  for (std::size_t w = 0; w < witnesses->nearest.size(); ++w) {
    const auto [a, b] = witnesses->nearest[w];
    if (std::min(a, b) == ends[0] && std::max(a, b) == ends[1]) add_point(description.dual, samples->points[w]);
  }
  return description;
}

std::string why_nothing_to_sample(const Evolution_state& state) {
  const auto points = state.inputs.get(points_input);
  const auto outline = state.inputs.get(outline_input);
  if ((points && !points->empty()) || (outline && !outline->rings.empty())) return {};
  return "there is nothing to sample: draw, generate or open points or an outline";
}

Evolution_state add_farthest(Context& context, const Evolution_state& before, std::uint64_t) {
  const auto samples = context.get(samples_2_key);
  const auto chosen = before.inputs.get(landmarks_input);
  Evolution_state after = before;
  if (!chosen || chosen->empty()) {
    after.inputs = before.inputs.with(landmarks_input, std::vector<Point_2>{samples->points.front()});
    return after;
  }
  const auto witnesses = context.get(witnesses_2_key);
  if (witnesses->distances[witnesses->farthest] == 0) throw Unavailable("every sample is a landmark");
  std::vector<Point_2> more = *chosen;
  more.push_back(samples->points[witnesses->farthest]);
  after.inputs = before.inputs.with(landmarks_input, std::move(more));
  return after;
}

}  // namespace

void register_witness_2(Registry& registry) {
  registry.begin_module({"witness-2", "Landmarks and witnesses",
                         "A few of the samples, and what the others say of how they hang together."});
  registry.add_structure<Witnesses_2>(witnesses_2_key, [](Context& context) {
    const auto points = landmarks(context);
    return witness(context.get(samples_2_key)->points, *points, context.progress());
  });
  const char* stage = "Landmarks";
  {
    Layer_spec layer;
    layer.id = "landmark-delaunay";
    layer.label = "Landmarks: Delaunay";
    layer.stage = stage;
    layer.help = "The Delaunay triangulation of the landmarks; every edge of their witness complex is one of it.";
    layer.style = look({170, 180, 195}, 1);
    layer.build = delaunay_layer;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "witness-complex";
    layer.label = "Witness complex";
    layer.stage = stage;
    layer.help =
        "Joins two landmarks that are the nearest two of some sample, its witness: the curve that the samples describe "
        "at the scale of the landmarks. [L. Guibas, S. Oudot: Reconstruction using witness complexes, 2007]";
    layer.style = look({190, 90, 20}, 2);
    layer.build = witness_layer;
    layer.describe = describe_witness_edge;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "landmarks";
    layer.label = "Landmarks";
    layer.stage = stage;
    layer.help = "The samples that the evolution {max-min-landmarks} has chosen; their values are the order.";
    layer.style = look({190, 60, 20});
    layer.style.point_size = 8;
    layer.build = landmark_layer;
    layer.describe = describe_landmark;
    registry.add_layer(std::move(layer));
  }
  Evolution_spec evolution;
  evolution.id = "max-min-landmarks";
  evolution.label = "Landmarks by max-min";
  evolution.help =
      "Each step makes the sample that is farthest from all landmarks one of them, the first step the first sample. "
      "The "
      "witness complex shows the curve that they stand for, coarse at first, then finer. Ends when every sample is a "
      "landmark. [L. Guibas, S. Oudot: Reconstruction using witness complexes, 2007; B. Miklos: The Scale Axis "
      "Transform, 2010, section A.5]";
  evolution.needs = {"points, or an outline", why_nothing_to_sample};
  evolution.step = add_farthest;
  registry.add_evolution(std::move(evolution));
}

}  // namespace mesecina
