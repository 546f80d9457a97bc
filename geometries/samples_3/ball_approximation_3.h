// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "geometries/samples_3/samples_3.h"
#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// A union of balls that stands for a solid.
struct Ball_approximation_3 {
  Surface_samples_3 samples;
  std::size_t even_sample_count = 0;  ///< the others were added where balls deviate
  std::vector<Ball_3> balls;
  std::shared_ptr<const Regular_3> regular;  ///< of the balls
  std::shared_ptr<const Dual_3> dual;
  /// The Betti numbers of the union are not those of the solid, and neither balls nor samples that may be added, half
  /// as many as the even ones and 50 000, would bring them nearer.
  bool is_exhausted = false;
};

/// Inner poles of samples within `distance` of each other, with more samples where the balls would deviate from the
/// surface by more than about a third of that. Where their union has pits, or is connected in another way than the
/// solid, it is mended, round by round, as long as that helps: other balls between the samples join the poles, balls
/// that bridge a gap of the solid become smaller, and samples are added. Returned is the union whose Betti numbers are
/// nearest to those of the solid, of these the one with the fewest faults.
///
/// Centers are moved by up to `perturbation` times the radius, by a rule that depends on nothing but their order and
/// the rounds. O(n log n) for n samples. Throws Unavailable when there is no ball, or the samples are too many. [N.
/// Amenta, S. Choi, R. Kolluri: The power crust, unions of balls, and the medial axis transform, 2001; B. Miklos: The
/// Scale Axis Transform, 2010, 6.1.1]
Ball_approximation_3 approximate_by_balls(const Solid_3& solid, double distance, double perturbation,
                                          Progress& progress);

}  // namespace mesecina
