// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/graph.h"
#include "geometries/delaunay_parts_3/delaunay_parts_3.h"
#include "geometries/modules_3.h"
#include "tests/geometries/power_crust_3/delaunay_oracle_3.h"

namespace mesecina::test {
namespace {

using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Exact_kernel::Point_3 exact_point(const Point_3& p) { return {p.x, p.y, p.z}; }

Outcome<Primitive_set> hull_of(const Cloud& cloud) {
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(cloud_input, cloud));
  Progress progress;
  return graph.layer("convex-hull", progress);
}

double signed_volume(const Primitive_set& hull) {
  double sum = 0;
  for (const auto& [a, b, c] : hull.triangles)
    sum += dot(hull.vertices[a], cross(hull.vertices[b], hull.vertices[c])) / 6;
  return sum;
}

TEST(Convex_hull_3, EveryPointLiesBehindEveryTriangle) {
  for (const Cloud& cloud : {random_cloud(60, 2), integer_cloud(60, 3, 5), lattice(3), cube_surface(4),
                             sphere_cloud({1, 2, 3}, 0.5, 50, 7), shuffled(lattice(3), 4)}) {
    const auto hull = hull_of(cloud);
    ASSERT_TRUE(hull) << hull.reason;
    for (const auto& [a, b, c] : hull.value->triangles) {
      const auto p = exact_point(hull.value->vertices[a]);
      const auto q = exact_point(hull.value->vertices[b]);
      const auto r = exact_point(hull.value->vertices[c]);
      ASSERT_FALSE(CGAL::collinear(p, q, r));
      for (const Point_3& point : cloud) ASSERT_NE(CGAL::orientation(p, q, r, exact_point(point)), CGAL::POSITIVE);
    }
    const auto found = topology(*hull.value);
    ASSERT_TRUE(found);
    EXPECT_EQ(*found, (Topology{2, {1, 0, 1}}));
  }
}

TEST(Convex_hull_3, HasTheVolumeOfTheTetrahedraAndTheVerticesOnTheHull) {
  EXPECT_NEAR(signed_volume(*hull_of(lattice(4)).value), 27, 1e-9);
  EXPECT_EQ(hull_of(lattice(4)).value->vertices.size(), 64u - 8u);
  const Cloud cloud = random_cloud(40, 9);
  const auto hull = hull_of(cloud);
  ASSERT_TRUE(hull);
  for (int i = 0; i < 40; ++i)
    EXPECT_EQ(std::ranges::count(hull.value->vertices, cloud[i]), is_on_hull(cloud, i, i) ? 1 : 0) << i;
  double sum = 0;
  Progress progress;
  const Delaunay_3 triangulation = delaunay(cloud, progress);
  for (const auto& [a, b, c, d] : triangulation.cells)
    sum += dot(cross(cloud[b] - cloud[a], cloud[c] - cloud[a]), cloud[d] - cloud[a]) / 6;
  EXPECT_NEAR(signed_volume(*hull.value), sum, 1e-12);
}

TEST(Convex_hull_3, IsOneTetrahedronForFourPointsAndHasAReasonForFewer) {
  const auto hull = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 1}});
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull.value->triangles.size(), 4u);
  EXPECT_NEAR(signed_volume(*hull.value), 1.0 / 6, 1e-15);
  const auto flat = hull_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
  EXPECT_FALSE(flat);
  EXPECT_THAT(flat.reason, testing::HasSubstr("one plane"));
}

}  // namespace
}  // namespace mesecina::test
