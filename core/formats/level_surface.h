// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// Numbers on a regular grid in space.
struct Volume_3 {
  std::array<std::size_t, 3> counts{};  ///< of numbers along x, y and z
  Point_3 origin;                       ///< where the first number is
  Point_3 spacing{1, 1, 1};
  std::vector<float> values;  ///< x runs fastest
};

/// The value that parts the numbers into two classes with the least variance within them (N. Otsu: A threshold
/// selection method from gray-level histograms, 1979), to 1/256 of their range. The one number where all are equal; 0
/// for none. O(n).
double otsu_threshold(std::span<const float> values);

struct Level_surface_3 {
  Triangle_mesh_3 mesh;
  bool meets_border = false;  ///< of the grid: there it was closed
};

/// The surface around what is at least `level`, oriented outward: closed, a manifold and without crossings, by marching
/// through six tetrahedra per cell (A. Doi, A. Koide 1991). Values must be finite. Throws std::length_error where there
/// would be more than `most_triangles`. O(n).
Level_surface_3 level_surface(const Volume_3& volume, double level, std::size_t most_triangles);

}  // namespace mesecina
