// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/progress.h"
#include "geometries/solid_3/box_tree_3.h"
#include "geometries/solid_3/crossing_3.h"
#include "geometries/surface_3/union_boundary_3.h"

namespace mesecina {

/// Answers questions about a union of balls and its boundary. Safe to ask from several threads. Positions are those of
/// balls in the order of a tree. All answers are to rounding.
class Union_distance_3 {
 public:
  /// Keeps a reference to `boundary`. O(n log n).
  Union_distance_3(const Union_boundary_3& boundary, Progress& progress);

  struct Nearest {
    /// To the nearest ball; where the point is in the union, minus how deep it is in the ball in which it is deepest.
    double distance = 0;
    int position = 0;
  };
  /// Fast when the ball at position `guess` is nearly the nearest one.
  Nearest nearest(const Point_3& p, int guess) const;
  /// No ball has a point in the interior of common with the triangle.
  bool is_free(const Corners_3& triangle) const;
  /// To the nearest point of the boundary, of a point in the union. Slow: it tries all boundary pieces that may be
  /// near.
  double depth(const Point_3& p) const;

  const Ball_3& ball_at(int position) const { return balls_[position]; }
  std::size_t ball_count() const { return balls_.size(); }
  /// Balls that together cover all of the sphere of a ball that is not on the boundary.
  std::span<const int> neighbors(int ball) const {
    return std::span(neighbors_).subspan(first_neighbor_[ball], first_neighbor_[ball + 1] - first_neighbor_[ball]);
  }

 private:
  /// A point of the sphere of a ball is on the boundary.
  bool is_exposed(int ball, const Point_3& p) const;

  const Union_boundary_3& boundary_;
  std::vector<int> first_neighbor_;
  std::vector<int> neighbors_;
  std::vector<int> first_circle_;  ///< per ball, into `circles_`
  std::vector<int> circles_;       ///< greater balls whose spheres meet it on the boundary
  Box_tree_3 tree_;                ///< of centers
  std::vector<int> numbers_;       ///< by position
  std::vector<Ball_3> balls_;      ///< by position
  std::vector<double> largest_;    ///< per node of the tree, the largest radius
  Box_tree_3 vertex_tree_;
};

}  // namespace mesecina
