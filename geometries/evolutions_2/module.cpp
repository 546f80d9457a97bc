// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/evolutions_2/module.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "core/graph.h"
#include "geometries/crust_2/module.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/evolution_settings.h"
#include "geometries/evolutions_2/curves_2.h"

namespace mesecina {

namespace {

/// The one-step crust of the bare points, without the outline that there may be.
struct Point_curve {
  std::shared_ptr<const std::vector<Point_2>> points;
  Curve_neighbors_2 neighbors;
  std::vector<std::array<int, 2>> edges;  ///< ascending, the lesser point first
};

Point_curve point_curve(Context& context, const Inputs& inputs) {
  Point_curve curve;
  curve.points = inputs.get(points_input);
  if (!curve.points || curve.points->empty()) return curve;
  const auto take = [&curve](const Delaunay_2& triangulation, const Crust_2& crust) {
    curve.neighbors = crust_neighbors(triangulation, crust);
    curve.edges = crust.edges;
  };
  if (const auto outline = inputs.get(outline_input); outline && !outline->rings.empty()) {
    const Delaunay_2 triangulation = delaunay(*curve.points, context.progress());
    take(triangulation, one_step_crust(triangulation, context.progress()));
  } else {
    take(*context.get(delaunay_2_key), *context.get(crust_2_key));
  }
  for (auto& [p, q] : curve.edges)
    if (p > q) std::swap(p, q);
  std::ranges::sort(curve.edges);
  return curve;
}

bool has_curve(const Outline_2& outline) {
  return std::ranges::any_of(outline.rings, [](const Ring_2& ring) { return ring.size() >= 3; });
}

using Change_points = std::function<std::vector<Point_2>(const Point_curve&)>;
using Change_ring = std::function<Ring_2(const Ring_2&)>;

/// Both the crust of the points and the rings of the outline are curves.
Evolution_state with_changed_curves(Context& context, const Evolution_state& before, const Change_points& change_points,
                                    const Change_ring& change_ring) {
  Evolution_state after = before;
  const Point_curve curve = point_curve(context, before.inputs);
  const auto outline = before.inputs.get(outline_input);
  const bool has_outline = outline && has_curve(*outline);
  if (!has_outline && !has_neighbors(curve.neighbors))
    throw Unavailable(
        curve.points && !curve.points->empty()
            ? "no point has exactly two neighbours on the one-step crust: draw points along a curve, or an outline"
            : "there is no curve: draw, generate or open points along one, or an outline");
  if (has_neighbors(curve.neighbors)) after.inputs = after.inputs.with(points_input, change_points(curve));
  if (has_outline) {
    Outline_2 changed;
    changed.rings.reserve(outline->rings.size());
    for (const Ring_2& ring : outline->rings) {
      context.progress().check();
      changed.rings.push_back(change_ring(ring));
    }
    after.inputs = after.inputs.with(outline_input, std::move(changed));
  }
  return after;
}

Evolution_state smooth(Context& context, const Evolution_state& before, std::uint64_t) {
  const double factor = context.setting(smoothing_factor_setting);
  if (factor == 0) return before;
  const std::vector<double> passes = smoothing_passes(factor, context.setting(smoothing_keeps_size_setting));
  return with_changed_curves(
      context, before, [&](const Point_curve& curve) { return smoothed(*curve.points, curve.neighbors, passes); },
      [&](const Ring_2& ring) { return smoothed(ring, ring_neighbors(ring.size()), passes); });
}

Evolution_spec smoothing() {
  Evolution_spec evolution;
  evolution.id = "laplacian-smoothing";
  evolution.label = "Laplacian smoothing";
  evolution.help =
      "Each step moves every point with exactly two neighbours on the one-step crust, and every vertex of the outline, "
      "toward the middle of its two neighbours, as smoothing-factor says. Other points stay. With "
      "smoothing-keeps-size the curve does not shrink. [G. Taubin: A signal processing approach to fair surface "
      "design, 1995]";
  evolution.settings = {std::string(smoothing_factor_setting.id), std::string(smoothing_keeps_size_setting.id)};
  evolution.step = smooth;
  return evolution;
}

}  // namespace

void register_evolutions_2(Registry& registry) {
  registry.begin_module(
      {"evolutions-2", "Evolutions", "Steps that change points, outlines and disks again and again."});
  add_smoothing_settings(registry);
  registry.add_evolution(smoothing());
}

}  // namespace mesecina
