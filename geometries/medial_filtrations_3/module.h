// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/filtration/limits.h"
#include "geometries/medial_filtrations_3/source_balls_3.h"
#include "geometries/union_3/medial_values_3.h"

namespace mesecina {

inline constexpr Key<Medial_values_3> lambda_3_key{"lambda-importance-3"};
inline constexpr Key<Medial_values_3> angle_3_key{"angle-importance-3"};
inline constexpr Key<Medial_values_3> scale_3_key{"scale-importance-3"};
inline constexpr Key<Source_balls_3> source_balls_3_key{"source-balls-3"};

/// The medial axis of the union of the balls with the values of its faces, edges and vertices, and its filtrations by
/// lambda, contact angle and scale.
void register_medial_filtrations_3(Registry& registry);

}  // namespace mesecina
