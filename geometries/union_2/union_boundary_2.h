// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "geometries/dual_2/dual_2.h"

namespace mesecina {

/// A piece of the boundary of the union, counterclockwise on its circle, between two vertices of the union; both -1 for
/// a whole circle without a vertex, both the same for a whole circle with one.
struct Boundary_arc {
  int ball = 0;
  int from = -1;
  int to = -1;
};

/// Boundary and vertices of a union of disks: V(U), the points where circles meet on the boundary, each once.
/// Which vertices there are, which circles pass through each and how arcs join them is exact; positions are rounded.
struct Union_boundary_2 {
  std::shared_ptr<const Dual_2> dual;
  std::vector<double> radii;  ///< per disk: sqrt(r^2 + alpha), 0 where that is negative
  std::vector<Point_2> vertices;
  /// Per vertex what is to be added to it: vertices are known to about twice the digits of a double, as some are much
  /// nearer to each other than to the origin. Empty: nothing, all are samples.
  std::vector<Point_2> vertex_rests;
  std::vector<int> samples;         ///< per vertex the sample that it is; -1 where none (known)
  std::vector<int> source_offsets;  ///< vertices.size() + 1 offsets into `sources`
  std::vector<int> sources;         ///< per vertex the disks, not hidden, whose circles pass through it, ascending
  /// Per edge of the dual complex its vertices of the union, on the left and on the right of a -> b; -1 where there is
  /// none. Both the same where two circles touch.
  std::vector<std::array<int, 2>> vertices_of_edge;
  std::vector<Boundary_arc> arcs;  ///< those of one boundary curve follow each other
  /// Per disk a disk that covers it although it has a vertex in the dual complex: it touches that one from inside. -1
  /// for all others.
  std::vector<int> covered_by;

  std::span<const int> sources_of(int vertex) const {
    return std::span(sources).subspan(source_offsets[vertex], source_offsets[vertex + 1] - source_offsets[vertex]);
  }
};

/// A boundary edge of the dual complex gives two vertices if it is singular, else one: that on the side away from its
/// triangle. O(n).
Union_boundary_2 union_boundary(std::shared_ptr<const Dual_2> dual, Progress& progress);

/// All together for a set of disks.
Union_boundary_2 union_boundary(std::shared_ptr<const Balls_2> balls, double alpha, Progress& progress);

}  // namespace mesecina
