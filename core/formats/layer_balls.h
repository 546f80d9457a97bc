// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/primitives.h"

namespace mesecina {

/// One per vertex: `radii`, or where the set has none, that of the largest ball there, 0 for none. Empty if the set has
/// neither radii nor balls.
std::vector<double> vertex_radii(const Primitive_set& set);

/// Those of all vertices if the set has radii, else those that are elements, in their order.
std::vector<Ball_3> layer_balls(const Primitive_set& set);

}  // namespace mesecina
