// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/geometries/union_3/axis_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

void expect_agreement(const std::vector<Ball_3>& balls) {
  const Axis_3 axis = axis_of(balls);
  EXPECT_TRUE(is_complex(axis));
  EXPECT_TRUE(has_topology_of_union(axis.complex, *axis.dual));
  EXPECT_EQ(topology_by_ranks(axis.complex), topology(*axis.dual));
}

TEST(Large_unions_3, agree_with_themselves_when_random) {
  for (const double neighbors : {1.0, 3.0, 10.0, 40.0}) {
    SCOPED_TRACE(neighbors);
    for (std::uint64_t seed = 0; seed < repetitions(1); ++seed) expect_agreement(many_balls(3000, neighbors, seed));
  }
}

TEST(Large_unions_3, agree_with_solids_and_themselves) {
  for (const Smooth_solid& solid : smooth_solids()) {
    SCOPED_TRACE(solid.name);
    for (std::uint64_t seed = 0; seed < repetitions(1); ++seed) {
      const std::vector<Ball_3> balls = inner_voronoi_balls(solid, 1500, 1e-4, seed);
      EXPECT_EQ(topology(*axis_of(balls).dual).betti, solid.betti);
      expect_agreement(balls);
      std::vector<Ball_3> grown = balls;
      for (Ball_3& b : grown) b.radius *= 1.1;
      expect_agreement(grown);
    }
  }
}

/// As balls that were written to a file and read again: many spheres go nearly through each sample.
TEST(Large_unions_3, agree_with_themselves_when_nearly_special_and_perturbed) {
  for (const Smooth_solid& solid : smooth_solids()) {
    SCOPED_TRACE(solid.name);
    const std::vector<Ball_3> balls = inner_voronoi_balls(solid, 700, 0, 1);
    const Axis_3 axis = axis_of(perturbed(balls, 1e-4));
    EXPECT_EQ(topology_by_ranks(axis.complex), topology(*axis.dual));
    EXPECT_TRUE(has_topology_of_union(axis.complex, *axis.dual));
  }
}

}  // namespace
}  // namespace mesecina::test
