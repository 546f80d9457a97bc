// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/power_crust_2/power_crust_2.h"

namespace mesecina {

/// The poles of the samples with their sides; `inner_triangles` chooses the triangles of delaunay_2_key that the inner
/// polar disks are circumscribed to.
inline constexpr Key<Polar_balls_2> polar_balls_2_key{"polar-balls-2"};
inline constexpr Key<Polar_diagram_2> polar_power_diagram_2_key{"polar-power-diagram-2"};

/// Power crust: poles of the samples, their sides, and the curve and shape between them.
void register_power_crust_2(Registry& registry);

}  // namespace mesecina
