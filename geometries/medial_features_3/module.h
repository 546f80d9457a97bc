// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/medial_features_3/medial_features_3.h"

namespace mesecina {

/// Of the medial axis of the union of the balls.
inline constexpr Key<Medial_features_3> medial_features_3_key{"medial-features-3"};
/// Of the scale axis before it is sampled.
inline constexpr Key<Medial_features_3> scale_axis_features_3_key{"scale-axis-features-3"};

/// Sheets, seams, rims and junctions of the medial axis.
void register_medial_features_3(Registry& registry);
/// Seams, rims and junctions of the scale axis.
void register_scale_axis_features_3(Registry& registry);

}  // namespace mesecina
