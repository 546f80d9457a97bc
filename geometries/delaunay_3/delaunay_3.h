// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/point.h"
#include "core/progress.h"

namespace mesecina {

/// Delaunay triangulation of points in space, as arrays, with its Voronoi vertices. Sites are the distinct points; of
/// equal points the one with the least index is the site.
struct Delaunay_3 {
  std::vector<Point_3> points;  ///< as given, equal ones included
  std::vector<int> site;        ///< per point: index of the point that is its site (itself unless a duplicate)
  std::size_t site_count = 0;
  std::vector<std::array<int, 4>> cells;      ///< tetrahedra, as sites, with positive orientation
  std::vector<std::array<int, 4>> neighbors;  ///< per cell the cell across from each corner; -1: outside of the hull
  std::vector<Point_3> circumcenters;         ///< per cell its Voronoi vertex, rounded
  std::vector<double> circumradii;
};

/// Triangulates by exact predicates. The cells depend only on the points, also where more than four lie on one sphere;
/// there several cells have the same Voronoi vertex, each with its own rounding. Coordinates must be finite. O(n log n)
/// for points of a surface, about 600 bytes per point. Throws Cancelled, and Unavailable where there is no tetrahedron:
/// fewer than four sites, or all in one plane.
Delaunay_3 delaunay(const std::vector<Point_3>& points, Progress& progress);

/// Per cell the least cell that has the same sphere, decided exactly: cells with one sphere are one Voronoi vertex.
/// O(n).
std::vector<int> cells_by_sphere(const Delaunay_3& triangulation, Progress& progress);

/// The bounded faces of the Voronoi diagram: convex polygons.
struct Voronoi_faces_3 {
  std::vector<std::array<int, 2>> sites;  ///< per face the two sites that are nearest to it
  std::vector<int> offsets;               ///< size() + 1 offsets into `vertices`
  /// Of each face in order, as cells, counterclockwise when one looks from the second site to the first; of cells with
  /// one sphere the least.
  std::vector<int> vertices;

  std::size_t size() const { return sites.size(); }
  std::span<const int> face(std::size_t i) const {
    return std::span(vertices).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
};
/// Each face once, by its least cell. Faces without area, of Delaunay edges inside of one sphere, are none. O(n).
Voronoi_faces_3 bounded_voronoi_faces(const Delaunay_3& triangulation, Progress& progress);

}  // namespace mesecina
