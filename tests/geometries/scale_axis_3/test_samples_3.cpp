// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "core/outcome.h"
#include "geometries/circumcenter_3.h"
#include "geometries/samples_3/samples_3.h"

namespace mesecina {
namespace {

/// A unit cube with two triangles per side.
Triangle_mesh_3 cube() {
  Triangle_mesh_3 mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({static_cast<double>(i & 1), static_cast<double>(i >> 1 & 1), static_cast<double>(i >> 2)});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A sphere of radius 1, by halving an octahedron.
Triangle_mesh_3 sphere(int rounds) {
  Triangle_mesh_3 mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int round = 0; round < rounds; ++round) {
    Triangle_mesh_3 next;
    for (const auto& triangle : mesh.triangles) {
      std::array<Point_3, 6> p{};
      for (int i = 0; i < 3; ++i) {
        p[i] = mesh.vertices[triangle[i]];
        const Point_3 m = midpoint(mesh.vertices[triangle[i]], mesh.vertices[triangle[(i + 1) % 3]]);
        p[3 + i] = (1 / std::sqrt(dot(m, m))) * m;
      }
      const int v = static_cast<int>(next.vertices.size());
      next.vertices.insert(next.vertices.end(), p.begin(), p.end());
      for (const auto& t : {std::array{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
        next.triangles.push_back({v + t[0], v + t[1], v + t[2]});
    }
    mesh = std::move(next);
  }
  return mesh;
}

double nearest(const std::vector<Point_3>& points, const Point_3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point_3& q : points) least = std::min(least, squared_distance(p, q));
  return std::sqrt(least);
}

TEST(Surface_samples_3, CoverTheSurfaceAndKeepTheirDistance) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  for (const auto& [mesh, spacing] : {std::pair{cube(), 0.21}, {cube(), 3.0}, {sphere(4), 0.17}, {sphere(2), 0.02}}) {
    Progress progress;
    const Surface_samples_3 samples = sample_surface(mesh, spacing, progress);
    EXPECT_EQ(samples.covering_radius, spacing);
    for (std::size_t i = 0; i < std::min<std::size_t>(samples.points.size(), 500); ++i) {
      auto others = samples.points;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
      EXPECT_GE(nearest(others, samples.points[i]), 0.7 * spacing * (1 - 1e-12));
    }
    for (std::size_t k = 0; k < 300; ++k) {
      const auto& t = mesh.triangles[k % mesh.triangles.size()];
      double a = part(random);
      double b = part(random);
      if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
      }
      const Point_3& origin = mesh.vertices[t[0]];
      const Point_3 p = origin + a * (mesh.vertices[t[1]] - origin) + b * (mesh.vertices[t[2]] - origin);
      EXPECT_LE(nearest(samples.points, p), spacing);
    }
  }
}

TEST(Surface_samples_3, TooManyAreRefused) {
  Progress progress;
  EXPECT_THROW(sample_surface(cube(), 1e-6, progress), Unavailable);
}

TEST(Inner_poles_3, OfASphereLieAtItsCenter) {
  Progress progress;
  const auto solid = make_solid(std::make_shared<Triangle_mesh_3>(sphere(4)), Repair::automatic, progress);
  const Surface_samples_3 samples = sample_surface(solid.surface, 0.2, progress);
  const Delaunay_3 triangulation = delaunay(samples.points, progress);
  const std::vector<Ball_3> balls =
      balls_of_cells(triangulation, inner_pole_cells(samples, triangulation, solid, progress), 1e-4);
  ASSERT_FALSE(balls.empty());
  for (const Ball_3& ball : balls) {
    EXPECT_LT(std::sqrt(dot(ball.center, ball.center)), 0.05);
    EXPECT_NEAR(ball.radius, 1, 0.05);
  }
}

TEST(Inner_poles_3, AreEmptyBallsInsideTheCube) {
  Progress progress;
  const auto solid = make_solid(std::make_shared<Triangle_mesh_3>(cube()), Repair::automatic, progress);
  const Surface_samples_3 samples = sample_surface(solid.surface, 0.1, progress);
  const Delaunay_3 triangulation = delaunay(samples.points, progress);
  const std::vector<Ball_3> balls =
      balls_of_cells(triangulation, inner_pole_cells(samples, triangulation, solid, progress), 0);
  ASSERT_GT(balls.size(), 100u);
  double largest = 0;
  for (const Ball_3& ball : balls) {
    for (const double c : {ball.center.x, ball.center.y, ball.center.z}) {
      EXPECT_GT(c, 0);
      EXPECT_LT(c, 1);
    }
    EXPECT_NEAR(nearest(samples.points, ball.center), ball.radius, 1e-9);
    largest = std::max(largest, ball.radius);
  }
  // The inscribed ball touches all sides in their middles; samples near them leave it a little larger.
  EXPECT_NEAR(largest, 0.5, 0.01);
}

TEST(Circumcenter_3, IsRightForTetrahedraOfAnyFlatness) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int k = 0; k < 200; ++k) {
    std::array<Point_3, 4> p{};
    for (Point_3& q : p) q = {coordinate(random), coordinate(random), coordinate(random)};
    if (k % 2 == 1) p[3] = p[0] + 0.4 * (p[1] - p[0]) + 0.3 * (p[2] - p[0]);
    const Point_3 c = circumcenter(p);
    const double r = distance(c, p[0]);
    if (!(r < 1e6)) continue;
    for (const Point_3& q : p) EXPECT_NEAR(distance(c, q), r, 1e-9 * std::max(1.0, r)) << k;
  }
}

TEST(Circumcenter_3, IsRightWhereTwoPointsNearlyMeet) {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int k = 0; k < 300; ++k) {
    std::array<Point_3, 4> p{};
    for (Point_3& q : p) q = {coordinate(random), coordinate(random), coordinate(random)};
    const int near = k % 3;
    const Point_3 step{coordinate(random), coordinate(random), coordinate(random)};
    p[3] = p[near] + 1e-9 * step;
    std::ranges::shuffle(p, random);
    std::array<Exact::Point_3, 4> e;
    for (int i = 0; i < 4; ++i) e[i] = {p[i].x, p[i].y, p[i].z};
    const Exact::Point_3 center = CGAL::circumcenter(e[0], e[1], e[2], e[3]);
    const Point_3 expected{CGAL::to_double(CGAL::exact(center.x())), CGAL::to_double(CGAL::exact(center.y())),
                           CGAL::to_double(CGAL::exact(center.z()))};
    const Point_3 c = circumcenter(p);
    EXPECT_LT(distance(c, expected), 1e-8 * distance(expected, p[0])) << k;
  }
}

}  // namespace
}  // namespace mesecina
