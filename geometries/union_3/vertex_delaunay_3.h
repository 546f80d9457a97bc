// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/inputs.h"
#include "core/point.h"
#include "core/progress.h"

namespace mesecina {

/// Points of which many lie on one sphere, up to rounding.
struct Points_on_spheres_3 {
  std::span<const Point_3> points;  ///< all different, numbered along a curve
  /// Per point the balls on whose spheres it lies, ascending: offsets and balls.
  std::span<const int> ball_offsets;
  std::span<const int> ball_numbers;
  std::span<const Ball_3> balls;
};

/// The Delaunay triangulation of the points as they are, decided exactly: cells, with -1 in place of a point in those
/// around the hull, and the cells across from their corners. Both are empty when all points lie in a plane. The balls
/// only make it quick: they tell where doubles can decide by how far points are from the sphere.
/// O(n log n) along surfaces.
void vertex_delaunay(const Points_on_spheres_3& input, std::vector<std::array<int, 4>>& cells,
                     std::vector<std::array<int, 4>>& neighbors, Progress& progress);

}  // namespace mesecina
