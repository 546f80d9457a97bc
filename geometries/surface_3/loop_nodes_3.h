// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/point.h"

namespace mesecina {

/// Loops of points of which neighbours may be at one place, to rounding: each row of such points is one node, by its
/// first point; a loop that is nearly a point as a whole is one node too. Triangles between nodes become triangles
/// between the points.
class Loop_nodes_3 {
 public:
  /// Points nearer to each other than `same` are one node, and loops smaller than `tiny`.
  Loop_nodes_3(const std::vector<std::vector<Point_3>>& loops, double same, double tiny);

  /// Per node, of the point that stands for it.
  const std::vector<Point_3>& points() const { return points_; }
  /// Of the loops that are more than one node, each as its nodes.
  const std::vector<std::vector<int>>& loops() const { return loops_; }
  /// Two nodes are nearer to each other than `same`: loops touch each other, or themselves. O(n log n).
  bool has_touching_nodes() const;
  /// The nodes that are whole loops.
  const std::vector<int>& tiny_loops() const { return tiny_loops_; }

  /// From triangles between nodes, numbered from 0, and inner points, numbered after them, to triangles between the
  /// points of the loops, numbered one loop after the other, and inner points, numbered after these. Every tiny loop
  /// must have triangles all around it. O(n).
  std::vector<std::array<int, 3>> expanded(std::vector<std::array<int, 3>> triangles) const;

 private:
  void open_tiny_loop(int node, std::vector<std::array<int, 3>>& triangles) const;

  double same_ = 0;
  int point_count_ = 0;
  std::vector<Point_3> points_;
  std::vector<std::vector<int>> rows_;  ///< per node its points
  std::vector<std::vector<int>> loops_;
  std::vector<int> tiny_loops_;
};

}  // namespace mesecina
