// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometries/surface_error_3/surface_error_3.h"
#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

Union_boundary_3 boundary_of(const std::vector<Ball_3>& balls) {
  Progress progress;
  const auto regular = std::make_shared<const Regular_3>(regular_triangulation(balls, progress));
  return union_boundary(std::make_shared<const Dual_3>(dual_complex(regular, progress)), progress);
}

Surface_error_3 error_of(const Triangle_mesh_3& mesh, const std::vector<Ball_3>& balls, double resolution,
                         int threads = 1) {
  Progress progress({}, {}, threads);
  return surface_error(solid_of(mesh), boundary_of(balls), resolution, progress);
}

double diagonal_of(const Triangle_mesh_3& mesh) {
  Box box;
  for (const Point_3& p : mesh.vertices) box.add(p);
  return box.diagonal();
}

/// Of the boundary of the union: every point of it has one within about `step`.
std::vector<Point_3> boundary_samples(const std::vector<Ball_3>& balls, double step) {
  std::vector<Point_3> result;
  const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double area = 4 * std::numbers::pi * balls[i].radius * balls[i].radius;
    const int count = 8 + static_cast<int>(3 * area / (step * step));
    for (int k = 0; k < count; ++k) {
      const double z = 1 - (2 * k + 1.0) / count;
      const double around = std::sqrt(1 - z * z);
      const Point_3 p =
          balls[i].center + balls[i].radius * Point_3{around * std::cos(turn * k), around * std::sin(turn * k), z};
      const bool is_covered = std::ranges::any_of(
          balls, [&](const Ball_3& ball) { return distance(ball.center, p) < ball.radius * (1 - 1e-12); });
      if (!is_covered) result.push_back(p);
    }
  }
  return result;
}

std::vector<Point_3> surface_samples(const Triangle_mesh_3& mesh, double step) {
  std::vector<Point_3> result;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Point_3& a = mesh.vertices[t[0]];
    const Point_3& b = mesh.vertices[t[1]];
    const Point_3& c = mesh.vertices[t[2]];
    const int n = 1 + static_cast<int>(std::max({distance(a, b), distance(b, c), distance(c, a)}) / step);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        result.push_back(
            (1.0 / n) * (static_cast<double>(n - i - j) * a + static_cast<double>(i) * b + static_cast<double>(j) * c));
  }
  return result;
}

/// Both directions over samples of both surfaces, all against all.
void expect_as_sampled(const Triangle_mesh_3& mesh, const std::vector<Ball_3>& balls, double resolution,
                       double relative_step) {
  const double diagonal = diagonal_of(mesh);
  const double step = relative_step * diagonal;
  const std::vector<Point_3> on_union = boundary_samples(balls, step);
  ASSERT_FALSE(on_union.empty());
  double to_input = 0;
  for (const Point_3& p : on_union) to_input = std::max(to_input, distance_to(mesh, p));
  double from_input = 0;
  for (const Point_3& p : surface_samples(mesh, step)) {
    double least = std::numeric_limits<double>::infinity();
    for (const Point_3& q : on_union) least = std::min(least, squared_distance(p, q));
    from_input = std::max(from_input, std::sqrt(least));
  }
  const Surface_error_3 error = error_of(mesh, balls, resolution);
  EXPECT_LE(error.resolution, resolution * 1.001);
  EXPECT_GE(error.to_input, to_input / diagonal - error.resolution);
  EXPECT_LE(error.to_input, (to_input + step) / diagonal);
  EXPECT_GE(error.from_input, (from_input - step) / diagonal - error.resolution);
  EXPECT_LE(error.from_input, (from_input + step) / diagonal);
  EXPECT_EQ(error.hausdorff(), std::max(error.from_input, error.to_input));
}

TEST(Surface_error_3, BallInABox) {
  const Triangle_mesh_3 mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  const double diagonal = std::sqrt(12.0);
  const Surface_error_3 error = error_of(mesh, {{{0, 0, 0}, 0.8}}, 1e-4);
  // Corners are the farthest from the ball; toward them it is farthest from the sides.
  EXPECT_NEAR(error.from_input * diagonal, std::sqrt(3.0) - 0.8, 1e-4 * diagonal);
  EXPECT_NEAR(error.to_input * diagonal, 1 - 0.8 / std::sqrt(3.0), 1e-4 * diagonal);
}

TEST(Surface_error_3, BallAroundABox) {
  const Triangle_mesh_3 mesh = box_mesh({-1, -1, -1}, {1, 1, 1});
  const double diagonal = std::sqrt(12.0);
  const Surface_error_3 error = error_of(mesh, {{{0, 0, 0}, 2}}, 1e-4);
  EXPECT_NEAR(error.from_input * diagonal, 1, 1e-4 * diagonal);
  EXPECT_NEAR(error.to_input * diagonal, 1, 1e-4 * diagonal);
}

TEST(Surface_error_3, TwoBallsThatMeetAndTwoThatDoNot) {
  const Triangle_mesh_3 mesh = box_mesh({-2, -1, -1}, {2, 1, 1});
  expect_as_sampled(mesh, {{{-0.8, 0.1, 0}, 1}, {{0.8, 0, 0.2}, 1.1}}, 0.003, 0.02);
  expect_as_sampled(mesh, {{{-1.2, 0.1, 0}, 0.9}, {{1.2, 0, 0.2}, 1.1}}, 0.003, 0.02);
}

TEST(Surface_error_3, BoundaryIsNearestWhereTwoSpheresMeet) {
  // A needle in the common plane of two spheres, from the middle outward; the boundary has no vertices.
  const double across = 1e-3;
  const Triangle_mesh_3 needle = box_mesh({-across, -across, 0}, {across, across, 0.5});
  const double diagonal = diagonal_of(needle);
  const Surface_error_3 error = error_of(needle, {{{-1, 0, 0}, 1.5}, {{1, 0, 0}, 1.5}}, 2e-3);
  EXPECT_NEAR(error.from_input * diagonal, std::sqrt(1.25), 3e-3);
  EXPECT_NEAR(error.to_input * diagonal, 2.5, 3e-3);
}

TEST(Surface_error_3, RandomBallsInAndAroundShapes) {
  Random random(31);
  for (int round = 0; round < 6; ++round) {
    const Triangle_mesh_3 mesh = round % 2 == 0 ? torus_mesh(2, 0.8, 24, 12) : box_mesh({-2, -1, -1}, {2, 2, 1});
    std::vector<Ball_3> balls;
    for (int i = 0; i < 3 + 8 * round; ++i)
      balls.push_back(
          {{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1)}, random.uniform(0.2, 0.9)});
    expect_as_sampled(mesh, balls, 0.003, 0.02);
  }
}

TEST(Surface_error_3, BallsOnALattice) {
  std::vector<Ball_3> balls;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 2; ++z)
        balls.push_back({{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}, 0.75});
  expect_as_sampled(box_mesh({-0.7, -0.7, -0.7}, {3.7, 2.7, 1.7}), balls, 0.003, 0.015);
}

TEST(Surface_error_3, SmallBallsAlongATorus) {
  std::vector<Ball_3> balls;
  constexpr int count = 90;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    balls.push_back({{2 * std::cos(angle), 2 * std::sin(angle), 0}, 0.8});
  }
  expect_as_sampled(torus_mesh(2, 0.8, 24, 12), balls, 0.002, 0.03);
  const Surface_error_3 error = error_of(torus_mesh(2, 0.8, 60, 30), balls, 0.001);
  EXPECT_LT(error.hausdorff(), 0.004);
  EXPECT_GT(error.hausdorff(), 0);
}

TEST(Surface_error_3, SameForEveryNumberOfThreads) {
  std::vector<Ball_3> balls;
  Random random(5);
  for (int i = 0; i < 300; ++i)
    balls.push_back({{random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1)}, random.uniform(0.2, 0.6)});
  const Triangle_mesh_3 mesh = torus_mesh(2, 0.8);
  const Surface_error_3 one = error_of(mesh, balls, 0.001, 1);
  const Surface_error_3 four = error_of(mesh, balls, 0.001, 4);
  EXPECT_EQ(one.from_input, four.from_input);
  EXPECT_EQ(one.to_input, four.to_input);
}

}  // namespace
}  // namespace mesecina::test
