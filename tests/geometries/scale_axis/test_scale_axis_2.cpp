// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "geometries/samples_2/samples_2.h"
#include "tests/geometries/results.h"
#include "tests/geometries/scale_axis/scale_stages.h"
#include "tests/geometries/union/disk_sets.h"

namespace mesecina::test {
namespace {

Betti betti(const Scale_axis_2& axis) { return betti_of_graph(axis.centers.size(), axis.edges); }

/// Grown disks, their medial axis and the scale axis.
testing::AssertionResult has_one_topology(const Scale_stages& stages) {
  const Betti expected = mesecina::test::betti(*stages.grown_boundary);
  const Betti of_axis = betti_of_graph(stages.grown_axis.centers.size(), stages.grown_axis.edges);
  if (of_axis != expected)
    return failure() << "scale " << stages.scale << ": grown axis " << to_text(of_axis) << ", grown union "
                     << to_text(expected);
  for (const double min_angle : {0.0, 30.0, 180.0}) {
    const Betti found = betti(stages.scale_axis(min_angle, 120));
    if (found != expected)
      return failure() << "scale " << stages.scale << ", least angle " << min_angle << ": scale axis " << to_text(found)
                       << ", grown union " << to_text(expected);
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult has_one_topology_at_every_scale(const std::shared_ptr<const Balls_2>& balls) {
  Scale_stages stages = scale_stages(balls, 1);
  for (const double scale : {1.0, 1.01, 1.1, 1.3, 1.5, 2.0, 5.0}) {
    stages = at_scale(stages, scale);
    if (auto result = has_one_topology(stages); !result) return result;
  }
  return testing::AssertionSuccess();
}

TEST(Scale_axis_2, has_the_topology_of_the_grown_union) {
  expect_of_given_balls(repetitions(28), has_one_topology_at_every_scale);
}
TEST(Scale_axis_2, has_the_topology_of_the_grown_union_of_circumscribed_disks) {
  expect_of_circumscribed_balls(repetitions(12), has_one_topology_at_every_scale);
}

TEST(Scale_axis_2, has_the_topology_of_the_grown_union_of_real_shapes) {
  MESECINA_NEED_DATA();
  int tried = 0;
  for (const auto& file : planar_files("wkt")) {
    SCOPED_TRACE(file.filename());
    const Outline_2 outline = outline_of(file);
    const auto balls =
        std::make_shared<const Balls_2>(inner_voronoi_disks(vertices_of(outline), outline).circumscribed.balls);
    if (balls->size() == 0 || balls->size() > 3000) continue;
    EXPECT_TRUE(has_one_topology_at_every_scale(balls));
    ++tried;
  }
  EXPECT_GT(tried, 20);
}

/// As densely sampled as in the program, many of the samples evenly along straight lines.
TEST(Scale_axis_2, has_the_topology_of_the_grown_union_of_sampled_real_shapes) {
  MESECINA_NEED_DATA();
  int tried = 0;
  for (const auto& file : planar_files("wkt")) {
    SCOPED_TRACE(file.filename());
    const Outline_2 outline = outline_of(file);
    const std::vector<Point_2> samples = sample_outline(outline, 0.005 * diagonal(outline));
    const Scale_stages stages =
        scale_stages(std::make_shared<const Balls_2>(inner_voronoi_disks(samples, outline).circumscribed.balls), 1);
    EXPECT_TRUE(has_one_topology(stages));
    for (const double scale : {1.1, 1.4}) EXPECT_TRUE(has_one_topology(at_scale(stages, scale)));
    ++tried;
  }
  EXPECT_GT(tried, 20);
}

}  // namespace
}  // namespace mesecina::test
