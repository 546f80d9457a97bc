// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometries/delaunay_3/delaunay_3.h"
#include "geometries/power_crust_3/power_crust_3.h"
#include "geometries/solid_3/solid_3.h"

namespace mesecina {

/// On which side of a shape Voronoi vertices lie. Cells with one sphere are one Voronoi vertex.
struct Voronoi_sides_3 {
  std::vector<int> vertex_of_cell;     ///< per cell the least one with the same sphere
  std::vector<std::uint8_t> is_inner;  ///< per cell
};

/// Inside of the solid, or on its surface. Voronoi vertices are rounded, then it is exact. O(n log n).
Voronoi_sides_3 sides_of_solid(const Delaunay_3& triangulation, const Solid_3& solid, Progress& progress);

/// Inside of the power crust: nearer, in the power distance, to some inner pole than to all outer ones; rounded.
/// `polar`: the poles of the points of the triangulation. O(n) for points of a surface.
Voronoi_sides_3 sides_of_power_crust(const Delaunay_3& triangulation, const Polar_balls_3& polar, Progress& progress);

/// The triangles between an inner Voronoi vertex's tetrahedron and what is not one, as sites: the boundary of the inner
/// tetrahedra, normals (right-hand rule) outward. O(n).
std::vector<std::array<int, 3>> boundary_of_inner_cells(const Delaunay_3& triangulation, const Voronoi_sides_3& sides);

/// The bounded Voronoi faces of which all vertices are inner.
Voronoi_faces_3 inner_voronoi_faces(const Delaunay_3& triangulation, const Voronoi_sides_3& sides, Progress& progress);

}  // namespace mesecina
