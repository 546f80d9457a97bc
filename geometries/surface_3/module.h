// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/surface_3/union_surface_3.h"

namespace mesecina {

/// Of the union of the balls.
inline constexpr Key<Union_surface_3> union_surface_3_key{"union-surface-3"};
/// Of the union of the balls of the scale axis, shrunk back.
inline constexpr Key<Union_surface_3> scale_axis_surface_3_key{"scale-axis-surface-3"};

/// From balls back to surfaces.
void register_surface_3(Registry& registry);

}  // namespace mesecina
