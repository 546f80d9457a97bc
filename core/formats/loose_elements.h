// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/primitives.h"

namespace mesecina {

/// The points and segments of a set that tell more than its other elements do: of a complex in space those that bound
/// no other element, of other sets all. For formats without values.
struct Loose_elements {
  std::vector<int> points;
  std::vector<std::array<int, 2>> segments;
};

/// O(n log n).
Loose_elements loose_elements(const Primitive_set& set);

}  // namespace mesecina
