// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "geometries/union_3/union_3.h"

namespace mesecina {

/// The Delaunay triangulation of V(U), and what its cells are in the medial axis of the union.
struct Vertex_voronoi_3 {
  std::vector<Point_3> points;    ///< V(U), points at equal places once
  std::vector<int> ball_offsets;  ///< per point the balls on whose spheres it lies, ascending
  std::vector<int> balls;
  /// Points; -1 in place of one in cells around the hull. Empty when all points lie in a plane.
  std::vector<std::array<int, 4>> cells;
  std::vector<std::array<int, 4>> neighbors;
  /// Per cell the ball on whose sphere all its points lie: its Voronoi vertex is that center. -1 for none. Of several
  /// such balls one that has cells of full dimension.
  std::vector<int> ball_of_cell;
  /// Per cell: its Voronoi vertex lies in the dual complex.
  std::vector<std::uint8_t> is_inner;
  std::vector<Point_3> centers;  ///< per inner cell that has no ball, its circumcenter

  std::span<const int> balls_of(int point) const {
    return std::span(balls).subspan(ball_offsets[point], ball_offsets[point + 1] - ball_offsets[point]);
  }
  bool has_ball(int point, int ball) const {
    // Nearly all points have three or four.
    constexpr std::size_t few = 8;
    const auto own = balls_of(point);
    return own.size() <= few ? std::ranges::find(own, ball) != own.end() : std::ranges::binary_search(own, ball);
  }
  /// Calls use(ball) for each ball that all these points have, ascending.
  template <class Use>
  void for_common_balls(std::span<const int> some, const Use& use) const {
    for (const int ball : balls_of(some.front()))
      if (std::ranges::all_of(some.subspan(1), [&](int point) { return has_ball(point, ball); })) use(ball);
  }
};

/// O(n log n) along surfaces.
Vertex_voronoi_3 vertex_voronoi(const Union_vertices_3& vertices, Progress& progress);

}  // namespace mesecina
