// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometries/samples_3/samples_3.h"
#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

struct Polar_samples {
  Solid_3 solid;
  Surface_samples_3 samples;
  Delaunay_3 delaunay;
  std::vector<int> poles;
};
Polar_samples poles_of(const Triangle_mesh_3& mesh, double spacing) {
  Progress progress;
  Polar_samples result;
  result.solid = solid_of(mesh);
  result.samples = sample_surface(result.solid.surface, spacing, progress);
  result.delaunay = delaunay(result.samples.points, progress);
  result.poles = inner_pole_cells(result.samples, result.delaunay, result.solid, progress);
  return result;
}

TEST(Inner_poles_3, OfASphereLieAtItsCenter) {
  const Polar_samples polar = poles_of(sphere_mesh({0, 0, 0}, 1, 48), 0.2);
  const std::vector<Ball_3> balls = balls_of_cells(polar.delaunay, polar.poles, 1e-4);
  ASSERT_FALSE(balls.empty());
  for (const Ball_3& ball : balls) {
    EXPECT_LT(std::sqrt(dot(ball.center, ball.center)), 0.05);
    EXPECT_NEAR(ball.radius, 1, 0.05);
  }
}

TEST(Inner_poles_3, AreEmptyBallsInsideTheCube) {
  const Polar_samples polar = poles_of(box_mesh({0, 0, 0}, {1, 1, 1}), 0.1);
  const std::vector<Ball_3> balls = balls_of_cells(polar.delaunay, polar.poles, 0);
  ASSERT_GT(balls.size(), 100u);
  double largest = 0;
  for (const Ball_3& ball : balls) {
    for (const double c : {ball.center.x, ball.center.y, ball.center.z}) {
      EXPECT_GT(c, 0);
      EXPECT_LT(c, 1);
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point_3& sample : polar.samples.points) nearest = std::min(nearest, distance(sample, ball.center));
    EXPECT_NEAR(nearest, ball.radius, 1e-9);
    largest = std::max(largest, ball.radius);
  }
  // The inscribed ball touches all sides in their middles; samples near them leave it a little larger.
  EXPECT_NEAR(largest, 0.5, 0.01);
}

TEST(Inner_poles_3, AreTheFarthestInnerVerticesOfVoronoiCells) {
  for (const Triangle_mesh_3& mesh :
       {torus_mesh(2, 0.7, 20, 10), box_mesh({-1, -1, -0.1}, {1, 1, 0.1}),
        joined({sphere_mesh({0, 0, 0}, 2, 8), turned(sphere_mesh({0.2, 0, 0}, 1.5, 8))})}) {
    const Polar_samples polar = poles_of(mesh, 0.5);
    const Delaunay_3& delaunay = polar.delaunay;
    std::vector<double> farthest(polar.samples.points.size(), -1);
    for (std::size_t c = 0; c < delaunay.cells.size(); ++c) {
      if (place_of(polar.solid.surface, delaunay.circumcenters[c]) == Place::outside) continue;
      for (const int s : delaunay.cells[c]) farthest[s] = std::max(farthest[s], delaunay.circumradii[c]);
    }
    ASSERT_EQ(polar.poles.size(), farthest.size());
    for (std::size_t s = 0; s < farthest.size(); ++s) {
      ASSERT_EQ(polar.poles[s] >= 0, farthest[s] >= 0) << s;
      if (polar.poles[s] < 0) continue;
      EXPECT_EQ(delaunay.circumradii[polar.poles[s]], farthest[s]);
      EXPECT_EQ(std::ranges::count(delaunay.cells[polar.poles[s]], static_cast<int>(s)), 1);
    }
  }
}

TEST(Balls_of_cells_3, AreEachOnceInTheOrderOfTheCells) {
  const Polar_samples polar = poles_of(box_mesh({0, 0, 0}, {1, 2, 3}), 0.6);
  const Delaunay_3& delaunay = polar.delaunay;
  const std::vector<Ball_3> balls = balls_of_cells(delaunay, {4, -1, 2, 4, 7, -1, 2}, 0);
  ASSERT_EQ(balls.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const int c = std::array{2, 4, 7}[i];
    EXPECT_EQ(balls[i].center, delaunay.circumcenters[c]);
    EXPECT_EQ(balls[i].radius, delaunay.circumradii[c]);
  }
  EXPECT_TRUE(balls_of_cells(delaunay, {-1, -1}, 0).empty());
}

TEST(Balls_of_cells_3, MoveByAPartOfTheirRadius) {
  const Polar_samples polar = poles_of(box_mesh({0, 0, 0}, {1, 2, 3}), 0.3);
  const std::vector<Ball_3> before = balls_of_cells(polar.delaunay, polar.poles, 0);
  const std::vector<Ball_3> after = balls_of_cells(polar.delaunay, polar.poles, 0.01);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Point_3 shift = after[i].center - before[i].center;
    EXPECT_GT(dot(shift, shift), 0);
    for (const double c : {shift.x, shift.y, shift.z}) EXPECT_LE(std::abs(c), 0.01 * before[i].radius * (1 + 1e-9));
  }
}

}  // namespace
}  // namespace mesecina::test
