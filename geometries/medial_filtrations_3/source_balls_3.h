// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometries/union_3/union_3.h"

namespace mesecina {

/// The balls of a union on whose spheres the contacts of the faces of its medial axis lie.
struct Source_balls_3 {
  std::vector<int> offsets;  ///< two per face, one for each contact, and one more; into balls
  std::vector<int> balls;

  /// Ascending, three or more; `which`: 0 or 1.
  std::span<const int> of_contact(std::size_t face, std::size_t which) const {
    const std::size_t i = 2 * face + which;
    return std::span(balls).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
};

/// `vertices`: those that the axis was made of. O(n log n).
Source_balls_3 source_balls(const Medial_complex_3& axis, const Union_vertices_3& vertices);

}  // namespace mesecina
