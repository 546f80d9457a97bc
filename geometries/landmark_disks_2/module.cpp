// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/landmark_disks_2/module.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/graph.h"
#include "geometries/balls_2/module.h"
#include "geometries/balls_2/needed_disks_2.h"
#include "geometries/primitives_2.h"

namespace mesecina {

namespace {

using Disks = std::vector<Disk_2>;

std::shared_ptr<const Disks> landmarks(Context& context) {
  auto result = context.input(landmark_disks_input);
  if (!result || result->empty())
    throw Unavailable("there are no landmark disks: go steps of the evolution {landmark-disks}");
  return result;
}

bool begins_with(const Disks& all, const Disks& first) {
  return first.size() <= all.size() && std::equal(first.begin(), first.end(), all.begin());
}

std::shared_ptr<Landmark_coverage_2> updated_coverage(Context& context,
                                                      const std::shared_ptr<Landmark_coverage_2>& previous) {
  const auto chosen = landmarks(context);
  const auto balls = context.get(balls_2_key);
  if (previous->balls != balls || !begins_with(*chosen, *previous->landmarks))
    return std::make_shared<Landmark_coverage_2>(landmark_coverage(balls, chosen, context.progress()));
  return std::make_shared<Landmark_coverage_2>(with_landmarks(*previous, chosen, context.progress()));
}

/// By how much the landmarks grow until each disk is in one.
double growth(const Landmark_coverage_2& coverage) { return std::max(1.0, coverage.factors[coverage.farthest]); }

Disks grown_landmarks(const Landmark_coverage_2& coverage) {
  const double factor = growth(coverage);
  if (!std::isfinite(factor)) throw Unavailable("all landmark disks have radius 0: they do not grow");
  Disks grown = *coverage.landmarks;
  for (Disk_2& disk : grown) disk.radius *= factor;
  return grown;
}

Primitive_set disk_layer(const Disks& disks) {
  Primitive_set set;
  Values order{"order", "", {}};
  for (const Disk_2& disk : disks) {
    order.data.push_back(static_cast<double>(set.balls.size()));
    add_disk(set, disk.center, disk.radius);
  }
  set.values.push_back(std::move(order));
  return set;
}

Primitive_set dual_layer(Context& context) {
  const auto dual = context.get(landmark_dual_2_key);
  Primitive_set set;
  set.vertices = lifted(dual->regular->balls->centers);
  for (std::size_t b = 0; b < dual->vertices.size(); ++b)
    if (dual->vertices[b] == Dual_kind::singular) set.points.push_back(static_cast<int>(b));
  for (const Dual_edge& edge : dual->edges) set.segments.push_back({edge.a, edge.b});
  for (std::size_t t = 0; t < dual->has_triangle.size(); ++t)
    if (dual->has_triangle[t] != 0) set.triangles.push_back(dual->regular->triangles[t]);
  set.is_complex = true;
  return without_unused_vertices(set);
}

Evolution_state add_farthest(Context& context, const Evolution_state& before, std::uint64_t) {
  const auto balls = context.get(balls_2_key);
  if (balls->size() == 0) throw Unavailable("there are no disks to choose from");
  const auto chosen = before.inputs.get(landmark_disks_input);
  Disks more;
  std::ptrdiff_t next = std::ranges::max_element(balls->radii) - balls->radii.begin();
  if (chosen && !chosen->empty()) {
    const auto coverage = context.get(landmark_coverage_2_key);
    if (growth(*coverage) == 1) throw Unavailable("every disk is in a landmark disk");
    more = *chosen;
    next = coverage->farthest;
  }
  const auto ball = static_cast<std::size_t>(next);
  more.push_back({balls->centers[ball], balls->radii[ball]});
  Evolution_state after = before;
  after.inputs = before.inputs.with(landmark_disks_input, std::move(more));
  return after;
}

Layer_spec make_landmark_layer(const char* id, const char* label, const char* help, Color color) {
  Layer_spec layer;
  layer.id = id;
  layer.label = label;
  layer.stage = "Landmarks";
  layer.help = help;
  layer.style = look(color);
  return layer;
}

}  // namespace

void register_landmark_disks_2(Registry& registry) {
  registry.begin_module(
      {"landmark-disks-2", "Landmark disks",
       "A few of the disks, and the shape that they describe. [B. Miklos: The Scale Axis Transform, 2010, section "
       "A.5]"});
  registry.add_structure<Landmark_coverage_2>(
      landmark_coverage_2_key,
      [](Context& context) {
        const auto chosen = landmarks(context);
        return landmark_coverage(context.get(balls_2_key), chosen, context.progress());
      },
      updated_coverage);
  registry.add_structure<Dual_2>(landmark_dual_2_key, [](Context& context) {
    Balls_2 balls = given_balls(grown_landmarks(*context.get(landmark_coverage_2_key)));
    Regular_2 regular = regular_triangulation(std::make_shared<const Balls_2>(std::move(balls)), context.progress());
    return dual_complex(std::make_shared<const Regular_2>(std::move(regular)), 0, context.progress());
  });
  {
    Layer_spec layer = make_landmark_layer(
        "landmark-disks-grown", "Landmark disks: grown",
        "The landmark disks, all grown by the least factor at which each disk is in one of them. [B. Miklos: The Scale "
        "Axis Transform, 2010, section A.5]",
        {205, 170, 140});
    layer.build = [](Context& context) { return disk_layer(grown_landmarks(*context.get(landmark_coverage_2_key))); };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer = make_landmark_layer(
        "landmark-disks", "Landmark disks",
        "The disks that the evolution {landmark-disks} has chosen; their values are the order.", {190, 90, 20});
    layer.build = [](Context& context) { return disk_layer(*landmarks(context)); };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer = make_landmark_layer(
        "landmark-disks-dual", "Landmark disks: dual complex",
        "How the grown landmark disks hang together: the shape that all disks describe, at the scale of the landmarks. "
        "[B. Miklos: The Scale Axis Transform, 2010, section A.5]",
        {150, 50, 10});
    layer.style.line_width = 2;
    layer.style.point_size = 7;
    layer.build = dual_layer;
    registry.add_layer(std::move(layer));
  }
  Evolution_spec evolution;
  evolution.id = "landmark-disks";
  evolution.label = "Landmark disks by max-min";
  evolution.help =
      "Each step makes that disk a landmark which the landmarks, all grown by one factor, hold last; the first step "
      "the "
      "largest disk. The disks are those that {ball-source} says. Ends when every disk is in a landmark. [B. Miklos: "
      "The "
      "Scale Axis Transform, 2010, section A.5]";
  evolution.settings = {std::string(ball_source_setting.id)};
  evolution.needs = needed_disks_2();
  evolution.step = add_farthest;
  registry.add_evolution(std::move(evolution));
}

}  // namespace mesecina
