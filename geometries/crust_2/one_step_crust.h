// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometries/delaunay_2/delaunay_2.h"

namespace mesecina {

/// True iff the Delaunay edge pq with opposite corners r and s belongs to the one-step crust:
/// cot(prq) cot(psq) >= 1. Exact. [C. Gold, J. Snoeyink: A one-step crust and skeleton extraction algorithm,
/// Algorithmica 2001]
bool is_crust_edge(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& s);
/// The same for an edge of the hull: s is at infinity, so the angle prq must be acute. Exact.
bool is_crust_hull_edge(const Point_2& p, const Point_2& q, const Point_2& r);

struct Crust_2 {
  /// Per triangle, bit i: the edge opposite to corner i is in the crust. Both triangles of an edge agree.
  std::vector<std::uint8_t> edges_of_triangle;
  /// The crust itself: pairs of points. Sites on one line: all pairs of neighbours on it.
  std::vector<std::array<int, 2>> edges;
  bool contains(int triangle, int corner) const { return (edges_of_triangle[triangle] >> corner) & 1; }
};

/// O(n). Same result for every number of threads.
Crust_2 one_step_crust(const Delaunay_2& triangulation, Progress& progress);

}  // namespace mesecina
