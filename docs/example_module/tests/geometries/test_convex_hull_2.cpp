// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/graph.h"
#include "geometries/convex_hull_2/convex_hull_2.h"
#include "geometries/samples_2/module.h"

namespace mesecina::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<int> corners(const std::vector<Point_2>& points) {
  Progress progress;
  return convex_hull(points, progress).corners;
}

/// Twice the area of the triangle, positive when it is counterclockwise; exact for small integers.
double area(const Point_2& p, const Point_2& q, const Point_2& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

TEST(Convex_hull, few_and_degenerate_points) {
  EXPECT_THAT(corners({}), IsEmpty());
  EXPECT_THAT(corners({{3, 4}}), ElementsAre(0));
  EXPECT_THAT(corners({{3, 4}, {3, 4}}), ElementsAre(0));
  EXPECT_THAT(corners({{1, 0}, {0, 0}}), ElementsAre(1, 0));
  EXPECT_THAT(corners({{1, 1}, {0, 0}, {3, 3}, {2, 2}}), ElementsAre(1, 2));
  EXPECT_THAT(corners({{1, 2}, {1, 0}, {1, 1}}), ElementsAre(1, 0));
}

TEST(Convex_hull, leaves_out_points_inside_and_on_sides) {
  EXPECT_THAT(corners({{1, 1}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {1, 0}, {2, 1}, {0, 0}}), ElementsAre(4, 1, 2, 3));
}

TEST(Convex_hull, of_points_nearly_on_a_line_is_exact) {
  const double little = std::nextafter(0.5, 1.0);
  EXPECT_THAT(corners({{0, 0}, {0.5, little}, {1, 1}}), ElementsAre(0, 2, 1));
}

/// The definition: pq is a side iff all other points are to its left.
TEST(Convex_hull, equals_brute_force) {
  std::mt19937 random(1);
  int hulls = 0;
  for (int round = 0; round < 200; ++round) {
    const int size = 2 + round / 10;
    std::uniform_int_distribution<int> coordinate(0, size);
    std::vector<Point_2> points(static_cast<std::size_t>(3 * size));
    for (Point_2& p : points) p = {static_cast<double>(coordinate(random)), static_cast<double>(coordinate(random))};
    const std::vector<int> hull = corners(points);
    if (hull.size() < 3) continue;
    ++hulls;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Point_2& p = points[hull[i]];
      const Point_2& q = points[hull[(i + 1) % hull.size()]];
      EXPECT_GT(area(p, q, points[hull[(i + 2) % hull.size()]]), 0);
      for (const Point_2& r : points) EXPECT_GE(area(p, q, r), 0);
    }
  }
  EXPECT_GT(hulls, 190);
}

TEST(Convex_hull_layer, is_a_closed_curve_or_has_a_reason) {
  auto registry = std::make_shared<Registry>();
  register_samples_2(*registry);
  register_convex_hull_2(*registry);
  Graph graph(registry);
  Progress progress;

  graph.set_inputs(Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {4, 0}, {1, 1}, {0, 3}}));
  const Outcome<Primitive_set> hull = graph.layer("convex-hull", progress);
  ASSERT_TRUE(hull) << hull.reason;
  EXPECT_EQ(hull.value->segments.size(), 3u);
  EXPECT_EQ(hull.value->values.at(0).data, (std::vector<double>{4, 5, 3}));
  EXPECT_EQ(topology(*hull.value)->betti, (std::array<std::int64_t, 3>{1, 1, 0}));

  graph.set_inputs(Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_EQ(graph.layer("convex-hull", progress).reason, "needs at least 3 points that are not on one line");
}

}  // namespace
}  // namespace mesecina::test
