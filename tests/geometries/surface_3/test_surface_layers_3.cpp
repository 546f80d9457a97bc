// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph.h"
#include "geometries/modules_3.h"
#include "tests/geometries/surface_3/surface_checks_3.h"

namespace mesecina::test {
namespace {

Inputs ring() {
  return Inputs().with(
      balls_input,
      std::vector<Ball_3>{{{3, 0, 0}, 2.5}, {{0, 3.1, 0}, 2.4}, {{-3.05, 0, 0.1}, 2.5}, {{0, -3, -0.1}, 2.45}});
}

TEST(Surface_layers_3, AreClosedSurfacesOfTheSolid) {
  Graph graph(make_registry_3());
  graph.set_inputs(ring());
  Progress progress;
  for (const char* id : {"union-surface", "scale-axis-surface"}) {
    const auto outcome = graph.layer(id, progress);
    ASSERT_TRUE(outcome) << id << ": " << outcome.reason;
    EXPECT_TRUE(is_closed_manifold({outcome.value->vertices, outcome.value->triangles})) << id;
    const auto found = mesecina::topology(*outcome.value);
    ASSERT_TRUE(found) << id;
    EXPECT_EQ(found->betti, (std::array<std::int64_t, 3>{1, 2, 1})) << id;
    ASSERT_NE(outcome.value->find_values("radius"), nullptr) << id;
    EXPECT_EQ(outcome.value->find_values("radius")->data.size(), outcome.value->element_count()) << id;
    const auto measures = graph.measures();
    const auto deviation = measures.find(std::string(id) + "-deviation");
    ASSERT_NE(deviation, measures.end()) << id;
    EXPECT_GT(deviation->second, 0.0005) << id;
    EXPECT_LE(deviation->second, 0.0020001) << id;
  }
}

TEST(Surface_layers_3, FollowTheToleranceAlone) {
  Graph graph(make_registry_3());
  graph.set_inputs(ring());
  Progress progress;
  const auto fine = graph.layer("union-surface", progress);
  graph.set_settings(Settings().with("surface-tolerance", 0.02));
  const auto coarse = graph.layer("union-surface", progress);
  ASSERT_TRUE(fine && coarse);
  EXPECT_GT(fine.value->triangles.size(), 4 * coarse.value->triangles.size());
  EXPECT_EQ(graph.computations("dual-3"), 1u);
}

TEST(Surface_layers_3, PointsHaveNoSurface) {
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(balls_input, std::vector<Ball_3>{{{1, 2, 3}, 0}}));
  Progress progress;
  const auto outcome = graph.layer("union-surface", progress);
  EXPECT_FALSE(outcome);
  EXPECT_THAT(outcome.reason, testing::HasSubstr("no surface"));
}

}  // namespace
}  // namespace mesecina::test
