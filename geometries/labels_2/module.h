// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/labels_2/labels_2.h"

namespace mesecina {

inline constexpr Key<Labels_2> labels_2_key{"labels-2"};
inline constexpr Setting<double> normal_length_setting{"normal-length"};

/// Inside and outside: labels of the Voronoi vertices, and what is drawn from them.
void register_labels_2(Registry& registry);

}  // namespace mesecina
