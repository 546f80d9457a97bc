// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// The bounded faces of a power diagram: convex polygons.
struct Power_faces_3 {
  std::vector<Point_3> vertices;          ///< per cell of the triangulation; those of no face are left at 0
  std::vector<std::array<int, 2>> balls;  ///< per face the two balls that are nearest to it in power
  std::vector<int> offsets;               ///< size() + 1 offsets into `corners`
  /// Of each face in order, as cells, counterclockwise when one looks from the second ball to the first; of cells with
  /// one power sphere the least.
  std::vector<int> corners;

  std::size_t size() const { return balls.size(); }
  std::span<const int> face(std::size_t i) const {
    return std::span(corners).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
};

/// Each face once, by its least cell. Faces without area are none. Which cells have one power sphere is decided
/// exactly; vertices are rounded to a billionth of the diagonal of the centers. O(n).
Power_faces_3 bounded_power_faces(const Regular_3& regular, Progress& progress);

/// The edges of the triangulation, the lesser ball first, ascending. O(n log n).
std::vector<std::array<int, 2>> edges_of(const Regular_3& regular);

}  // namespace mesecina
