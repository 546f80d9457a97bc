// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/progress.h"
#include "core/registry.h"

namespace mesecina {

/// The corners of the convex hull of some points.
struct Convex_hull_2 {
  std::vector<int> corners;  ///< indices of points; counterclockwise from the leftmost (then lowest) one
};

/// Only proper corners: no point between two others on a side, of equal points the first one. One corner for points
/// that are all equal, two for points on a line, none for no points. Exact; coordinates must be finite. O(n log n).
/// Throws Cancelled. [A. Andrew: Another efficient algorithm for convex hulls in two dimensions, 1979]
Convex_hull_2 convex_hull(std::span<const Point_2> points, Progress& progress);

inline constexpr Key<Convex_hull_2> convex_hull_2_key{"convex-hull-2"};

/// The layer `convex-hull`.
void register_convex_hull_2(Registry& registry);

}  // namespace mesecina
