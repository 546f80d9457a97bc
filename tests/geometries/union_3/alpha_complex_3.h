// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "core/inputs.h"
#include "core/primitives.h"

/// The weighted alpha complex as GUDHI computes it, a body of code apart from ours. Weights are the squares of the
/// radii, rounded, as in ours. [The GUDHI Project: GUDHI User and Reference Manual, 3.7]
namespace mesecina::test {

/// Balls of a simplex, ascending; -1, first, for those that it has less than four.
using Simplex_3 = std::array<int, 4>;
/// Of one to four balls.
Simplex_3 simplex_of(std::span<const int> balls);

struct Alpha_complex {
  /// All simplices of its regular triangulation. A simplex appears at the least power of points on its face of the
  /// power diagram (GUDHI: "alpha squared"), rounded from the exact value, so that the sign is right: those at most 0
  /// are the ones whose power faces meet the union, touching included.
  std::map<Simplex_3, double> values;
  Topology topology;  ///< of the simplices at most 0, by persistent cohomology over the field with two elements
};

/// Whether a coordinate or radius is so small that values may underflow.
bool may_underflow(const std::vector<Ball_3>& balls);

/// By CGAL's triangulations of any dimension, with exact numbers (Gudhi::alpha_complex::Alpha_complex). Also of centers
/// in a plane or on a line. Of several balls with one center the first of the largest ones has a name.
Alpha_complex alpha_complex(const std::vector<Ball_3>& balls);

/// By CGAL's alpha shapes of space, with exact numbers (Gudhi::alpha_complex::Alpha_complex_3d). Throws
/// std::invalid_argument when the centers of all balls that are not hidden lie in a plane.
Alpha_complex alpha_complex_of_space(const std::vector<Ball_3>& balls);

}  // namespace mesecina::test
