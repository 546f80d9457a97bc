// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <utility>
#include <vector>

#include "core/graph.h"
#include "geometries/balls_2/module.h"
#include "geometries/balls_2/needed_disks_2.h"
#include "geometries/evolution_settings.h"
#include "geometries/evolutions_2/evolutions.h"
#include "geometries/scale_axis_2/module.h"
#include "geometries/union_2/module.h"

namespace mesecina {

namespace {

/// The state with these disks, grown, as those whose union is looked at, whatever they came from.
Evolution_state with_disks(const Evolution_state& before, const std::vector<Point_2>& centers,
                           const std::vector<double>& radii, double factor) {
  std::vector<Disk_2> disks;
  disks.reserve(centers.size());
  for (std::size_t d = 0; d < centers.size(); ++d) disks.push_back({centers[d], radii[d] * factor});
  Evolution_state after = before;
  after.inputs = before.inputs.with(disks_input, std::move(disks));
  const Setting_value* source = before.settings.find(ball_source_setting.id);
  if (source && *source != Setting_value(std::string(ball_source_drawn)))
    after.settings = before.settings.without(ball_source_setting.id);
  return after;
}

Evolution_state grow(Context& context, const Evolution_state& before, double percent, std::uint64_t step) {
  const auto balls = context.get(balls_2_key);
  const double factor = growth_of_step(percent, step);
  if (factor == 0) throw Unavailable("the disks have shrunk to nothing");
  if (factor == 1) return before;
  return with_disks(before, balls->centers, balls->radii, factor);
}

Evolution_state grow_medial_disks(Context& context, const Evolution_state& before, std::uint64_t) {
  const double factor = 1 + context.setting(growing_step_setting) / 100;
  if (factor == 1) return before;
  constexpr double not_shrunk = 1;
  constexpr double not_sampled = 0;
  const auto axis = context.get(union_medial_axis_2_key);
  const double min_angle = context.setting(scale_axis_min_angle_setting);
  if (min_angle == 0) return with_disks(before, axis->centers, axis->radii, factor);
  const Scale_axis_2 pruned = scale_axis(*axis, not_shrunk, min_angle, not_sampled, context.progress());
  return with_disks(before, pruned.centers, pruned.radii, factor);
}

constexpr const char* which_disks =
    " Of points and outlines, the disks that {ball-source} says, inner Voronoi disks at first, become given disks in "
    "the "
    "first step.";

}  // namespace

Evolution_spec growing_2() {
  Evolution_spec evolution;
  evolution.id = "grow-balls";
  evolution.label = "Growing disks";
  evolution.help =
      std::string("Each step makes all disks larger by {growing-step} percent of the radius that they had at first.") +
      which_disks + " [B. Miklos: The Scale Axis Transform, 2010, section 5.2]";
  evolution.settings = {std::string(growing_step_setting.id), std::string(ball_source_setting.id)};
  evolution.needs = needed_disks_2();
  evolution.step = [](Context& context, const Evolution_state& before, std::uint64_t step) {
    return grow(context, before, context.setting(growing_step_setting), step);
  };
  return evolution;
}

Evolution_spec shrinking_2() {
  Evolution_spec evolution;
  evolution.id = "shrink-balls";
  evolution.label = "Shrinking disks";
  evolution.help = std::string(
                       "Each step makes all disks smaller by {growing-step} percent of the radius that they had at "
                       "first; ends before nothing is left.") +
                   which_disks;
  evolution.settings = {std::string(growing_step_setting.id), std::string(ball_source_setting.id)};
  evolution.needs = needed_disks_2();
  evolution.step = [](Context& context, const Evolution_state& before, std::uint64_t step) {
    return grow(context, before, -context.setting(growing_step_setting), step);
  };
  return evolution;
}

Evolution_spec stepped_growing_2() {
  Evolution_spec evolution;
  evolution.id = "stepped-growing";
  evolution.label = "Stepped growing";
  evolution.help =
      "Each step takes the medial disks of the union, without branches that end with a contact angle of less than "
      "{scale-axis-min-angle}, and grows them by {growing-step} percent: always the present medial disks grow, not "
      "those "
      "at the beginning, so fewer new branches come than with {grow-balls}. [B. Miklos: The Scale Axis Transform, "
      "2010, "
      "section A.2]";
  evolution.settings = {std::string(growing_step_setting.id), std::string(scale_axis_min_angle_setting.id)};
  evolution.needs = needed_disks_2();
  evolution.step = grow_medial_disks;
  return evolution;
}

}  // namespace mesecina
