// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/union_2/union_boundary_2.h"
#include "geometries/union_2/union_medial_axis_2.h"

namespace mesecina {

inline constexpr Key<Union_boundary_2> union_boundary_2_key{"union-boundary-2"};
inline constexpr Key<Union_voronoi_2> union_voronoi_2_key{"union-voronoi-2"};
/// With its incomplete edges.
inline constexpr Key<Union_medial_axis_2> union_medial_axis_2_key{"union-medial-axis-2"};
inline constexpr Setting<bool> complete_faces_only_setting{"complete-faces-only"};

/// The boundary as arcs and whole circles, isolated disks of radius 0 as points; ids: the disks. A whole circle without
/// a vertex of the union begins and ends at its rightmost point.
Primitive_set boundary_primitives(const Union_boundary_2& boundary);
/// What an element of that is: its disk.
Element_description describe_boundary_element(const Union_boundary_2& boundary, std::size_t element);
/// The axis: medial disks without an edge as points, then the edges, without the incomplete ones if asked for; one
/// vertex per medial disk; values lambda and angle.
Primitive_set union_axis_primitives(const Union_medial_axis_2& axis, bool complete_only);
/// What an element of that is: its contacts, radii and medial disks.
Element_description describe_union_axis_element(const Union_medial_axis_2& axis, bool complete_only,
                                                std::size_t element);

/// Boundary, vertices and medial axis of the union of the disks.
void register_union_2(Registry& registry);

}  // namespace mesecina
