// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/power_crust_3/power_crust_3.h"

namespace mesecina {

/// The poles of the samples of the mesh, or without a mesh of the points that were read, with their sides.
inline constexpr Key<Polar_balls_3> polar_balls_3_key{"polar-balls-3"};
inline constexpr Key<Power_crust_3> power_crust_3_key{"power-crust-3"};
inline constexpr Key<Dual_3> power_shape_3_key{"power-shape-3"};

/// Power crust: poles of the samples, their sides, and the surface and shape between them.
void register_power_crust_3(Registry& registry);

}  // namespace mesecina
