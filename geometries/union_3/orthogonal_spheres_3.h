// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// The smallest spheres orthogonal to up to four of some balls, whose centers must not lie in a plane, on a line or in
/// a point that these span anyway. Exact: doubles with a bound of their error decide what they can, CGAL the rest.
class Orthogonal_spheres_3 {
 public:
  /// O(n).
  explicit Orthogonal_spheres_3(std::span<const Ball_3> balls);

  /// Of the squared radius of the sphere, for two to four balls.
  template <std::size_t Count>
  CGAL::Comparison_result sign(const std::array<int, Count>& balls) const;
  /// Of the power of the ball `other` to the sphere, for one to three balls; LARGER where they are farther from each
  /// other than orthogonal. The sphere orthogonal to one ball has its center there, and is imaginary.
  template <std::size_t Count>
  CGAL::Comparison_result power(int other, const std::array<int, Count>& balls) const;
  /// `other` is nearer than orthogonal to the sphere.
  template <std::size_t Count>
  bool is_in_conflict(int other, const std::array<int, Count>& balls) const {
    return power(other, balls) == CGAL::SMALLER;
  }

 private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

  Kernel kernel_;
  std::vector<Kernel::Weighted_point_3> points_;
};

}  // namespace mesecina
