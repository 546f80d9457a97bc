// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// The boundary of a union of balls as patches of spheres between arcs. Which arcs and patches there are is read from
/// the dual complex alone: it is the boundary of a regular neighbourhood of that complex, so a closed oriented surface
/// whatever the positions, in which spheres may meet in one point or touch.
struct Union_boundary_3 {
  /// Where two spheres meet.
  struct Arc {
    std::array<int, 2> balls{};  ///< ascending
    int from = -1;               ///< vertex; -1 for a whole circle
    int to = -1;
    Point_3 center;
    double radius = 0;
    double angle = 0;  ///< in [0, 2 pi]; 0 only where rounding puts both ends at one place
    Point_3 start;     ///< unit vector from the center toward `from`
    Point_3 side;      ///< unit vector toward the point a quarter of a turn after it

    /// The k-th of n equal steps from `from` to `to`, which run counterclockwise about the axis from the first ball to
    /// the second.
    Point_3 point(int k, int n) const;
  };
  /// An arc in a loop: on the second ball it is run through forward, on the first backward, so that the patch is on the
  /// left for who looks from outside.
  struct Side {
    int arc = 0;
    bool is_forward = true;
  };

  std::shared_ptr<const Dual_3> dual;
  std::vector<Point_3> vertices;  ///< one per triangle of the dual complex and side of it on which no cell is in it
  std::vector<Arc> arcs;
  std::vector<Side> sides;
  std::vector<int> loop_offsets;   ///< into sides
  std::vector<int> patch_offsets;  ///< into loops; whole spheres have none
  std::vector<int> patch_balls;    ///< per patch

  std::size_t patch_count() const { return patch_balls.size(); }
  std::span<const Side> loop(int i) const {
    return std::span(sides).subspan(loop_offsets[i], loop_offsets[i + 1] - loop_offsets[i]);
  }
};

/// O(n log n) with a small constant, for n cells of the regular triangulation.
Union_boundary_3 union_boundary(std::shared_ptr<const Dual_3> dual, Progress& progress);

}  // namespace mesecina
