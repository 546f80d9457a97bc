// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/landmark_disks_2/landmark_disks_2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../shapes.h"
#include "evolving.h"
#include "geometries/landmark_disks_2/module.h"
#include "geometries/modules_2.h"

namespace mesecina::test {
namespace {

using testing::HasSubstr;

using Disks = std::vector<Disk_2>;

Evolved landmarks_of(Inputs inputs, std::uint64_t steps) {
  return run_steps(make_registry_2(), std::move(inputs), "landmark-disks", steps);
}

Disks random_disks(int count, std::uint64_t seed) {
  Random random(seed);
  Disks disks;
  for (int i = 0; i < count; ++i)
    disks.push_back({{random.uniform(-3, 3), random.uniform(-3, 3)}, random.uniform(0.05, 1)});
  return disks;
}

/// From the definition, with the factor at which the last one was chosen.
std::pair<Disks, double> max_min(const Disks& disks, std::size_t count) {
  const auto by_radius = [](const Disk_2& a, const Disk_2& b) { return a.radius < b.radius; };
  Disks chosen = {*std::ranges::max_element(disks, by_radius)};
  double last = 1;
  while (chosen.size() < count) {
    double farthest = 1;
    Disk_2 next;
    for (const Disk_2& disk : disks) {
      double least = 1e300;
      for (const Disk_2& landmark : chosen)
        least = std::min(least, (distance(disk.center, landmark.center) + disk.radius) / landmark.radius);
      if (least > farthest) {
        farthest = least;
        next = disk;
      }
    }
    if (farthest == 1) break;
    last = farthest;
    chosen.push_back(next);
  }
  return {chosen, last};
}

TEST(Landmark_disks_2, AreTheMaxMinOnes) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Disks disks = random_disks(60, seed);
    const Evolved result = landmarks_of(Inputs().with(disks_input, disks), 20);
    EXPECT_EQ(result[landmark_disks_input], max_min(disks, 20).first);
    EXPECT_EQ(result[disks_input], disks);
    const Evolved all = landmarks_of(result.inputs, 1000);
    EXPECT_EQ(all.result.end_reason, "every disk is in a landmark disk");
    EXPECT_EQ(all[landmark_disks_input], max_min(disks, 1000).first);
  }
}

TEST(Landmark_disks_2, GrownOnesHoldEveryDiskAndNoneIsNeededLess) {
  const Disks disks = random_disks(50, 9);
  Graph graph(make_registry_2());
  graph.set_inputs(Inputs().with(disks_input, disks));
  Progress progress;
  evolve(graph, "landmark-disks", 8, progress);
  const double factor = max_min(disks, 9).second;
  const auto landmarks = graph.layer("landmark-disks", progress).value;
  const auto grown = graph.layer("landmark-disks-grown", progress).value;
  ASSERT_TRUE(landmarks && grown);
  ASSERT_EQ(grown->balls.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(grown->balls[i].radius, factor * landmarks->balls[i].radius, 1e-12 * factor);
  const auto dual = graph.layer("landmark-disks-dual", progress);
  ASSERT_TRUE(dual) << dual.reason;
  EXPECT_TRUE(topology(*dual.value));
}

TEST(Landmark_disks_2, OneByOneIsLikeAllAtOnce) {
  Progress progress;
  const auto balls = std::make_shared<const Balls_2>(given_balls(random_disks(80, 4)));
  const auto some = std::make_shared<const Disks>(random_disks(5, 6));
  auto more = std::make_shared<Disks>(*some);
  more->push_back({{9, 9}, 5});
  const auto at_once = landmark_coverage(balls, more, progress);
  const auto later = with_landmarks(landmark_coverage(balls, some, progress), more, progress);
  EXPECT_EQ(at_once.factors, later.factors);
  EXPECT_EQ(at_once.farthest, later.farthest);
}

TEST(Landmark_disks_2, OfACurveDescribeItsShape) {
  Graph graph(make_registry_2());
  graph.set_inputs(Inputs().with(outline_input, Outline_2{{flower(300), ellipse(0.4, 0.4, 100)}}));
  Progress progress;
  ASSERT_EQ(evolve(graph, "landmark-disks", 60, progress).steps_done, 60u);
  const auto dual = graph.layer("landmark-disks-dual", progress);
  ASSERT_TRUE(dual);
  EXPECT_EQ(topology(*dual.value)->betti, (std::array<std::int64_t, 3>{1, 1, 0}));
}

TEST(Landmark_disks_2, FewAndDegenerateDisks) {
  EXPECT_THAT(landmarks_of({}, 2).result.end_reason, HasSubstr("disks"));
  const Evolved one = landmarks_of(Inputs().with(disks_input, Disks{{{1, 1}, 2}}), 2);
  EXPECT_EQ(one.result.steps_done, 1u);
  EXPECT_EQ(one.result.end_reason, "every disk is in a landmark disk");
  const Evolved equal = landmarks_of(Inputs().with(disks_input, Disks{{{1, 1}, 2}, {{1, 1}, 2}, {{1, 1}, 1}}), 5);
  EXPECT_EQ(equal.result.steps_done, 1u);
  const Evolved points = landmarks_of(Inputs().with(disks_input, Disks{{{1, 1}, 0}, {{2, 1}, 0}, {{1, 1}, 0}}), 5);
  EXPECT_EQ(points.result.steps_done, 2u);
  Graph graph(make_registry_2());
  graph.set_inputs(Inputs().with(disks_input, Disks{{{1, 1}, 0}, {{2, 1}, 0}}));
  Progress progress;
  EXPECT_THAT(graph.layer("landmark-disks", progress).reason, HasSubstr("evolution {landmark-disks}"));
  evolve(graph, "landmark-disks", 1, progress);
  EXPECT_THAT(graph.layer("landmark-disks-grown", progress).reason, HasSubstr("do not grow"));
  EXPECT_THAT(graph.layer("landmark-disks-dual", progress).reason, HasSubstr("do not grow"));
}

}  // namespace
}  // namespace mesecina::test
