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
  std::size_t even_sample_count = 0;  ///< the others were added where balls deviate, or the solid is thin
  std::vector<Ball_3> balls;
  std::shared_ptr<const Regular_3> regular;  ///< of the balls
  std::shared_ptr<const Dual_3> dual;
  /// Whether more samples would be needed than there may be: half more than the even ones and 50 000.
  bool is_exhausted = false;
};

/// Inner poles of samples within `distance` of each other, with more samples where the balls would deviate from the
/// surface by more than about a third of that, and inner Voronoi vertices where their union has pits. If the union has
/// not the topology of the solid, inner Voronoi vertices of thin parts join the poles and, with at most 50 000 even
/// samples, more samples are added there; returned is the union whose Betti numbers are nearest to those of the solid.
///
/// Centers are moved by up to `perturbation` times the radius, as balls_of_cells does. O(n log n) for n samples.
/// Throws Unavailable when there is no ball, or the samples are too many. [N. Amenta, S. Choi, R. Kolluri: The power
/// crust, unions of balls, and the medial axis transform, 2001; B. Miklos: The Scale Axis Transform, 2010, 6.1.1]
Ball_approximation_3 approximate_by_balls(const Solid_3& solid, double distance, double perturbation,
                                          Progress& progress);

}  // namespace mesecina
