// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/primitives.h"
#include "geometries/samples_3/ball_approximation_3.h"

namespace mesecina::test {

/// With the perturbation that users get.
Ball_approximation_3 approximation_of(const Solid_3& solid, double distance, int threads = 1);

/// Hausdorff distance between the surface and the boundary of the union, in units of `distance`, up to 0.04 too small.
double error_of(const Solid_3& solid, const Ball_approximation_3& approximation, double distance);

/// Of the medial axis of the union, counted on its cells.
Topology topology_of_axis(const Ball_approximation_3& approximation);

}  // namespace mesecina::test
