// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs.h"
#include "core/registry.h"
#include "geometries/witness_2/witness_2.h"

namespace mesecina {

/// Samples that were chosen, in the order in which they were: what the evolution max-min-landmarks adds to.
inline constexpr Input_key<std::vector<Point_2>> landmarks_input{"landmarks"};

inline constexpr Key<Witnesses_2> witnesses_2_key{"witnesses-2"};

/// Landmarks among the samples, their Delaunay triangulation and their witness complex, and the evolution that adds
/// them.
void register_witness_2(Registry& registry);

}  // namespace mesecina
