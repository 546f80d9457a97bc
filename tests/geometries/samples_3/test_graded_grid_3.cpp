// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "geometries/samples_3/graded_grid_3.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

std::vector<int> near(const Graded_grid_3& grid, const Point_3& center, double radius) {
  std::vector<int> found;
  grid.for_near(center, radius, [&](int i) { found.push_back(i); });
  return found;
}

Point_3 random_point(Random& random, const Point_3& center, double reach) {
  return center + Point_3{random.uniform(-reach, reach), random.uniform(-reach, reach), random.uniform(-reach, reach)};
}

/// Points around `center` whose spacing is `finest` there and grows with the distance, up to `coarsest`.
struct Graded_points {
  Graded_points(const Point_3& center, double coarsest, double finest, int count, std::uint64_t seed) : grid(coarsest) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
      // As many near the center as far from it.
      const double reach = 4 * coarsest * std::pow(2 * finest / coarsest, random.unit());
      points.push_back(random_point(random, center, reach));
      spacings.push_back(std::clamp(0.3 * distance(points.back(), center), finest, coarsest));
      grid.add(points.back(), spacings.back());
    }
  }

  std::vector<Point_3> points;
  std::vector<double> spacings;
  Graded_grid_3 grid;
};

TEST(Graded_grid_3, HasNothingWhereNothingWasAdded) {
  Graded_grid_3 grid(1);
  EXPECT_EQ(grid.size(), 0u);
  EXPECT_TRUE(near(grid, {0, 0, 0}, 10).empty());
  grid.add({0.5, 0.5, 0.5}, 1);
  EXPECT_TRUE(near(grid, {100, 0, 0}, 2).empty());
  EXPECT_EQ(near(grid, {0.5, 0.5, 1}, 2), std::vector<int>{0});
}

TEST(Graded_grid_3, NumbersPointsInTheirOrder) {
  Graded_grid_3 grid(1);
  const std::vector<Point_3> points{{0, 0, 0}, {-0.5, 3, 7}, {0, 0, 0}};
  for (const Point_3& p : points) grid.add(p, 0.3);
  ASSERT_EQ(grid.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(grid.point(i), points[i]);
  std::vector<int> found = near(grid, {0, 0, 0.1}, 0.5);
  std::ranges::sort(found);
  EXPECT_EQ(found, (std::vector<int>{0, 2}));
}

TEST(Graded_grid_3, FindsAllThatAreNearByTheirSpacing) {
  struct Place {
    std::string name;
    Point_3 center;
    double coarsest;
    double finest_part;
  };
  const std::vector<Place> places{
      {"around the origin", {0, 0, 0}, 1, 0.01},       {"negative", {-17.3, -0.001, -250}, 0.7, 0.05},
      {"far away", {3e8, -2e8, 1e8}, 0.3, 0.02},       {"tiny", {1e-7, 0, -1e-7}, 1e-9, 0.1},
      {"all powers", {0.5, 0.5, 0.5}, 1, 1.0 / 16384}, {"one spacing", {1, 2, 3}, 5, 1}};
  for (const auto& [name, center, coarsest, finest_part] : places) {
    const Graded_points set(center, coarsest, finest_part * coarsest, 3000, 5);
    Random random(6);
    std::size_t due = 0;
    for (int query = 0; query < 400; ++query) {
      const double reach = 5 * coarsest * std::pow(finest_part, random.unit());
      const Point_3 p = random_point(random, center, reach);
      const double radius = random.uniform(0, 3 * coarsest);
      const std::vector<int> found = near(set.grid, p, radius);
      const std::set<int> distinct(found.begin(), found.end());
      EXPECT_EQ(distinct.size(), found.size()) << name;
      for (int i = 0; i < static_cast<int>(set.points.size()); ++i) {
        const double d = distance(p, set.points[i]);
        if (d > radius || d > 2 * set.spacings[i]) continue;
        ++due;
        ASSERT_TRUE(distinct.contains(i)) << name << ' ' << i << " at " << d << ", spacing " << set.spacings[i];
      }
    }
    EXPECT_GT(due, 400u) << name;
  }
}

TEST(Graded_grid_3, LooksAtFewOthers) {
  const Graded_points set({0, 0, 0}, 1, 1.0 / 1024, 40'000, 7);
  // Points of which the smallest cells around the center hold nearly none.
  std::size_t found = 0;
  for (int i = 0; i < 100; ++i) found += near(set.grid, set.points[i] + Point_3{1e-5, 0, 0}, 1e-4).size();
  EXPECT_GE(found, 100u);
  EXPECT_LT(found, 100 * set.points.size() / 20);
}

}  // namespace
}  // namespace mesecina::test
