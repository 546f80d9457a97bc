// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/delaunay_2/delaunay_2.h"

namespace mesecina {

inline constexpr Key<Delaunay_2> delaunay_2_key{"delaunay-triangulation-2"};
inline constexpr Key<Voronoi_2> voronoi_2_key{"voronoi-vertices-2"};

/// Number of an edge that layers give as the element's id: three per triangle, one per corner.
inline std::int64_t edge_id(int triangle, int corner) { return std::int64_t{3} * triangle + corner; }

/// Appends the Voronoi edge dual to a Delaunay edge of a triangulation of dimension 2: a segment between vertices
/// `first_vertex` + triangle, or a ray.
void add_dual_edge(Primitive_set& set, const Delaunay_2& triangulation, int triangle, int corner, int first_vertex);
/// Unit direction of the ray dual to a hull edge.
Point_2 ray_direction(const Delaunay_2& triangulation, int triangle, int corner);

/// Delaunay triangulation, Voronoi diagram and Voronoi disks of the samples.
void register_delaunay_2(Registry& registry);

}  // namespace mesecina
