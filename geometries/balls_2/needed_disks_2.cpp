// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/balls_2/needed_disks_2.h"

#include <string>

#include "core/inputs.h"
#include "geometries/balls_2/module.h"

namespace mesecina {

namespace {

std::string why_no_disks(const Evolution_state& state) {
  const auto disks = state.inputs.get(disks_input);
  const auto points = state.inputs.get(points_input);
  const auto outline = state.inputs.get(outline_input);
  const bool has_disks = disks && !disks->empty();
  const bool has_samples = (points && !points->empty()) || (outline && !outline->rings.empty());
  const Setting_value* source = state.settings.find(ball_source_setting.id);
  const auto is_source = [source](std::string_view name) {
    return source && *source == Setting_value(std::string(name));
  };
  if (is_source(ball_source_drawn))
    return has_disks ? "" : "there are no disks: draw, generate or open some, or choose another {ball-source}";
  if (is_source(ball_source_inner_voronoi) || is_source(ball_source_inner_poles))
    return has_samples
               ? ""
               : "there are no points or outline to take disks from: choose another {ball-source}, or draw some";
  return has_disks || has_samples
             ? ""
             : "there are no disks, and no points or outline to take them from: draw, generate or open some";
}

}  // namespace

Evolution_needs needed_disks_2() { return {"disks, or points or an outline to take them from", why_no_disks}; }

}  // namespace mesecina
