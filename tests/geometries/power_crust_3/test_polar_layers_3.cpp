// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/graph.h"
#include "geometries/modules_3.h"
#include "geometries/power_crust_3/module.h"
#include "tests/geometries/power_crust_3/clouds_3.h"

namespace mesecina::test {
namespace {

struct Polar_layer {
  Primitive_set set;
  std::shared_ptr<const Polar_balls_3> polar;
  std::vector<std::string> warnings;
};

Polar_layer layer_of(const Cloud& cloud, const char* id) {
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(cloud_input, cloud));
  Progress progress;
  const auto layer = graph.layer(id, progress);
  EXPECT_TRUE(layer) << layer.reason;
  if (!layer) return {};
  return {*layer.value, graph.structure(polar_balls_3_key, progress).value, graph.warnings(id)};
}

TEST(Polar_layers_3, PairsLeadFromTheSampleToItsPolesWithTheCosineOfTheirAngle) {
  for (const Cloud& cloud : {torus_cloud(1, 0.4, 800, 3), random_cloud(200, 4), cube_surface(5),
                             joined(ellipsoid_cloud(200, 1), ellipsoid_cloud(200, 1))}) {
    const auto [set, polar, warnings] = layer_of(cloud, "polar-pairs");
    const Poles_3& poles = *polar->poles;
    const Values* confidence = set.find_values("confidence");
    const Values* inside = set.find_values("inside");
    const Values* radius = set.find_values("radius");
    ASSERT_TRUE(confidence != nullptr && inside != nullptr && radius != nullptr);
    std::map<std::int64_t, std::vector<std::size_t>> of_samples;
    for (std::size_t i = 0; i < set.segments.size(); ++i) of_samples[set.id(i)].push_back(i);
    std::size_t expected = 0;
    for (int s = 0; s < static_cast<int>(cloud.size()); ++s) {
      if (poles.first[s] < 0 || poles.second[s] < 0) {
        EXPECT_FALSE(of_samples.contains(s));
        continue;
      }
      const Point_3 to_first = poles.balls[poles.first[s]].center - cloud[s];
      const Point_3 to_second = poles.balls[poles.second[s]].center - cloud[s];
      const double cosine = dot(to_first, to_second) / std::sqrt(dot(to_first, to_first) * dot(to_second, to_second));
      std::size_t finite = 0;
      for (const int pole : {poles.first[s], poles.second[s]}) {
        if (poles.is_infinite(pole)) continue;
        ASSERT_LT(finite, of_samples[s].size());
        const std::size_t i = of_samples[s][finite++];
        EXPECT_EQ(set.vertices[set.segments[i][0]], cloud[s]);
        EXPECT_EQ(set.vertices[set.segments[i][1]], poles.balls[pole].center);
        EXPECT_NEAR(confidence->data[i], std::max(0.0, -cosine), 1e-6);
        EXPECT_LE(confidence->data[i], 1 + 1e-12);
        EXPECT_EQ(inside->data[i], polar->is_inner[pole]);
        EXPECT_NEAR(radius->data[i], distance(cloud[s], poles.balls[pole].center), 1e-9 * radius->data[i]);
      }
      EXPECT_EQ(of_samples[s].size(), finite);
      expected += finite;
    }
    EXPECT_EQ(set.segments.size(), expected);
    EXPECT_GT(expected, 50u);
  }
}

TEST(Polar_layers_3, PairsOfADenseSampleAreNearlyOpposite) {
  const auto [set, polar, warnings] = layer_of(torus_cloud(1, 0.4, 3000, 3), "polar-pairs");
  std::vector<double> confidence = set.find_values("confidence")->data;
  std::ranges::sort(confidence);
  EXPECT_GT(confidence[confidence.size() / 10], 0.9);
}

TEST(Polar_layers_3, ConflictsAreTheSamplesWithBothPolesOnOneSide) {
  // Random points in a cube, and a closed surface.
  for (const Cloud& cloud : {random_cloud(400, 6), torus_cloud(1, 0.4, 1500, 2)}) {
    const auto [set, polar, warnings] = layer_of(cloud, "label-conflicts");
    std::set<std::int64_t> found;
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      EXPECT_EQ(set.vertices[set.points[i]], cloud[static_cast<std::size_t>(set.id(i))]);
      found.insert(set.id(i));
    }
    std::set<std::int64_t> expected;
    for (int s = 0; s < static_cast<int>(cloud.size()); ++s) {
      const int first = polar->poles->first[s];
      const int second = polar->poles->second[s];
      if (first < 0 || second < 0 || polar->confidence[first] == 0 || polar->confidence[second] == 0) continue;
      if (polar->is_inner[first] == polar->is_inner[second]) expected.insert(s);
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(expected.empty(), cloud.size() == 1500);
    if (!expected.empty()) {
      EXPECT_THAT(warnings, testing::Contains(testing::HasSubstr(std::to_string(expected.size()) + " samples")));
    }
  }
}

TEST(Polar_layers_3, ThePowerCrustRunsAcrossEdgesWithOneInnerPole) {
  const Cloud cloud = ellipsoid_cloud(400, 2);
  const auto [set, polar, warnings] = layer_of(cloud, "polar-triangulation");
  const Values* inner = set.find_values("inner-poles");
  ASSERT_NE(inner, nullptr);
  using Ends = std::pair<std::array<double, 3>, std::array<double, 3>>;
  const auto ends_of = [](const Point_3& p, const Point_3& q) {
    const std::array<double, 3> a{p.x, p.y, p.z};
    const std::array<double, 3> b{q.x, q.y, q.z};
    return Ends{std::min(a, b), std::max(a, b)};
  };
  std::set<Ends> crossed;
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const auto& [a, b] = set.segments[i];
    if (inner->data[i] == 1) crossed.insert(ends_of(set.vertices[a], set.vertices[b]));
  }
  EXPECT_GT(std::ranges::count(inner->data, 2.0), 100);
  Progress progress;
  const Power_crust_3 crust = power_crust(*polar, progress);
  int finite = 0;
  for (const auto& [a, b] : crust.poles) {
    if (polar->poles->is_infinite(a) || polar->poles->is_infinite(b)) continue;
    ++finite;
    EXPECT_TRUE(crossed.contains(ends_of(polar->poles->balls[a].center, polar->poles->balls[b].center)));
  }
  const auto torus = layer_of(torus_cloud(1, 0.4, 600, 2), "polar-triangulation");
  EXPECT_GT(std::ranges::count(torus.set.find_values("inner-poles")->data, 1.0), 100);
  EXPECT_GT(std::ranges::count(torus.set.find_values("inner-poles")->data, 0.0), 10);
  EXPECT_LE(finite, static_cast<int>(crossed.size()));
}

}  // namespace
}  // namespace mesecina::test
