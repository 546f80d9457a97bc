// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "geometries/delaunay_3/delaunay_3.h"

namespace mesecina {

/// Radius of the circle through three points; infinite when they are on a line. Rounded.
double circle_radius(const Point_3& a, const Point_3& b, const Point_3& c);

/// The corners of a cell but the one at `place`; their normal (right-hand rule) points away from that one.
std::array<int, 3> corners_across(const Delaunay_3& triangulation, int cell, int place);

/// The facets of the triangulation with nothing behind them, as sites: triangles of the boundary of the convex hull,
/// normals (right-hand rule) outward. Exact; a plane with more than three sites has several. O(n).
std::vector<std::array<int, 3>> hull_triangles(const Delaunay_3& triangulation);

/// The simplices of a triangulation whose smallest circumscribed ball has no site in its interior, as sites.
struct Gabriel_complex_3 {
  std::vector<std::array<int, 2>> edges;      ///< the lesser site first, ascending
  std::vector<std::array<int, 3>> triangles;  ///< edges of these need not be among the edges
};
/// Exact: sites on a sphere do not count as inside. O(n log n).
Gabriel_complex_3 gabriel_complex(const Delaunay_3& triangulation, Progress& progress);

}  // namespace mesecina
