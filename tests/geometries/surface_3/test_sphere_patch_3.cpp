// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/sphere_patch_3.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mesecina::test {
namespace {

double area(const Sphere_patch_3& patch, const Patch_mesh_3& mesh) {
  std::vector<Point_3> points;
  for (const auto& loop : patch.loops) points.insert(points.end(), loop.begin(), loop.end());
  points.insert(points.end(), mesh.inner_points.begin(), mesh.inner_points.end());
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point_3 normal = cross(points[b] - points[a], points[c] - points[a]);
    sum += (dot(normal, points[a]) > 0 ? 0.5 : -0.5) * std::sqrt(dot(normal, normal));
  }
  return sum;
}

Point_3 on_sphere(double x, double y) { return {x, y, std::sqrt(1 - x * x - y * y)}; }

TEST(Sphere_patch_3, TheRestOfTheSphereIsThereHoweverSmallTheHole) {
  constexpr double deviation = 0.01;
  for (const double size : {0.1, 0.01, 0.001, 1e-5, 1e-7, 1e-9, 0.0}) {
    // A parallelogram: all triangles of its corners are obtuse.
    Sphere_patch_3 patch{{{0, 0, 0}, 1}, {}, on_sphere(1.5 * size, 0.25 * size), std::cos(0.2 * size)};
    patch.loops = {
        {on_sphere(0, 0), on_sphere(size, 0.5 * size), on_sphere(3 * size, 0.5 * size), on_sphere(2 * size, 0)}};
    const auto mesh = triangulate_patch(patch, deviation);
    ASSERT_TRUE(mesh) << size;
    EXPECT_NEAR(area(patch, *mesh), 4 * std::numbers::pi, 0.3) << size;
  }
}

TEST(Sphere_patch_3, LoopsThatCrossAreRefused) {
  const Sphere_patch_3 patch{
      {{0, 0, 0}, 1}, {{on_sphere(0, 0), on_sphere(0.1, 0.1), on_sphere(0.1, 0), on_sphere(0, 0.1)}}, {0, 0, -1}, 0.5};
  EXPECT_FALSE(triangulate_patch(patch, 0.1));
  EXPECT_EQ(fill_patch(patch).triangles.size(), 2u);
}

TEST(Sphere_patch_3, ASphereIsWithinTheDeviation) {
  for (const double deviation : {2.0, 0.3, 0.01, 0.001}) {
    const Patch_mesh_3 mesh = triangulate_sphere({{0, 0, 0}, 1}, deviation);
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto& p = mesh.inner_points;
      const Point_3 normal = cross(p[b] - p[a], p[c] - p[a]);
      EXPECT_GE(dot(normal, p[a]) / std::sqrt(dot(normal, normal)), 1 - deviation);
    }
  }
}

}  // namespace
}  // namespace mesecina::test
