// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"
#include "geometries/solid_3/box_tree_3.h"
#include "geometries/solid_3/crossing_3.h"

namespace mesecina {

/// The triangles of a surface in a hierarchy. Safe to ask from several threads.
class Surface_locator_3 {
 public:
  /// O(n log n).
  Surface_locator_3(const Triangle_mesh_3& surface, Progress& progress);

  /// The point is on the surface, or the surface winds around it a positive number of times. Exact for a closed
  /// surface. O(log n) for surfaces that are not crossed often by one line.
  bool contains(const Point_3& p) const;
  /// To the nearest point of the surface; infinite without triangles. To rounding.
  double squared_distance(const Point_3& p) const { return nearest(p, 0).squared_distance; }

  struct Nearest {
    double squared_distance = std::numeric_limits<double>::infinity();
    int position = 0;  ///< of a triangle that is so far
  };
  /// Fast when the triangle at position `guess` is near to the point.
  Nearest nearest(const Point_3& p, int guess) const;

  const Box_tree_3& tree() const { return tree_; }
  /// By position in the tree.
  const std::vector<Corners_3>& corners() const { return corners_; }

 private:
  Box_tree_3 tree_;
  std::vector<Corners_3> corners_;
};

/// From a point to a triangle. To rounding.
double squared_distance(const Corners_3& triangle, const Point_3& p);

}  // namespace mesecina
