// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// The points that stand for the shape: the bare points first, in the user's order, then those along the outline.
struct Samples_2 {
  std::vector<Point_2> points;               ///< may hold equal points
  std::shared_ptr<const Outline_2> outline;  ///< the shape itself; null when there are bare points among the samples
};

/// Samples every ring: its vertices, and each segment cut into equal pieces no longer than `step`.
/// step: in units of the plane; infinity for the vertices alone. Throws Unavailable when that would give more than 50
/// million points. O(output).
std::vector<Point_2> sample_outline(const Outline_2& outline, double step);

/// Length of the diagonal of the bounding box of the outline; 0 for one without points.
double diagonal(const Outline_2& outline);

}  // namespace mesecina
