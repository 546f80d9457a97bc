// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometries/scale_axis_2/scale_axis_2.h"

namespace mesecina::test {

/// What is computed on the way from disks to their scale axis, as the graph does it.
struct Scale_stages {
  double scale = 1;
  std::shared_ptr<const Union_boundary_2> boundary;
  Union_medial_axis_2 axis;
  std::shared_ptr<const Union_boundary_2> grown_boundary;
  Union_medial_axis_2 grown_axis;

  const Balls_2& grown_disks() const { return *grown_boundary->dual->regular->balls; }
  /// Largest coordinate or radius of the grown disks.
  double extent() const;
  Scale_axis_2 scale_axis(double min_angle = 30, double sampling_min_angle = 150) const;
};
Scale_stages scale_stages(const std::shared_ptr<const Balls_2>& balls, double scale);
/// The same input at another scale.
Scale_stages at_scale(const Scale_stages& stages, double scale);

/// A square given twice: its insides cancel out.
inline Outline_2 double_square() {
  const Ring_2 square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return {{square, square}};
}

/// Components and cycles.
using Betti = std::array<std::int64_t, 2>;
Betti betti_of_graph(std::size_t vertices, const std::vector<std::array<int, 2>>& edges);
Betti betti(const Union_boundary_2& boundary);
std::string to_text(const Betti& betti);

/// The medial disks with radii times the scale.
std::shared_ptr<const Balls_2> grown_medial_disks(const Union_medial_axis_2& axis, double scale);
/// Betti numbers of the union of disks, by their dual complex.
Betti betti_of_union(const std::shared_ptr<const Balls_2>& balls);

/// From a point to the boundary of a union, trying every arc.
double distance_to_boundary(const Union_boundary_2& boundary, const Point_2& point);
/// Whether a point is at most `tolerance` away from one of the disks.
bool is_in_union(const Balls_2& balls, const Point_2& point, double tolerance);

}  // namespace mesecina::test
