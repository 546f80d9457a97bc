// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/evolutions_3/module.h"

#include <cmath>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/evolution_settings.h"
#include "geometries/evolutions_3/mesh_vertices_3.h"
#include "geometries/nearest_points.h"
#include "geometries/samples_3/module.h"
#include "geometries/scale_axis_3/module.h"
#include "geometries/union_3/module.h"

namespace mesecina {

namespace {

constexpr Setting<double> min_angle_setting{"scale-axis-min-angle"};

bool has_triangles(const std::shared_ptr<const Triangle_mesh_3>& mesh) { return mesh && !mesh->triangles.empty(); }

std::string why_no_mesh(const Evolution_state& state) {
  return has_triangles(state.inputs.get(mesh_input)) ? ""
                                                     : "there is no mesh to smooth: open one (off, obj, ply or stl)";
}

bool is_anything(const Inputs& inputs) {
  const auto cloud = inputs.get(cloud_input);
  const auto balls = inputs.get(balls_input);
  return has_triangles(inputs.get(mesh_input)) || (cloud && !cloud->empty()) || (balls && !balls->empty());
}

std::string why_nothing_moves(const Evolution_state& state) {
  return is_anything(state.inputs) ? "" : "there is nothing to move: open or generate a mesh, points or balls";
}

std::string why_nothing_grows(const Evolution_state& state) {
  const Setting_value* source = state.settings.find(ball_source_3_setting.id);
  const auto given = state.inputs.get(balls_input);
  const bool has_given = given && !given->empty();
  const auto cloud = state.inputs.get(cloud_input);
  const bool has_samples = has_triangles(state.inputs.get(mesh_input)) || (cloud && !cloud->empty());
  if (source && *source == Setting_value(std::string(ball_source_3_given)) && !has_given)
    return "there are no given balls: add or open some, or choose another {ball-source}";
  if (source && *source == Setting_value(std::string(ball_source_3_computed)) && !has_samples)
    return "there is no mesh and there are no points to compute balls of: open some, or choose another {ball-source}";
  return has_given || has_samples ? "" : "there is nothing to grow: open or generate balls, a mesh or points";
}

Evolution_needs needed_balls() { return {"balls, a mesh, or points", why_nothing_grows}; }

Evolution_state smooth(Context& context, const Evolution_state& before, std::uint64_t) {
  const auto mesh = before.inputs.get(mesh_input);
  const double factor = context.setting(smoothing_factor_setting);
  if (factor == 0) return before;
  const std::vector<double> passes = smoothing_passes(factor, context.setting(smoothing_keeps_size_setting));
  const Mesh_neighbors_3 neighbors = mesh_neighbors(*mesh, context.progress());
  Evolution_state after = before;
  after.inputs = before.inputs.with(
      mesh_input, Triangle_mesh_3{smoothed(*mesh, neighbors, passes, context.progress()), mesh->triangles});
  return after;
}

Point_3 shaken(const Point_3& p, double reach, Portable_random& random) {
  const double x = random.within(-reach, reach);
  const double y = random.within(-reach, reach);
  const double z = random.within(-reach, reach);
  return p + Point_3{x, y, z};
}

std::vector<Point_3> with_noise(const std::vector<Point_3>& cloud, double amplitude, Portable_random& random,
                                Progress& progress) {
  constexpr std::size_t between_checks = 4096;
  const Nearest_points<Point_3> tree(cloud);
  std::vector<Point_3> result;
  result.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % between_checks == 0) progress.check();
    // The nearest is the point itself, or one at the same place.
    const auto other = tree.nearest_two(cloud[i])[1];
    const double reach = other.point < 0 ? 0 : amplitude * std::sqrt(other.squared_distance);
    result.push_back(shaken(cloud[i], reach, random));
  }
  return result;
}

Evolution_state add_noise(Context& context, const Evolution_state& before, std::uint64_t step) {
  const auto mesh = before.inputs.get(mesh_input);
  const auto cloud = before.inputs.get(cloud_input);
  const auto balls = before.inputs.get(balls_input);
  const bool has_cloud = cloud && !cloud->empty();
  const bool has_balls = balls && !balls->empty();
  const double amplitude = context.setting(noise_amplitude_setting);
  if (amplitude == 0) return before;
  Portable_random random(seed_of_step(context.setting(evolution_seed_setting), step));
  Evolution_state after = before;
  if (has_triangles(mesh)) {
    const Mesh_neighbors_3 neighbors = mesh_neighbors(*mesh, context.progress());
    after.inputs = after.inputs.with(mesh_input,
                                     Triangle_mesh_3{with_noise(*mesh, neighbors, amplitude, random), mesh->triangles});
  }
  if (has_cloud)
    after.inputs = after.inputs.with(cloud_input, with_noise(*cloud, amplitude, random, context.progress()));
  if (has_balls) {
    std::vector<Ball_3> moved = *balls;
    for (auto& [center, radius] : moved) center = shaken(center, amplitude * radius, random);
    after.inputs = after.inputs.with(balls_input, std::move(moved));
  }
  return after;
}

/// The state with these balls, grown, as those whose union is looked at, whatever they came from.
Evolution_state with_balls(const Evolution_state& before, const std::vector<Ball_3>& balls, double factor) {
  Evolution_state after = before;
  after.inputs = before.inputs.with(balls_input, grown(balls, factor));
  const Setting_value* source = before.settings.find(ball_source_3_setting.id);
  const bool is_computed = source && *source == Setting_value(std::string(ball_source_3_computed));
  if (before.inputs.get(mesh_input) || is_computed)
    after.settings = before.settings.with(ball_source_3_setting.id, std::string(ball_source_3_given));
  return after;
}

/// Given balls themselves where they are all: moving them a little (given-perturbation) is for those who look at them.
std::shared_ptr<const std::vector<Ball_3>> balls_to_grow(Context& context, const Inputs& inputs) {
  const std::string source = context.setting(ball_source_3_setting);
  const bool may_be_all =
      source == ball_source_3_given || (source == ball_source_3_automatic && !inputs.get(mesh_input));
  const auto given = inputs.get(balls_input);
  return may_be_all && given && !given->empty() ? given : context.get(balls_3_key);
}

Evolution_state grow(Context& context, const Evolution_state& before, double percent, std::uint64_t step) {
  const auto balls = balls_to_grow(context, before.inputs);
  const double factor = growth_of_step(percent, step);
  if (factor == 0) throw Unavailable("the balls have shrunk to nothing");
  if (factor == 1) return before;
  return with_balls(before, *balls, factor);
}

Evolution_state grow_medial_balls(Context& context, const Evolution_state& before, std::uint64_t) {
  const double factor = 1 + context.setting(growing_step_setting) / 100;
  const auto axis = context.get(medial_axis_3_key);
  if (factor == 1) return before;
  const double min_angle = context.setting(min_angle_setting);
  const Medial_complex_3 kept = min_angle == 0 ? *axis
                                               : without_small_sheets(*axis, angle_of_faces(*axis, context.progress()),
                                                                      min_angle, context.progress())
                                                     .complex;
  std::vector<Ball_3> balls;
  balls.reserve(kept.centers.size());
  // Many medial balls nearly coincide, or touch the same points: the union of such balls is degenerate.
  const double part = context.setting(perturbation_setting);
  for (std::size_t b = 0; b < kept.centers.size(); ++b)
    balls.push_back({moved(kept.centers[b], part * kept.radii[b], b), kept.radii[b]});
  return with_balls(before, balls, factor);
}

constexpr const char* which_balls =
    " Of a mesh, or of points, the balls that stand for it become given balls in the first step, and {ball-source} "
    "becomes given.";

Evolution_spec smoothing() {
  Evolution_spec evolution;
  evolution.id = "laplacian-smoothing";
  evolution.label = "Laplacian smoothing";
  evolution.help =
      "Each step moves every vertex of the mesh toward the mean of its neighbours, as {smoothing-factor} says; where "
      "the "
      "mesh ends, toward the mean of those along its end. With {smoothing-keeps-size} the mesh does not shrink. [G. "
      "Taubin: A signal processing approach to fair surface design, 1995]";
  evolution.settings = {std::string(smoothing_factor_setting.id), std::string(smoothing_keeps_size_setting.id)};
  evolution.needs = {"a mesh", why_no_mesh};
  evolution.step = smooth;
  return evolution;
}

Evolution_spec noise() {
  Evolution_spec evolution;
  evolution.id = "noise";
  evolution.label = "Noise";
  evolution.help =
      "Each step moves, evenly at random, every vertex of the mesh along its normal by up to {noise-amplitude} times "
      "the "
      "mean length of its edges to either side; points in x, y and z by up to {noise-amplitude} times the distance to "
      "the nearest other one; centers of given balls by up to {noise-amplitude} times the radius. The same "
      "{evolution-seed} gives the same noise.";
  evolution.settings = {std::string(noise_amplitude_setting.id), std::string(evolution_seed_setting.id)};
  evolution.needs = {"a mesh, points, or balls", why_nothing_moves};
  evolution.step = add_noise;
  return evolution;
}

Evolution_spec growing() {
  Evolution_spec evolution;
  evolution.id = "grow-balls";
  evolution.label = "Growing balls";
  evolution.help =
      std::string("Each step makes all balls larger by {growing-step} percent of the radius that they had at first.") +
      which_balls + " [B. Miklos: The Scale Axis Transform, 2010, section 5.2]";
  evolution.settings = {std::string(growing_step_setting.id), std::string(ball_source_3_setting.id)};
  evolution.needs = needed_balls();
  evolution.step = [](Context& context, const Evolution_state& before, std::uint64_t step) {
    return grow(context, before, context.setting(growing_step_setting), step);
  };
  return evolution;
}

Evolution_spec shrinking() {
  Evolution_spec evolution;
  evolution.id = "shrink-balls";
  evolution.label = "Shrinking balls";
  evolution.help = std::string(
                       "Each step makes all balls smaller by {growing-step} percent of the radius that they had at "
                       "first; ends before nothing is left.") +
                   which_balls;
  evolution.settings = {std::string(growing_step_setting.id), std::string(ball_source_3_setting.id)};
  evolution.needs = needed_balls();
  evolution.step = [](Context& context, const Evolution_state& before, std::uint64_t step) {
    return grow(context, before, -context.setting(growing_step_setting), step);
  };
  return evolution;
}

Evolution_spec stepped_growing() {
  Evolution_spec evolution;
  evolution.id = "stepped-growing";
  evolution.label = "Stepped growing";
  evolution.help =
      "Each step takes the medial balls of the union, without sheets whose largest contact angle is less than "
      "{scale-axis-min-angle}, and grows them by {growing-step} percent: always the present medial balls grow, not "
      "those "
      "at the beginning, so fewer new sheets come than with {grow-balls}. Centers are moved as {perturbation} says. "
      "[B. "
      "Miklos: The Scale Axis Transform, 2010, "
      "section A.2]";
  evolution.settings = {std::string(growing_step_setting.id), std::string(min_angle_setting.id),
                        std::string(perturbation_setting.id)};
  evolution.needs = needed_balls();
  evolution.step = grow_medial_balls;
  return evolution;
}

}  // namespace

void register_evolutions_3(Registry& registry) {
  registry.begin_module({"evolutions-3", "Evolutions", "Steps that change meshes, points and balls again and again."});
  add_smoothing_settings(registry);
  add_noise_settings(registry);
  add_growing_settings(registry);
  registry.add_evolution(smoothing());
  registry.add_evolution(noise());
  registry.add_evolution(growing());
  registry.add_evolution(shrinking());
  registry.add_evolution(stepped_growing());
}

}  // namespace mesecina
