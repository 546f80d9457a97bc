// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometries/balls_2/balls_2.h"

namespace mesecina {

/// Regular triangulation of disks, dual to their power diagram: as arrays, in the manner of Delaunay_2. The weight of a
/// disk is its squared radius, the power distance of a point x to it |x - center|^2 - radius^2. Vertices are the disks
/// with a power cell of positive area (of positive length when all centers are on a line); the others are hidden.
///
/// [H. Edelsbrunner, N. Shah: Incremental topological flipping works for regular triangulations, 1996]
struct Regular_2 {
  std::shared_ptr<const Balls_2> balls;
  std::vector<std::uint8_t> is_hidden;  ///< per disk; of equal disks the one of least index can be a vertex
  std::size_t vertex_count = 0;
  int dimension = -1;                         ///< -1 no disk, 0 one vertex, 1 vertices on a line, 2 otherwise
  std::vector<std::array<int, 3>> triangles;  ///< disks, counterclockwise
  std::vector<std::array<int, 3>> neighbors;  ///< triangle opposite to the corner; -1: the outside of the hull
  std::vector<int> line;                      ///< dimension 0 and 1: the vertices in their order on the line

  bool edge_is_listed(int triangle, int corner) const { return neighbors[triangle][corner] < triangle; }
  std::array<int, 2> edge(int triangle, int corner) const {
    const auto& t = triangles[triangle];
    return {t[(corner + 1) % 3], t[(corner + 2) % 3]};
  }
  /// The corner of neighbors[triangle][corner] that faces the same edge. The neighbour must not be -1.
  int mirror_corner(int triangle, int corner) const {
    const auto& n = neighbors[neighbors[triangle][corner]];
    return n[0] == triangle ? 0 : n[1] == triangle ? 1 : 2;
  }
  /// Where the disk is a corner of the triangle.
  int corner_of(int triangle, int ball) const {
    const auto& t = triangles[triangle];
    return t[0] == ball ? 0 : t[1] == ball ? 1 : 2;
  }
};

/// By exact predicates on the disks as they are (given: on centers and radii; circumscribed: on the samples). Where
/// four disks have one power vertex, some triangulation of their centers is given. Expected O(n log n). Throws
/// Cancelled.
Regular_2 regular_triangulation(std::shared_ptr<const Balls_2> balls, Progress& progress);

/// Per triangle the point of equal power distance to its three disks, rounded, and that power distance (negative inside
/// the disks).
struct Power_vertices_2 {
  std::vector<Point_2> vertices;
  std::vector<double> powers;
};
Power_vertices_2 power_vertices(const Regular_2& triangulation, Progress& progress);

}  // namespace mesecina
