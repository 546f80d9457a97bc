// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// Points and balls, both sorted, each once.
struct Selection_3 {
  std::vector<std::size_t> points{};
  std::vector<std::size_t> balls{};
  bool is_empty() const { return points.empty() && balls.empty(); }
  std::size_t size() const { return points.size() + balls.size(); }
  bool operator==(const Selection_3&) const = default;
};

/// What can be taken hold of.
struct Reach_3 {
  bool points = true;
  bool balls = true;
};

// Each of these is linear in the size of the inputs, and what they return holds only the keys that the inputs had,
// unless it says so. Selections that point beyond the data are ignored there.

Selection_3 all_of(const Inputs& inputs, const Reach_3& reach);
/// What is in exactly one of them.
Selection_3 toggled(const Selection_3& first, const Selection_3& second);
Selection_3 united(const Selection_3& first, const Selection_3& second);
bool contains(const Selection_3& selection, const Selection_3& part);
/// Without what the inputs do not have.
Selection_3 restricted(const Selection_3& selection, const Inputs& inputs);

/// Of points and centers of balls, in this order.
std::vector<Point_3> positions(const Inputs& inputs, const Selection_3& selection);
std::vector<Ball_3> selected_balls(const Inputs& inputs, const Selection_3& selection);
Inputs moved(const Inputs& inputs, const Selection_3& selection, const Point_3& shift);
/// With the radii of the selected balls multiplied. A radius that would not stay finite, or positive if it is so, is
/// kept.
Inputs resized(const Inputs& inputs, const Selection_3& selection, double factor);
/// Points and balls go where none is left.
Inputs without(const Inputs& inputs, const Selection_3& selection);
/// With copies of the selected points and balls, moved. The second is the selection of the copies.
std::pair<Inputs, Selection_3> duplicated(const Inputs& inputs, const Selection_3& selection, const Point_3& shift);
/// With another point or ball under this index.
Inputs with_point(const Inputs& inputs, std::size_t index, const Point_3& point);
Inputs with_ball(const Inputs& inputs, std::size_t index, const Ball_3& ball);

}  // namespace mesecina
