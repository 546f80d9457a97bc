// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometries/samples_3/union_defects_3.h"
#include "tests/geometries/solid_3/meshes_3.h"

namespace mesecina::test {
namespace {

std::vector<Union_defect_3> defects_of(std::vector<Ball_3> balls, const Solid_3& solid, double reach) {
  Progress progress;
  return union_defects(regular_triangulation(std::move(balls), progress), solid, reach, progress);
}

/// Of balls around a circle in the plane z = 0.
std::vector<Ball_3> ring(double radius_of_balls) {
  std::vector<Ball_3> balls;
  constexpr int count = 24;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    // Not all in one plane, and not all on one sphere.
    balls.push_back({{std::cos(angle), std::sin(angle), 1e-3 * (i % 3)}, radius_of_balls * (1 + 1e-3 * (i % 5))});
  }
  return balls;
}

TEST(Union_defects_3, NoneWhereBallsStandForTheSolid) {
  EXPECT_TRUE(defects_of(ring(0.25), solid_of(torus_mesh(1, 0.3, 48, 24)), 1).empty());
  EXPECT_TRUE(defects_of({{{0, 0, 0}, 0.9}, {{0.2, 0, 0}, 0.5}, {{0, 0.3, 0.1}, 0.4}, {{0.1, 0, 0.4}, 0.4}},
                         solid_of(sphere_mesh({0, 0, 0}, 1, 24)), 1)
                  .empty());
}

TEST(Union_defects_3, AMissingConnectionLiesBetweenTwoBalls) {
  std::vector<Ball_3> balls = ring(0.25);
  const Ball_3 gone = balls[5];
  balls.erase(balls.begin() + 5);
  const auto defects = defects_of(balls, solid_of(torus_mesh(1, 0.3, 48, 24)), 1);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_TRUE(defects[0].is_hole);
  EXPECT_LT(distance(defects[0].place, gone.center), 0.05);
  EXPECT_EQ(std::ranges::count(defects[0].balls, -1), 2);
}

TEST(Union_defects_3, ATunnelOfTheUnionLiesInTheSolid) {
  const auto defects = defects_of(ring(0.25), solid_of(sphere_mesh({0, 0, 0}, 2, 24)), 1);
  ASSERT_FALSE(defects.empty());
  for (const Union_defect_3& defect : defects) {
    EXPECT_TRUE(defect.is_hole);
    EXPECT_LT(distance(defect.place, {0, 0, 0}), 0.1);
  }
}

TEST(Union_defects_3, ABridgeLiesOutOfTheSolid) {
  const Solid_3 two = solid_of(joined({sphere_mesh({0, 0, 0}, 1, 24), sphere_mesh({2.1, 0, 0}, 1, 24)}));
  const std::vector<Ball_3> balls{{{0, 0, 0}, 1.08}, {{2.1, 0, 0}, 1.08}, {{0, 0.1, 0.1}, 0.9}, {{2.1, 0.1, 0.2}, 0.9}};
  const auto defects = defects_of(balls, two, 1);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_FALSE(defects[0].is_hole);
  EXPECT_NEAR(defects[0].place.x, 1.05, 1e-9);
  EXPECT_EQ(std::ranges::count(defects[0].balls, -1), 2);
  // The circle where they meet is larger than that.
  EXPECT_TRUE(defects_of(balls, two, 0.2).empty());
}

TEST(Deep_arc_points_3, LieOnTheCircleOfTwoBalls) {
  std::vector<Ball_3> balls{{{0, 0, 0}, 1}, {{1.6, 0, 0}, 1}, {{0, 0, 0.3}, 0.6}, {{1.6, 0.3, 0}, 0.6}};
  Progress progress;
  const Regular_3 regular = regular_triangulation(balls, progress);
  const std::vector<Point_3> points = deep_arc_points(regular, 0.3, progress);
  ASSERT_EQ(points.size(), 16u);
  for (const Point_3& p : points) {
    EXPECT_NEAR(p.x, 0.8, 1e-12);
    EXPECT_NEAR(std::hypot(p.y, p.z), 0.6, 1e-12);
  }
  EXPECT_TRUE(deep_arc_points(regular, 0.41, progress).empty());
  // A fifth ball covers a part of the circle.
  balls.push_back({{0.8, 0.6, 0}, 0.3});
  const std::vector<Point_3> fewer = deep_arc_points(regular_triangulation(balls, progress), 0.3, progress);
  EXPECT_LT(fewer.size(), 16u);
  EXPECT_GT(fewer.size(), 8u);
  for (const Point_3& p : fewer) EXPECT_GE(distance(p, {0.8, 0.6, 0}), 0.3);
}

}  // namespace
}  // namespace mesecina::test
