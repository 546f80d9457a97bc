// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// Per ball its neighbours in a regular triangulation, ascending.
struct Ball_neighbors_3 {
  std::vector<int> offsets;
  std::vector<int> balls;
  std::span<const int> of(int ball) const {
    return std::span(balls).subspan(offsets[ball], offsets[ball + 1] - offsets[ball]);
  }
};
/// O(n log n).
Ball_neighbors_3 neighbors_of_balls(const Regular_3& regular);

}  // namespace mesecina
