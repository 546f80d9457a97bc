// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/regular_2/regular_2.h"

namespace mesecina {

inline constexpr Key<Regular_2> regular_2_key{"regular-triangulation-2"};
inline constexpr Key<Power_vertices_2> power_vertices_2_key{"power-vertices-2"};

/// All edges of a regular triangulation. Ids: three per triangle, one per corner; on a line their order on it.
Primitive_set regular_triangulation_primitives(const Regular_2& regular);
/// The power diagram: segments and rays; its power vertices are the first vertices. Ids as above, those of the rays
/// last.
Primitive_set power_diagram_primitives(const Regular_2& regular, const Power_vertices_2& power);

/// Regular triangulation and power diagram of the disks.
void register_regular_2(Registry& registry);

}  // namespace mesecina
