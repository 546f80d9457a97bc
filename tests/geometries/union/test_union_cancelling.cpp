// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "core/outcome.h"
#include "geometries/union_2/union_medial_axis_2.h"
#include "tests/geometries/union/disk_sets.h"

namespace mesecina::test {
namespace {

std::shared_ptr<const Balls_2> random_balls(int count) {
  Random random(7);
  std::vector<Disk_2> disks;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-10, 10);
    const double y = random.uniform(-10, 10);
    disks.push_back({{x, y}, random.uniform(0, 40) / std::sqrt(count)});
  }
  return std::make_shared<const Balls_2>(given_balls(disks));
}

TEST(Union_2, every_step_can_be_cancelled) {
  std::stop_source source;
  source.request_stop();
  Progress stopped(source.get_token());
  Progress progress;
  const auto balls = random_balls(3000);
  EXPECT_THROW(regular_triangulation(balls, stopped), Cancelled);
  const auto regular = std::make_shared<const Regular_2>(regular_triangulation(balls, progress));
  EXPECT_THROW(power_vertices(*regular, stopped), Cancelled);
  EXPECT_THROW(dual_complex(regular, 0, stopped), Cancelled);
  const auto dual = std::make_shared<const Dual_2>(dual_complex(regular, 0, progress));
  EXPECT_THROW(union_boundary(dual, stopped), Cancelled);
  EXPECT_THROW(union_boundary(balls, 0, stopped), Cancelled);
  const auto boundary = std::make_shared<const Union_boundary_2>(union_boundary(dual, progress));
  EXPECT_THROW(union_voronoi(boundary, stopped), Cancelled);
  const Union_voronoi_2 voronoi = union_voronoi(boundary, progress);
  EXPECT_THROW(union_medial_axis(voronoi, false, stopped), Cancelled);
}

TEST(Union_2, does_not_depend_on_threads) {
  const auto balls = random_balls(3000);
  const auto make = [&](int threads) {
    Progress progress({}, {}, threads);
    const auto boundary = std::make_shared<const Union_boundary_2>(union_boundary(balls, 0, progress));
    const Union_voronoi_2 voronoi = union_voronoi(boundary, progress);
    return union_medial_axis(voronoi, false, progress);
  };
  const Union_medial_axis_2 one = make(1);
  const Union_medial_axis_2 four = make(4);
  EXPECT_EQ(one.boundary->dual->regular->triangles, four.boundary->dual->regular->triangles);
  EXPECT_EQ(one.boundary->vertices, four.boundary->vertices);
  EXPECT_EQ(one.centers, four.centers);
  EXPECT_EQ(one.radii, four.radii);
  EXPECT_EQ(one.edges, four.edges);
  EXPECT_EQ(one.contacts, four.contacts);
}

}  // namespace
}  // namespace mesecina::test
