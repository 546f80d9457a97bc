// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/crust_2/module.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/evolution_settings.h"
#include "geometries/evolutions_2/curves_2.h"
#include "geometries/evolutions_2/evolutions.h"

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

/// Both the crust of the points and the rings of the outline are curves. Nothing where there is none.
std::optional<Evolution_state> with_changed_curves(Context& context, const Evolution_state& before,
                                                   const Change_points& change_points, const Change_ring& change_ring) {
  Evolution_state after = before;
  const Point_curve curve = point_curve(context, before.inputs);
  const bool has_point_curve = has_neighbors(curve.neighbors);
  if (has_point_curve) after.inputs = after.inputs.with(points_input, change_points(curve));
  const auto outline = before.inputs.get(outline_input);
  const bool has_outline = outline && has_curve(*outline);
  if (has_outline) {
    Outline_2 changed;
    changed.rings.reserve(outline->rings.size());
    for (const Ring_2& ring : outline->rings) {
      context.progress().check();
      changed.rings.push_back(change_ring(ring));
    }
    after.inputs = after.inputs.with(outline_input, std::move(changed));
  }
  if (!has_point_curve && !has_outline) return std::nullopt;
  return after;
}

constexpr const char* needed_curve = "points along a curve, or an outline";
constexpr const char* no_neighbors =
    "no point has exactly two neighbours on the one-step crust: draw points along a curve, or an outline";

/// Of points alone, three make a curve at the least.
bool may_have_curve(const Inputs& inputs) {
  const auto points = inputs.get(points_input);
  const auto outline = inputs.get(outline_input);
  return (points && points->size() >= 3) || (outline && has_curve(*outline));
}

std::string why_no_curve(const Evolution_state& state) {
  if (may_have_curve(state.inputs)) return {};
  const auto points = state.inputs.get(points_input);
  return points && !points->empty() ? no_neighbors
                                    : "there is no curve: draw, generate or open points along one, or an outline";
}

std::string why_no_curve_or_disks(const Evolution_state& state) {
  const auto disks = state.inputs.get(disks_input);
  return disks && !disks->empty() ? std::string() : why_no_curve(state);
}

void check_count(std::size_t count) {
  constexpr std::size_t most_points = 10'000'000;
  if (count > most_points) throw Unavailable("subdividing once more would give more than 10 million points");
}

std::vector<Disk_2> with_noise(std::vector<Disk_2> disks, double amplitude, Portable_random& random) {
  for (auto& [center, radius] : disks) {
    const double reach = amplitude * radius;
    center.x += random.within(-reach, reach);
    center.y += random.within(-reach, reach);
  }
  return disks;
}

Evolution_state smooth(Context& context, const Evolution_state& before, std::uint64_t) {
  const double factor = context.setting(smoothing_factor_setting);
  const std::vector<double> passes = smoothing_passes(factor, context.setting(smoothing_keeps_size_setting));
  const auto after = with_changed_curves(
      context, before, [&](const Point_curve& curve) { return smoothed(*curve.points, curve.neighbors, passes); },
      [&](const Ring_2& ring) { return smoothed(ring, ring_neighbors(ring.size()), passes); });
  if (!after) throw Unavailable(no_neighbors);
  return factor == 0 ? before : *after;
}

Evolution_state subdivide(Context& context, const Evolution_state& before, std::uint64_t) {
  std::size_t count = 0;
  const auto after = with_changed_curves(
      context, before,
      [&](const Point_curve& curve) {
        check_count(count += curve.points->size() + curve.edges.size());
        return subdivided(*curve.points, curve.neighbors, curve.edges);
      },
      [&](const Ring_2& ring) {
        check_count(count += 2 * ring.size());
        return subdivided_ring(ring);
      });
  if (!after) throw Unavailable(no_neighbors);
  return *after;
}

Evolution_state add_noise(Context& context, const Evolution_state& before, std::uint64_t step) {
  const double amplitude = context.setting(noise_amplitude_setting);
  Portable_random random(seed_of_step(context.setting(evolution_seed_setting), step));
  auto after = with_changed_curves(
      context, before,
      [&](const Point_curve& curve) { return with_noise(*curve.points, curve.neighbors, amplitude, random); },
      [&](const Ring_2& ring) { return with_noise(ring, ring_neighbors(ring.size()), amplitude, random); });
  const auto disks = before.inputs.get(disks_input);
  const bool has_disks = disks && !disks->empty();
  if (!after && !has_disks) throw Unavailable(no_neighbors);
  if (!after) after = before;
  if (has_disks) after->inputs = after->inputs.with(disks_input, with_noise(*disks, amplitude, random));
  return amplitude == 0 ? before : *after;
}

}  // namespace

Evolution_spec smoothing_2() {
  Evolution_spec evolution;
  evolution.id = "laplacian-smoothing";
  evolution.label = "Laplacian smoothing";
  evolution.help =
      "Each step moves every point with exactly two neighbours on the one-step crust, and every vertex of the outline, "
      "toward the middle of its two neighbours, as {smoothing-factor} says. Other points stay. With "
      "{smoothing-keeps-size} the curve does not shrink. [G. Taubin: A signal processing approach to fair surface "
      "design, 1995]";
  evolution.settings = {std::string(smoothing_factor_setting.id), std::string(smoothing_keeps_size_setting.id)};
  evolution.needs = {needed_curve, why_no_curve};
  evolution.step = smooth;
  return evolution;
}

Evolution_spec subdivision_2() {
  Evolution_spec evolution;
  evolution.id = "subdivision";
  evolution.label = "Subdivision (cubic B-spline)";
  evolution.help =
      "Each step puts a point into the middle of every edge of the one-step crust and of the outline, and moves every "
      "old point with exactly two neighbours to 3/4 of itself and 1/8 of each of them. Other points stay. The limit is "
      "a "
      "smooth curve, the cubic B-spline. [E. Catmull, J. Clark: Recursively generated B-spline surfaces on arbitrary "
      "topological meshes, 1978]";
  evolution.needs = {needed_curve, why_no_curve};
  evolution.step = subdivide;
  return evolution;
}

Evolution_spec noise_2() {
  Evolution_spec evolution;
  evolution.id = "noise";
  evolution.label = "Noise";
  evolution.help =
      "Each step moves every point with exactly two neighbours on the one-step crust, and every vertex of the outline, "
      "at right angles to the line through its neighbours, evenly at random by up to {noise-amplitude} times their "
      "distance to either side; the center of a disk by up to {noise-amplitude} times its radius in x and in y. Other "
      "points stay. The same {evolution-seed} gives the same noise.";
  evolution.settings = {std::string(noise_amplitude_setting.id), std::string(evolution_seed_setting.id)};
  evolution.needs = {"points along a curve, an outline, or disks", why_no_curve_or_disks};
  evolution.step = add_noise;
  return evolution;
}

}  // namespace mesecina
