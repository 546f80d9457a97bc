// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometries/union_3/orthogonal_spheres_3.h"
#include "tests/geometries/union_3/ball_sets.h"

/// Beside CGAL's predicates, also where spheres meet in a point up to rounding, or exactly.
namespace mesecina::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Weighted_point = Kernel::Weighted_point_3;

Weighted_point weighted(const Ball_3& ball) {
  return {Kernel::Point_3(ball.center.x, ball.center.y, ball.center.z), ball.radius * ball.radius};
}

/// Of five balls, in all the ways that the dual complex asks.
void expect_as_cgal(const std::vector<Ball_3>& balls) {
  std::vector<Weighted_point> p;
  for (const Ball_3& ball : balls) p.push_back(weighted(ball));
  const Orthogonal_spheres_3 spheres(balls);
  const auto sign = Kernel().compare_weighted_squared_radius_3_object();
  const auto power = [](const auto&... points) {
    return CGAL::enum_cast<CGAL::Comparison_result>(
        CGAL::opposite(Kernel().power_side_of_bounded_power_sphere_3_object()(points...)));
  };
  const auto point = [&](int i) { return p[i].point(); };
  const bool is_cell = CGAL::orientation(point(0), point(1), point(2), point(3)) != CGAL::COPLANAR;
  const bool is_triangle = !CGAL::collinear(point(0), point(1), point(2));
  ASSERT_NE(point(0), point(1));
  EXPECT_EQ(spheres.sign(std::array{0, 1}), sign(p[0], p[1], 0));
  EXPECT_EQ(spheres.power(4, std::array{0}), power(p[0], p[4]));
  EXPECT_EQ(spheres.is_in_conflict(4, std::array{0}), power(p[0], p[4]) == CGAL::SMALLER);
  EXPECT_EQ(spheres.power(4, std::array{0, 1}), power(p[0], p[1], p[4]));
  EXPECT_EQ(spheres.is_in_conflict(4, std::array{0, 1}), power(p[0], p[1], p[4]) == CGAL::SMALLER);
  if (is_triangle) {
    EXPECT_EQ(spheres.sign(std::array{0, 1, 2}), sign(p[0], p[1], p[2], 0));
    EXPECT_EQ(spheres.power(4, std::array{0, 1, 2}), power(p[0], p[1], p[2], p[4]));
  }
  if (is_cell) {
    EXPECT_EQ(spheres.sign(std::array{0, 1, 2, 3}), sign(p[0], p[1], p[2], p[3], 0));
  }
}

class Random_points {
 public:
  explicit Random_points(int seed) : engine_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Point_3 point(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

 private:
  std::mt19937 engine_;
};

TEST(Orthogonal_spheres_3, of_random_balls_of_all_sizes) {
  Random_points random(1);
  for (const double size : {1e-60, 1e-35, 1e-5, 1.0, 1e8, 1e35, 1e60})
    for (int i = 0; i < 300; ++i) {
      std::vector<Ball_3> balls(5);
      for (Ball_3& ball : balls) ball = {random.point(size), random.number(0, size)};
      expect_as_cgal(balls);
    }
}

TEST(Orthogonal_spheres_3, of_balls_through_one_point_up_to_rounding) {
  Random_points random(2);
  for (int i = 0; i < 3000; ++i) {
    const Point_3 meeting = random.point(std::pow(10.0, random.number(-3, 3)));
    const double nearness = std::pow(10.0, random.number(-16, 0));
    std::vector<Ball_3> balls(5);
    for (Ball_3& ball : balls) {
      ball.center = random.point(1);
      ball.radius = distance(ball.center, meeting) * (1 + nearness * random.number(-1, 1));
    }
    expect_as_cgal(balls);
  }
}

TEST(Orthogonal_spheres_3, of_balls_that_nearly_touch_and_of_nearly_flat_ones) {
  Random_points random(3);
  for (int i = 0; i < 3000; ++i) {
    const double flatness = std::pow(10.0, random.number(-14, 0));
    std::vector<Ball_3> balls(5);
    for (Ball_3& ball : balls) {
      ball.center = random.point(1);
      ball.center.z *= flatness;
      ball.radius = random.number(0.2, 0.6);
    }
    balls[1].radius = std::abs(distance(balls[0].center, balls[1].center) - balls[0].radius);
    expect_as_cgal(balls);
  }
}

TEST(Orthogonal_spheres_3, of_a_lattice_where_all_is_exact) {
  Random_points random(4);
  const auto whole = [&](int most) { return std::floor(random.number(0, most + 1)); };
  for (int i = 0; i < 5000; ++i) {
    std::vector<Ball_3> balls(5);
    for (Ball_3& ball : balls) ball = {{whole(3), whole(3), whole(3)}, whole(4) / 2};
    if (balls[0].center == balls[1].center) continue;
    expect_as_cgal(balls);
  }
}

}  // namespace
}  // namespace mesecina::test
