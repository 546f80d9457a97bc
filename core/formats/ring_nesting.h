// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// Numbers of the rings of one polygon: its outer ring, then its holes in the order of the outline.
using Polygon_rings = std::vector<std::size_t>;

/// The polygons of an outline, in the order of their outer rings: a ring inside an even number of others is an outer
/// one, the others are holes of the smallest ring around them. Exact; rings must not cross each other or themselves
/// (see find_crossings), else the polygons mean little, but every ring is in one. Time: the sum over pairs of rings,
/// where one lies in the other's bounding box, of the size of the other.
std::vector<Polygon_rings> nest_rings(const Outline_2& outline);

}  // namespace mesecina
