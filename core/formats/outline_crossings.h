// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/inputs.h"

namespace mesecina {

/// A side of a ring: from vertex `segment` to the next one.
struct Outline_side {
  std::size_t ring = 0;
  std::size_t segment = 0;
  auto operator<=>(const Outline_side&) const = default;
};

/// Pairs of sides that have interior points in common: they cross, or overlap in more than a point. Sides that only
/// touch, at an end of one of them, are not counted.
struct Outline_crossings {
  std::size_t count = 0;
  bool is_complete = true;  ///< false: the search ended after a million crossings and the pair is just one of them
  Outline_side first;       ///< of the smallest pair; first < second
  Outline_side second;
  Point_2 place;  ///< near the crossing of this pair
};

/// Exact for finite coordinates. About n log n plus the number of sides whose bounding boxes meet.
Outline_crossings find_crossings(const Outline_2& outline);

}  // namespace mesecina
