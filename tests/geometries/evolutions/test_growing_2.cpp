// SPDX-License-Identifier: GPL-3.0-or-later
// Growing and shrinking disks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "../shapes.h"
#include "evolving.h"
#include "geometries/balls_2/module.h"
#include "geometries/evolution_settings.h"
#include "geometries/modules_2.h"
#include "geometries/scale_axis_2/module.h"
#include "geometries/union_2/module.h"

namespace mesecina::test {
namespace {

using testing::HasSubstr;

using Disks = std::vector<Disk_2>;

Inputs with_disks(Disks disks) { return Inputs().with(disks_input, std::move(disks)); }
const Disks three = {{{0, 0}, 1}, {{1.5, 0}, 0.7}, {{0.5, 1}, 0}};

TEST(Growing_2, StepsAddUpToPercentsOfTheFirstRadius) {
  const Settings settings = Settings().with("growing-step", 4.0);
  const Evolved grown = evolved_2(with_disks(three), "grow-balls", 50, settings);
  const Evolved shrunk = evolved_2(with_disks(three), "shrink-balls", 20, settings);
  for (std::size_t i = 0; i < three.size(); ++i) {
    EXPECT_EQ(grown[disks_input][i].center, three[i].center);
    EXPECT_NEAR(grown[disks_input][i].radius, 3 * three[i].radius, 1e-13);
    EXPECT_NEAR(shrunk[disks_input][i].radius, 0.2 * three[i].radius, 1e-13);
  }
}

TEST(Growing_2, ShrinkingEndsBeforeNothingIsLeft) {
  for (const auto& [percent, steps] : {std::pair{10.0, 9u}, {1.0, 99u}, {3.0, 33u}, {100.0, 0u}, {60.0, 1u}}) {
    const Evolved result = evolved_2(with_disks(three), "shrink-balls", 1000, Settings().with("growing-step", percent));
    EXPECT_EQ(result.result.steps_done, steps) << percent;
    EXPECT_THAT(result.result.end_reason, HasSubstr("shrunk to nothing"));
    EXPECT_GT(result[disks_input][0].radius, 1e-3);
  }
}

TEST(Growing_2, WithoutGrowthNothingChanges) {
  const Settings none = Settings().with("growing-step", 0.0);
  for (const char* id : {"grow-balls", "shrink-balls", "stepped-growing"}) {
    EXPECT_EQ(evolved_2(with_disks(three), id, 3, none).result.end_reason, "nothing changes any more") << id;
    EXPECT_THAT(evolved_2({}, id, 3).result.end_reason, HasSubstr("disks")) << id;
    EXPECT_THAT(evolved_2(Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {1, 1}}), id, 3).result.end_reason,
                testing::Not(testing::AnyOf(HasSubstr("internal"), testing::IsEmpty())))
        << id;
  }
}

TEST(Growing_2, OfPointsGrowsTheDisksOfTheSourceWhateverWasGivenBefore) {
  const auto curve = flower(80);
  for (const char* source : {"automatic", "inner-voronoi", "inner-poles"}) {
    Settings settings = Settings().with("ball-source", std::string(source));
    Inputs inputs = Inputs().with(points_input, curve);
    if (std::string(source) != "automatic") inputs = inputs.with(disks_input, three);
    Graph graph(make_registry_2());
    graph.set_inputs(inputs);
    graph.set_settings(settings);
    Progress progress;
    const auto balls = graph.structure(balls_2_key, progress);
    ASSERT_TRUE(balls);
    const Evolved result = evolved_2(inputs, "grow-balls", 5, settings);
    const Disks& disks = result[disks_input];
    ASSERT_EQ(disks.size(), balls.value->size()) << source;
    EXPECT_EQ(result[points_input], curve);
    for (std::size_t i = 0; i < disks.size(); ++i) {
      EXPECT_EQ(disks[i].center, balls.value->centers[i]);
      EXPECT_NEAR(disks[i].radius, 1.15 * balls.value->radii[i], 1e-12);
    }
    graph.set_inputs(result.inputs);
    graph.set_settings(result.settings);
    EXPECT_EQ(graph.structure(balls_2_key, progress).value->radii[0], disks[0].radius) << source;
  }
}

/// Whether the union of some disks holds a place, with room to spare.
double depth_in(const Disks& disks, const Point_2& place) {
  double depth = -1e300;
  for (const auto& [center, radius] : disks) depth = std::max(depth, radius - distance(center, place));
  return depth;
}

TEST(Stepped_growing_2, FirstStepIsTheUnionOfTheGrownMedialDisks) {
  Graph graph(make_registry_2());
  graph.set_inputs(with_disks(three));
  graph.set_settings(Settings().with("scale", 1.1));
  Progress progress;
  const auto axis = graph.structure(union_medial_axis_2_key, progress);
  ASSERT_TRUE(axis);
  const Evolved result = evolved_2(with_disks(three), "stepped-growing", 1,
                                   Settings().with("growing-step", 10.0).with("scale-axis-min-angle", 0.0));
  const Disks& disks = result[disks_input];
  ASSERT_EQ(disks.size(), axis.value->centers.size());
  for (std::size_t i = 0; i < disks.size(); ++i) {
    EXPECT_EQ(disks[i].center, axis.value->centers[i]);
    EXPECT_NEAR(disks[i].radius, 1.1 * axis.value->radii[i], 1e-12);
  }
}

TEST(Stepped_growing_2, HoldsWhatItGrewFromAndIsHeldByTheSumOfSteps) {
  const Evolved start = evolved_2(Inputs().with(points_input, flower(120)), "grow-balls", 1);
  const Settings exact = Settings().with("scale-axis-min-angle", 0.0);
  const Evolved stepped = evolved_2(start.inputs, "stepped-growing", 4, exact);
  EXPECT_EQ(stepped.result.steps_done, 4u);
  const Disks& before = start[disks_input];
  const Disks& after = stepped[disks_input];
  // Medial disks lie in the union, so each step stays within the radius times 1.03 around it.
  double largest = 0;
  for (const Disk_2& disk : before) largest = std::max(largest, disk.radius);
  Random random(4);
  for (int i = 0; i < 4000; ++i) {
    const Point_2 place{random.uniform(-2, 2), random.uniform(-2, 2)};
    const double depth = depth_in(before, place);
    if (depth > 0) {
      EXPECT_GT(depth_in(after, place), 0);
    }
    if (depth_in(after, place) > 0) {
      EXPECT_GT(depth, -largest * (1.03 * 1.03 * 1.03 * 1.03 - 1) * 2);
    }
  }
}

TEST(Stepped_growing_2, StaysSmallOnARealShape) {
  const auto wave = flower(400, 0.3, 5, 0.02);
  const Evolved few = evolved_2(Inputs().with(points_input, wave), "stepped-growing", 1);
  const Evolved more = evolved_2(Inputs().with(points_input, wave), "stepped-growing", 12);
  EXPECT_EQ(more.result.steps_done, 12u) << more.result.end_reason;
  EXPECT_LT(more[disks_input].size(), few[disks_input].size());
}

}  // namespace
}  // namespace mesecina::test
