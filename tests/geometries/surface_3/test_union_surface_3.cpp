// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>
#include <numbers>
#include <stop_token>

#include "geometries/surface_3/union_surface_3.h"
#include "tests/geometries/shapes.h"
#include "tests/geometries/surface_3/surface_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

std::shared_ptr<const Dual_3> dual_of(const std::vector<Ball_3>& balls) {
  Progress progress;
  auto regular = std::make_shared<const Regular_3>(regular_triangulation(balls, progress));
  return std::make_shared<const Dual_3>(dual_complex(std::move(regular), progress));
}

Union_surface_3 surface_of(const std::vector<Ball_3>& balls, double tolerance) {
  Progress progress;
  return union_surface(dual_of(balls), tolerance, progress);
}

/// Closed, manifold, and with the topology of the boundary of the dual complex.
testing::AssertionResult has_right_topology(const std::vector<Ball_3>& balls, double tolerance) {
  Progress progress;
  const auto dual = dual_of(balls);
  const Union_surface_3 surface = union_surface(dual, tolerance, progress);
  if (auto result = is_closed_manifold(surface.mesh); !result) return result;
  if (surface.ball_of_triangle.size() != surface.mesh.triangles.size())
    return testing::AssertionFailure() << "not every triangle has a ball";
  for (const Point_3& p : surface.mesh.vertices)
    if (!std::isfinite(p.x + p.y + p.z)) return testing::AssertionFailure() << "a vertex is nowhere";
  const Topology of_union = mesecina::topology(*dual);
  const Topology found = topology(surface.mesh);
  if (found.euler != 2 * of_union.euler)
    return testing::AssertionFailure() << "Euler characteristic " << found.euler << ", of the union " << of_union.euler;
  if (found.betti[0] != found.betti[2]) return testing::AssertionFailure() << "not every part is oriented";
  return testing::AssertionSuccess();
}

/// Vertices lie on the boundary, and neither mesh nor boundary is anywhere farther than the tolerance from the other.
testing::AssertionResult is_near(const std::vector<Ball_3>& balls, double tolerance) {
  const Union_surface_3 surface = surface_of(balls, tolerance);
  if (surface.deviation > 1.000001 * tolerance)
    return testing::AssertionFailure() << "reached " << surface.deviation << " instead of " << tolerance;
  for (const Point_3& p : surface.mesh.vertices)
    if (const double d = distance_to_union(balls, p); std::abs(d) > 1e-6)
      return testing::AssertionFailure() << "a vertex is " << d << " off the boundary";
  const std::vector<Point_3> boundary = boundary_points(balls, tolerance / 2);
  for (const Point_3& p : boundary)
    if (const double d = distance_to_mesh(surface.mesh, p); d > tolerance)
      return testing::AssertionFailure() << "the boundary is " << d << " off the mesh";
  for (const Point_3& p : mesh_points(surface.mesh)) {
    double least = 1e9;
    for (const Point_3& q : boundary) least = std::min(least, distance(p, q));
    if (least > 1.7 * tolerance) return testing::AssertionFailure() << "the mesh is " << least << " off the boundary";
  }
  return testing::AssertionSuccess();
}

/// No triangle is deeper in the union than the tolerance.
testing::AssertionResult is_outside(const Union_surface_3& surface, const std::vector<Ball_3>& balls,
                                    double tolerance) {
  for (const auto& [a, b, c] : surface.mesh.triangles) {
    const auto& p = surface.mesh.vertices;
    const double d = distance_to_union(balls, (1.0 / 3) * (p[a] + p[b] + p[c]));
    if (d < -tolerance) return testing::AssertionFailure() << "a triangle is " << -d << " inside of the union";
  }
  return testing::AssertionSuccess();
}

TEST(Union_surface_3, HasTheTopologyOfDifficultSets) {
  for (const auto& [name, balls, betti] : difficult_ball_sets()) {
    for (const double tolerance : {2.0, 0.2}) {
      EXPECT_TRUE(has_right_topology(balls, tolerance)) << name << " at " << tolerance;
    }
  }
}

TEST(Union_surface_3, BoundsClearShapes) {
  struct Shape {
    std::string name;
    std::vector<Ball_3> balls;
    std::array<std::int64_t, 3> betti;
  };
  std::vector<Ball_3> ring;
  for (int i = 0; i < 12; ++i) {
    const double turn = i * std::numbers::pi / 6;
    ring.push_back({{2 * std::cos(turn), 2 * std::sin(turn), 0}, 0.7});
  }
  std::vector<Ball_3> shell;
  for (int i = 0; i < 60; ++i) {
    const double z = 1 - (2 * i + 1.0) / 60;
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    shell.push_back(
        {{2 * std::sqrt(1 - z * z) * std::cos(turn), 2 * std::sqrt(1 - z * z) * std::sin(turn), 2 * z}, 0.8});
  }
  std::vector<Ball_3> shell_with_core = shell;
  shell_with_core.push_back({{0.1, 0, 0}, 0.7});
  const std::vector<Shape> shapes{
      {"one", {{{3, -1, 2}, 2}}, {1, 0, 1}},
      {"two apart", {{{0, 0, 0}, 1}, {{5, 0, 0}, 2}}, {2, 0, 2}},
      {"two crossing", {{{0, 0, 0}, 2}, {{3, 0.5, 0}, 1.7}}, {1, 0, 1}},
      {"two nested", {{{0, 0, 0}, 3}, {{1, 0, 0}, 1}}, {1, 0, 1}},
      {"a bite of a bite", {{{0, 0, 0}, 2}, {{1.5, 0, 0}, 1}, {{1.5, 0.9, 0}, 0.8}}, {1, 0, 1}},
      {"ring", ring, {1, 2, 1}},
      {"shell", shell, {2, 0, 2}},
      {"shell around a ball", shell_with_core, {3, 0, 3}}};
  for (const auto& [name, balls, betti] : shapes) {
    const Union_surface_3 surface = surface_of(balls, 0.1);
    EXPECT_TRUE(has_right_topology(balls, 0.1)) << name;
    EXPECT_EQ(topology(surface.mesh).betti, betti) << name;
    EXPECT_TRUE(is_near(balls, 0.25)) << name;
    EXPECT_EQ(surface.folded_patches, 0u) << name;
  }
}

TEST(Union_surface_3, SpheresMayMeetInTheSmallestCircles) {
  // From circles of ordinary size down to what rounding leaves of them, and gaps of the same size.
  for (const double overlap : {1e-1, 1e-3, 1e-5, 1e-8, 1e-11, 1e-13, 1e-15, 0.0, -1e-15, -1e-8}) {
    const std::vector<Ball_3> balls{
        {{0, 0, 0}, 1}, {{2 - overlap, 0, 0}, 1}, {{-1.1, 1.2, 0.3}, std::sqrt(2.74) - 1 + overlap}};
    EXPECT_TRUE(has_right_topology(balls, 0.02)) << overlap;
    const Union_surface_3 surface = surface_of(balls, 0.02);
    EXPECT_LE(surface.deviation, 0.02 * 1.000001) << overlap;
    EXPECT_EQ(surface.folded_patches, 0u) << overlap;
    const double of_balls = 4 * std::numbers::pi / 3 * (2 + std::pow(balls[2].radius, 3));
    EXPECT_NEAR(signed_volume(surface.mesh), of_balls, 0.4) << overlap;
  }
}

TEST(Union_surface_3, ASphereIsMoreThanTheBumpsOnIt) {
  // The only loop around nearly all of the sphere is smaller than the tolerance.
  const std::vector<Ball_3> balls{{{0, 0, 0}, 1}, {{1, 0, 0}, 0.01}, {{1, 0.012, 0}, 0.01}, {{1, 0.006, 0.01}, 0.01}};
  EXPECT_TRUE(has_right_topology(balls, 0.03));
  EXPECT_NEAR(signed_volume(surface_of(balls, 0.03).mesh), 4 * std::numbers::pi / 3, 0.3);
}

TEST(Union_surface_3, IsOrientedOutward) {
  constexpr double of_unit_ball = 4 * std::numbers::pi / 3;
  EXPECT_NEAR(signed_volume(surface_of({{{5, 5, 5}, 1}}, 1e-3).mesh), of_unit_ball, 0.02);
  // Two unit balls at distance 1 have in common two caps of height 1/2.
  const double lens = 2 * std::numbers::pi * 0.25 * (3 - 0.5) / 3;
  EXPECT_NEAR(signed_volume(surface_of({{{5, 5, 5}, 1}, {{5, 6, 5}, 1}}, 1e-3).mesh), 2 * of_unit_ball - lens, 0.04);
  const std::vector<Ball_3> tetrahedron{{{1, 1, 1}, 1.7}, {{1, -1, -1}, 1.7}, {{-1, 1, -1}, 1.7}, {{-1, -1, 1}, 1.7}};
  const auto surface = surface_of(tetrahedron, 1e-3);
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.mesh.triangles[t];
    const auto& p = surface.mesh.vertices;
    EXPECT_GT(dot(cross(p[b] - p[a], p[c] - p[a]), p[a] - tetrahedron[surface.ball_of_triangle[t]].center), 0);
  }
}

TEST(Union_surface_3, IsClosedOfRandomSets) {
  expect_of_balls(repetitions(12), [](const std::vector<Ball_3>& balls) { return has_right_topology(balls, 1); });
}

TEST(Union_surface_3, IsWithinToleranceOfRandomSets) {
  Random random(7);
  for (std::uint64_t seed = 0; seed < repetitions(4); ++seed) {
    std::vector<Ball_3> balls;
    for (int i = 0; i < 8; ++i) {
      const Point_3 center{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      balls.push_back({center, random.uniform(0.1, 0.8)});
    }
    EXPECT_TRUE(is_near(balls, 0.1)) << to_text(balls);
    EXPECT_TRUE(has_right_topology(balls, 0.1)) << to_text(balls);
  }
}

TEST(Union_surface_3, GoesAroundManyBalls) {
  for (const double neighbors : {2.0, 6.0, 20.0}) {
    const auto balls = many_balls(3000, neighbors, 5);
    EXPECT_TRUE(has_right_topology(balls, 0.002)) << neighbors;
    const Union_surface_3 surface = surface_of(balls, 0.002);
    EXPECT_LE(surface.deviation, 0.002 * 1.000001) << neighbors;
    EXPECT_TRUE(is_outside(surface, balls, 0.002)) << neighbors;
    EXPECT_EQ(surface.folded_patches, 0u) << neighbors;
  }
}

TEST(Union_surface_3, GoesAroundTheBallsOfSolids) {
  for (const auto& solid : smooth_solids()) {
    const auto balls = inner_voronoi_balls(solid, 1500, 1e-4, 3);
    const Union_surface_3 surface = surface_of(balls, 0.01);
    EXPECT_TRUE(has_right_topology(balls, 0.01)) << solid.name;
    EXPECT_EQ(surface.folded_patches, 0u) << solid.name;
    EXPECT_TRUE(is_outside(surface, balls, 0.01)) << solid.name;
    const Topology found = topology(surface.mesh);
    EXPECT_EQ(found.betti[0], solid.betti[0] + solid.betti[2]) << solid.name;
    EXPECT_EQ(found.betti[1], 2 * solid.betti[1]) << solid.name;
    for (const Point_3& p : surface.mesh.vertices) EXPECT_NEAR(distance_to_union(balls, p), 0, 1e-7) << solid.name;
  }
}

TEST(Union_surface_3, IsClosedWhereSpheresNearlyMeetInSamples) {
  for (const auto& solid : smooth_solids()) {
    const auto balls = inner_voronoi_balls(solid, 600, 0, 3);
    EXPECT_TRUE(has_right_topology(balls, 0.01)) << solid.name;
    EXPECT_TRUE(is_outside(surface_of(balls, 0.01), balls, 0.01)) << solid.name;
  }
}

TEST(Union_surface_3, DependsNeitherOnTheThreadsNorOnTheRun) {
  const auto balls = many_balls(2000, 6, 9);
  const auto one = surface_of(balls, 0.005);
  Progress two_threads(std::stop_token(), {}, 2);
  const auto other = union_surface(dual_of(balls), 0.005, two_threads);
  EXPECT_EQ(one.mesh, other.mesh);
  EXPECT_EQ(one.ball_of_triangle, other.ball_of_triangle);
}

TEST(Union_surface_3, MovesWithTheBalls) {
  // By a power of two, so that nothing is rounded.
  const auto balls = many_balls(200, 6, 4);
  auto scaled = balls;
  for (Ball_3& ball : scaled) ball = {1024.0 * ball.center, 1024.0 * ball.radius};
  const auto small = surface_of(balls, 0.01);
  const auto large = surface_of(scaled, 10.24);
  EXPECT_EQ(small.mesh.triangles, large.mesh.triangles);
}

TEST(Union_surface_3, CanBeCancelled) {
  std::stop_source source;
  source.request_stop();
  Progress progress(source.get_token());
  const auto dual = dual_of(many_balls(100, 6, 4));
  EXPECT_THROW(union_surface(dual, 0.01, progress), Cancelled);
}

}  // namespace
}  // namespace mesecina::test
