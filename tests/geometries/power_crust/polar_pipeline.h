// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometries/power_crust_2/power_crust_2.h"

namespace mesecina::test {

/// All that is computed on the way from samples to their power crust.
struct Polar_pipeline {
  std::shared_ptr<const Delaunay_2> delaunay;
  std::shared_ptr<const Poles_2> poles;
  Polar_balls_2 polar;
  Polar_diagram_2 diagram;

  const Balls_2& balls() const { return *poles->balls; }
  /// The side of the power cell that holds a point: by trying every disk.
  bool is_in_inner_cell(const Point_2& point) const;
};
/// The dimension of the samples must be 2.
Polar_pipeline power_crust_of(std::span<const Point_2> samples);

/// Ends of the crust's edges as vertices of the diagram; -1 for the far end of a ray.
std::vector<std::array<int, 2>> crust_segments(const Polar_pipeline& pipeline);

/// Betti numbers b0 and b1 of the power shape.
std::array<int, 2> betti_of_shape(const Polar_pipeline& pipeline);
/// Of the crust without its rays.
std::array<int, 2> betti_of_crust(const Polar_pipeline& pipeline);

}  // namespace mesecina::test
