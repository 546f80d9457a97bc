// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

inline constexpr Key<Regular_3> regular_3_key{"regular-3"};
/// The edges of the regular triangulation, as edges_of gives them.
inline constexpr Key<std::vector<std::array<int, 2>>> regular_edges_3_key{"regular-edges-3"};
inline constexpr Key<Dual_3> dual_3_key{"dual-3"};
inline constexpr Key<Union_vertices_3> union_vertices_3_key{"union-vertices-3"};
inline constexpr Key<Medial_complex_3> medial_axis_3_key{"medial-axis-3"};

/// Tells the user when the axis has not the topology of the union, and what to do.
void warn_of_special_positions(Context& context, const Medial_complex_3& axis, const Dual_3& dual);

/// The union of balls: regular triangulation, dual complex, vertices of the boundary; and the medial axis, without its
/// layers.
void register_union_3(Registry& registry);

}  // namespace mesecina
