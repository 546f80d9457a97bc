// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/filtration/limits.h"
#include "geometries/medial_axis_2/module.h"

namespace mesecina {

inline constexpr Setting<bool> topology_preserving_setting{"topology-preserving"};

inline constexpr Key<Importance_2> scale_2_key{"scale-importance-2"};

/// Filtrations of the medial axis by lambda, contact angle and scale, plain and topology preserving.
void register_medial_filtrations_2(Registry& registry);

}  // namespace mesecina
