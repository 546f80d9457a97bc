// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/inputs.h"
#include "geometries/crust_2/one_step_crust.h"
#include "geometries/delaunay_2/delaunay_2.h"

namespace mesecina {

/// Which Voronoi vertices lie inside the shape, and where the evidence disagrees.
struct Labels_2 {
  std::vector<std::uint8_t> is_inner;  ///< per triangle: its Voronoi vertex is inside
  /// Delaunay edges (pairs of points) across which the labels do not do what the crust says: equal on both sides of a
  /// crust edge, or different across another one. None for a well sampled closed curve.
  std::vector<std::array<int, 2>> conflicts;
};

/// Labels by flooding Voronoi vertices from infinity, which is outside, and changing side across each crust edge.
/// Without contradictions the answer does not depend on the order. With them (open, noisy, undersampled curves) the
/// surest edges are flooded first: those with the largest |log(cot cot)|, infinite where an angle is not acute or the
/// edge is on the hull; of equally sure ones those with the lesser end points. The labels depend on the triangulation
/// only, not on the order of its triangles. O(n), with contradictions O(n log n).
Labels_2 flood_labels(const Delaunay_2& triangulation, const Crust_2& crust, Progress& progress);

/// Labels by the shape itself: a Voronoi vertex is inner iff it lies inside the outline by the even-odd rule.
/// `conflicts` then says where the crust disagrees, that is, where the outline is sampled too sparsely.
Labels_2 outline_labels(const Delaunay_2& triangulation, const Voronoi_2& voronoi, const Crust_2& crust,
                        const Outline_2& outline, Progress& progress);

/// Per query point: is it inside by the even-odd rule? Exact for the given coordinates; points on the boundary count to
/// one of the two sides. n + m time and memory for n edges and m queries where no place is crowded with edges much
/// longer than their distance, or where these run along a coordinate axis; time n m / 50 at the very worst (100 000
/// slanted lines side by side).
std::vector<std::uint8_t> is_inside(const Outline_2& outline, std::span<const Point_2> queries, Progress& progress);

}  // namespace mesecina
