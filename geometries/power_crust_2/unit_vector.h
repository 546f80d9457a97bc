// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/point.h"

namespace mesecina {

/// Of length 1; not a number where both points are the same.
inline Point_2 unit_vector(const Point_2& from, const Point_2& to) {
  const double length = distance(from, to);
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

}  // namespace mesecina
