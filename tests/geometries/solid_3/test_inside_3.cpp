// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

void expect_inside_as_defined(const Triangle_mesh_3& mesh, int count) {
  const Solid_3 solid = solid_of(mesh);
  std::vector<Point_3> points = points_around(mesh, count, 1);
  const std::vector<Point_3> difficult = difficult_points(mesh, count, 2);
  points.insert(points.end(), difficult.begin(), difficult.end());
  const std::vector<std::uint8_t> inside = inside_of(solid, points);
  int insides = 0;
  int outsides = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool expected = place_of(mesh, points[i]) != Place::outside;
    ++(expected ? insides : outsides);
    ASSERT_EQ(inside[i] != 0, expected) << points[i].x << ' ' << points[i].y << ' ' << points[i].z;
  }
  EXPECT_GT(insides, 0);
  EXPECT_GT(outsides, 0);
}

TEST(Inside_3, BoxWithRaysThroughEdgesAndCorners) { expect_inside_as_defined(box_mesh({0, 0, 0}, {4, 3, 2}), 400); }

TEST(Inside_3, RaysThroughAVertexCountOnce) {
  const Triangle_mesh_3 mesh{{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}, {1, 1, 1}},
                             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  expect_inside_as_defined(mesh, 300);
  EXPECT_EQ(inside_of(solid_of(mesh), {{1, 1, -1}, {0.5, 0.5, -1}, {1, 1, 0.5}, {1, 1, 2}, {0.5, 0.5, 0.25}}),
            (std::vector<std::uint8_t>{0, 0, 1, 0, 1}));
}

TEST(Inside_3, PointsOfALatticeThatHoldsTheSurface) {
  const Triangle_mesh_3 mesh = joined({box_mesh({0, 0, 0}, {6, 6, 6}), box_mesh({2, 2, 2}, {4, 4, 4})});
  const Solid_3 solid = solid_of(mesh);
  std::vector<Point_3> points;
  for (int x = -1; x <= 7; ++x)
    for (int y = -1; y <= 7; ++y)
      for (int z = -1; z <= 7; ++z)
        points.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
  const std::vector<std::uint8_t> inside = inside_of(solid, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point_3& p = points[i];
    const bool in_large = p.x >= 0 && p.x <= 6 && p.y >= 0 && p.y <= 6 && p.z >= 0 && p.z <= 6;
    const bool in_hole = p.x > 2 && p.x < 4 && p.y > 2 && p.y < 4 && p.z > 2 && p.z < 4;
    EXPECT_EQ(inside[i] != 0, in_large && !in_hole) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

TEST(Inside_3, Sphere) { expect_inside_as_defined(sphere_mesh({1, 2, 3}, 2), 200); }

TEST(Inside_3, Torus) { expect_inside_as_defined(torus_mesh(3, 1), 150); }

TEST(Inside_3, FarFromTheOrigin) { expect_inside_as_defined(sphere_mesh({1e7, -2e7, 3e7}, 2), 100); }

TEST(Inside_3, VeryLargeAndVerySmall) {
  for (const double scale : {1e-60, 1e60}) {
    Triangle_mesh_3 mesh = torus_mesh(3, 1, 12, 8);
    for (Point_3& p : mesh.vertices) p = scale * p;
    const Solid_3 solid = solid_of(mesh);
    EXPECT_EQ(solid.treatment, "none");
    EXPECT_EQ(inside_of(solid, {{3 * scale, 0, 0}, {0, 0, 0}, mesh.vertices[5]}), (std::vector<std::uint8_t>{1, 0, 1}));
  }
}

TEST(Inside_3, PointsNextToTheSurface) {
  const Triangle_mesh_3 mesh = box_mesh({0, 0, 0}, {1, 1, 1});
  const Solid_3 solid = solid_of(mesh);
  const double below = std::nextafter(0.0, -1.0);
  const double above = std::nextafter(1.0, 2.0);
  EXPECT_EQ(inside_of(solid, {{0.25, 0.5, 0},
                              {0.25, 0.5, below},
                              {0.25, 0.5, 1},
                              {0.25, 0.5, above},
                              {1, 1, 1},
                              {above, 1, 1},
                              {0.5, 0, 0.5},
                              {0.5, below, 0.5}}),
            (std::vector<std::uint8_t>{1, 0, 1, 0, 1, 0, 1, 0}));
}

TEST(Inside_3, SameForEveryNumberOfThreads) {
  const Triangle_mesh_3 mesh = torus_mesh(3, 1, 200, 100);
  const Solid_3 one = solid_of(mesh, Repair::automatic, 1);
  const Solid_3 four = solid_of(mesh, Repair::automatic, 4);
  EXPECT_EQ(one.surface, four.surface);
  const std::vector<Point_3> points = points_around(mesh, 30000, 3);
  EXPECT_EQ(inside_of(one, points, 1), inside_of(four, points, 4));
  Progress single;
  Progress several({}, {}, 4);
  EXPECT_EQ(distances_to_surface(one, points, single), distances_to_surface(four, points, several));
}

TEST(Inside_3, DistancesAreThoseOfTheNearestTriangle) {
  Triangle_mesh_3 mesh = joined({torus_mesh(3, 1, 20, 10), box_mesh({8, 0, 0}, {9, 1, 1})});
  // A needle: its barycentric coordinates are lost in rounding.
  mesh = joined({mesh, box_mesh({12, 0, 0}, {20, 1e-9, 1})});
  const Solid_3 solid = solid_of(mesh);
  std::vector<Point_3> points = points_around(mesh, 1500, 4);
  const std::vector<Point_3> difficult = difficult_points(mesh, 500, 5);
  points.insert(points.end(), difficult.begin(), difficult.end());
  Progress progress;
  const std::vector<double> distances = distances_to_surface(solid, points, progress);
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_NEAR(distances[i], distance_to(solid.surface, points[i]), 1e-9) << i;
}

}  // namespace
}  // namespace mesecina::test
