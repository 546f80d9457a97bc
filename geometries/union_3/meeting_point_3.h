// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// One of the two points where the spheres of three balls meet: on the side to which the normal (right-hand rule) of
/// their centers points, or on the other one.
struct Meeting_name_3 {
  std::array<int, 3> balls{};
  bool is_above = false;
};

/// Where that is, all in exact numbers but the last root; where the spheres do not meet, the point between them. Slow.
/// Centers must not be on a line.
Point_3 exact_meeting_point(const Ball_3& a, const Ball_3& b, const Ball_3& c, bool is_above);

/// Which points are one, exactly: per name the first one of the same point. Only among names whose rounded points,
/// given by `points`, are as near as rounding may move them are there any. Spheres must meet, and centers must not be
/// on a line. O(n log n) where few points are so near to each other.
std::vector<int> first_of_same_points(std::span<const Ball_3> balls, std::span<const Meeting_name_3> names,
                                      std::span<const Point_3> points, Progress& progress);

}  // namespace mesecina
