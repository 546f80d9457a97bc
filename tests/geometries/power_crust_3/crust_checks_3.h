// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometries/power_crust_3/power_crust_3.h"
#include "tests/geometries/power_crust_3/clouds_3.h"

namespace mesecina::test {

/// Everything that is made of a cloud.
struct Crust_3 {
  Polar_balls_3 polar;
  Power_crust_3 surface;
  Dual_3 shape;
};
Crust_3 crust_of(const Cloud& cloud, int threads = 1);

Primitive_set primitives_of(const Power_crust_3& surface);
/// Of the inner polar balls, moved a little.
Topology topology_of_inner_balls(const Polar_balls_3& polar);
/// Signed volume.
double volume(const Power_crust_3& surface);
/// Every edge has two faces, which have it in opposite directions, and no face has a vertex twice.
void expect_closed(const Power_crust_3& surface);
/// All that is true of every power crust: it is closed, its vertices are as far in power from the poles beside them as
/// from no other, it bounds the power shape in topology, and the shape's
/// parts are all those between inner poles.
void expect_sound(const Crust_3& crust);

}  // namespace mesecina::test
