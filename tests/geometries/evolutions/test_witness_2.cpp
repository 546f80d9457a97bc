// SPDX-License-Identifier: GPL-3.0-or-later
// Landmarks by max-min, and their witness complex.
#include "geometries/witness_2/witness_2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "../shapes.h"
#include "core/primitives.h"
#include "evolving.h"
#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/modules_2.h"
#include "geometries/witness_2/module.h"

namespace mesecina::test {
namespace {

using testing::HasSubstr;

using Points = std::vector<Point_2>;

Evolved max_min_landmarks(Inputs inputs, std::uint64_t steps) {
  return run_steps(make_registry_2(), std::move(inputs), "max-min-landmarks", steps);
}

/// From the definition: always the sample whose nearest landmark is farthest, the first of them.
Points max_min(const Points& samples, std::size_t count) {
  Points chosen = {samples.front()};
  while (chosen.size() < count) {
    double farthest = -1;
    Point_2 next;
    for (const Point_2& p : samples) {
      double nearest = 1e300;
      for (const Point_2& q : chosen) nearest = std::min(nearest, squared_distance(p, q));
      if (nearest > farthest) {
        farthest = nearest;
        next = p;
      }
    }
    if (farthest == 0) break;
    chosen.push_back(next);
  }
  return chosen;
}

TEST(Landmarks_2, AreTheMaxMinOnes) {
  for (const auto& [name, points] : difficult_point_sets()) {
    if (points.empty()) continue;
    const Evolved result = max_min_landmarks(Inputs().with(points_input, points), 30);
    EXPECT_EQ(result[landmarks_input], max_min(points, 30)) << name;
    EXPECT_EQ(result[points_input], points) << name;
  }
}

TEST(Landmarks_2, GoOnWhereTheyStoppedAndEndWithTheSamples) {
  const Points points = with_duplicates(uniform_points(40, 3), 10, 1);
  const Evolved some = max_min_landmarks(Inputs().with(points_input, points), 15);
  const Evolved all = max_min_landmarks(some.inputs, 100);
  EXPECT_EQ(all.result.steps_done, 25u);
  EXPECT_EQ(all.result.end_reason, "every sample is a landmark");
  EXPECT_EQ(all[landmarks_input], max_min(points, 100));
  EXPECT_THAT(max_min_landmarks({}, 3).result.end_reason, HasSubstr("nothing to sample"));
}

TEST(Landmarks_2, OfAnOutlineAreAmongItsSamples) {
  const Evolved result =
      max_min_landmarks(Inputs().with(outline_input, Outline_2{{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}}}), 4);
  EXPECT_THAT(result[landmarks_input],
              testing::ElementsAre(Point_2{0, 0}, Point_2{4, 3}, Point_2{3.125, 0}, Point_2{0.875, 3}));
}

TEST(Witness_2, EdgesHaveTheWitnessesThatTheDefinitionFinds) {
  Progress progress;
  for (const auto& [name, points] : general_point_sets()) {
    const Points landmarks = max_min(points, 12);
    const Witnesses_2 found = witness(points, landmarks, progress);
    std::map<std::array<int, 2>, int> expected;
    for (const Point_2& p : points) {
      std::vector<std::pair<double, int>> by_distance;
      for (std::size_t l = 0; l < landmarks.size(); ++l)
        by_distance.emplace_back(squared_distance(p, landmarks[l]), static_cast<int>(l));
      std::ranges::sort(by_distance);
      if (by_distance.size() > 1) {
        const auto [a, b] = std::minmax(by_distance[0].second, by_distance[1].second);
        ++expected[{a, b}];
      }
    }
    std::vector<Witnesses_2::Edge> edges;
    for (const auto& [ends, count] : expected) edges.push_back({ends, count});
    EXPECT_EQ(found.edges, edges) << name;
    // They are Delaunay edges, where these are unique.
    const Delaunay_2 triangulation = delaunay(landmarks, progress);
    if (triangulation.dimension < 2) continue;
    std::set<std::array<int, 2>> delaunay_edges;
    for (const auto& t : triangulation.triangles)
      for (int i = 0; i < 3; ++i)
        delaunay_edges.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    for (const auto& edge : found.edges) EXPECT_TRUE(delaunay_edges.contains(edge.landmarks)) << name;
  }
}

TEST(Witness_2, OfASmoothClosedCurveIsThePolygonOfItsLandmarks) {
  Graph graph(make_registry_2());
  graph.set_inputs(Inputs().with(points_input, shuffled(ellipse(2, 1, 800), 5)));
  Progress progress;
  ASSERT_EQ(evolve(graph, "max-min-landmarks", 40, progress).steps_done, 40u);
  const auto complex = graph.layer("witness-complex", progress);
  ASSERT_TRUE(complex);
  EXPECT_EQ(complex.value->segments.size(), 40u);
  const auto found = topology(*complex.value);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->betti, (std::array<std::int64_t, 3>{1, 1, 0}));
  const auto counts = complex.value->find_values("witnesses");
  ASSERT_NE(counts, nullptr);
  double sum = 0;
  for (const double count : counts->data) sum += count;
  EXPECT_EQ(sum, 800);
  const auto facts = graph.describe("witness-complex", 0, progress);
  EXPECT_EQ(facts.dual.points.size(), static_cast<std::size_t>(counts->data[0]));
  EXPECT_EQ(graph.layer("landmarks", progress).value->points.size(), 40u);
  EXPECT_EQ(graph.layer("landmark-delaunay", progress).value->triangles.size(), 38u);
}

TEST(Witness_2, FewLandmarksAndLandmarksWithoutSamples) {
  Graph graph(make_registry_2());
  Progress progress;
  graph.set_inputs(Inputs().with(points_input, Points{{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_THAT(graph.layer("landmarks", progress).reason, HasSubstr("max-min-landmarks"));
  evolve(graph, "max-min-landmarks", 1, progress);
  EXPECT_THAT(graph.layer("witness-complex", progress).reason, HasSubstr("at least 2"));
  EXPECT_THAT(graph.layer("landmark-delaunay", progress).reason, HasSubstr("at least 2"));
  evolve(graph, "max-min-landmarks", 1, progress);
  EXPECT_EQ(graph.layer("landmark-delaunay", progress).value->segments.size(), 1u);
  EXPECT_EQ(graph.layer("witness-complex", progress).value->segments.size(), 1u);
  graph.set_inputs(Inputs().with(landmarks_input, Points{{0, 0}, {1, 0}}));
  EXPECT_TRUE(graph.layer("landmarks", progress));
  EXPECT_NE(graph.layer("witness-complex", progress).reason, "");
}

}  // namespace
}  // namespace mesecina::test
