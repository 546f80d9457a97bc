// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/outcome.h"
#include "tests/geometries/power_crust_3/crust_checks_3.h"
#include "tests/growth.h"

namespace mesecina::test {
namespace {

constexpr Topology of_ball{1, {1, 0, 0}};

/// A smooth solid of which the crust must have the topology everywhere.
void expect_solid(const Cloud& cloud, const Topology& solid) {
  const Crust_3 crust = crust_of(cloud);
  expect_closed(crust.surface);
  EXPECT_EQ(topology(crust.shape), solid);
  EXPECT_EQ(topology_of_inner_balls(crust.polar), solid);
  const auto surface = topology(primitives_of(crust.surface));
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->betti[0], solid.betti[0] + solid.betti[2]);
  EXPECT_EQ(surface->betti[1], 2 * solid.betti[1]);
  EXPECT_EQ(surface->euler, 2 * solid.euler);
  EXPECT_EQ(crust.polar.unlabelled_count, 0u);
}

TEST(Power_crust_3, OfACubeIsTheCube) {
  const Crust_3 crust = crust_of(lattice(2));
  expect_sound(crust);
  EXPECT_EQ(crust.surface.face_count(), 6u);
  EXPECT_EQ(crust.surface.vertices.size(), 8u);
  EXPECT_TRUE(std::ranges::none_of(crust.surface.samples, [](int sample) { return sample < 0; }));
  EXPECT_NEAR(volume(crust.surface), 1, 1e-12);
}

TEST(Power_crust_3, OfATetrahedronIsTheTetrahedron) {
  const Crust_3 crust = crust_of({{0, 0, 0}, {1, 0, 0}, {0.5, 0.9, 0}, {0.5, 0.3, 0.8}});
  expect_sound(crust);
  EXPECT_EQ(crust.surface.face_count(), 4u);
  EXPECT_NEAR(volume(crust.surface), 0.9 * 0.8 / 6, 1e-4);
}

TEST(Power_crust_3, IsSoundForAnyPoints) {
  int with_surface = 0;
  std::vector<Cloud> clouds{lattice(3), lattice(4), lattice(5), lattice(7), cube_surface(6)};
  for (std::uint64_t seed = 1; seed <= 12; ++seed) clouds.push_back(random_cloud(40, seed));
  for (std::uint64_t seed = 1; seed <= 12; ++seed) clouds.push_back(integer_cloud(60, 5, seed));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) clouds.push_back(sphere_cloud({2, 3, 4}, 5, 60, seed));
  for (const Cloud& cloud : clouds) {
    const Crust_3 crust = crust_of(cloud);
    expect_sound(crust);
    with_surface += crust.surface.face_count() > 0 ? 1 : 0;
    EXPECT_EQ(crust.surface.face_count() > 0, std::ranges::count(crust.polar.is_inner, 1) > 0);
  }
  EXPECT_GT(with_surface, 20);
}

TEST(Power_crust_3, HasTheTopologyOfTheSolid) {
  expect_solid(sphere_cloud({1, 2, 3}, 2, 800, 1), of_ball);
  expect_solid(ellipsoid_cloud(2000, 2), of_ball);
  expect_solid(torus_cloud(1, 0.4, 1500, 3), {0, {1, 1, 0}});
  expect_solid(joined(torus_cloud(1, 0.4, 1500, 4), sphere_cloud({0, 0, 3}, 1, 500, 5)), {1, {2, 1, 0}});
  // A shell: what is within the inner sphere is outside.
  expect_solid(joined(sphere_cloud({0, 0, 0}, 1, 1000, 6), sphere_cloud({0, 0, 0}, 2, 3000, 7)), {2, {1, 0, 1}});
  expect_solid(cube_surface(12), of_ball);
}

TEST(Power_crust_3, LiesAlongADenselySampledSurface) {
  const Cloud cloud = torus_cloud(1, 0.4, 3000, 11);
  const Crust_3 crust = crust_of(cloud);
  double farthest = 0;
  for (const Point_3& p : crust.surface.vertices)
    farthest = std::max(farthest, std::abs(std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4));
  EXPECT_LT(farthest, 0.05);
  EXPECT_GT(std::ranges::count_if(crust.surface.samples, [](int sample) { return sample >= 0; }), 2800);
  EXPECT_NEAR(volume(crust.surface), 2 * std::numbers::pi * std::numbers::pi * 0.4 * 0.4, 0.02);
  EXPECT_TRUE(crust.polar.contradictions.empty());
  const Poles_3& poles = *crust.polar.poles;
  for (std::size_t p = 0; p < poles.finite_count; ++p) {
    const Point_3& c = poles.balls[p].center;
    EXPECT_EQ(crust.polar.is_inner[p] != 0, std::hypot(std::hypot(c.x, c.y) - 1, c.z) < 0.4);
    EXPECT_GT(crust.polar.confidence[p], 0.5);
  }
}

TEST(Power_crust_3, DoesNotDependOnTheOrderOfPoints) {
  const Cloud cloud = ellipsoid_cloud(1500, 21);
  const Crust_3 one = crust_of(cloud);
  const Crust_3 other = crust_of(shuffled(cloud, 5));
  EXPECT_EQ(one.polar.poles->size(), other.polar.poles->size());
  EXPECT_EQ(std::ranges::count(one.polar.is_inner, 1), std::ranges::count(other.polar.is_inner, 1));
  EXPECT_NEAR(volume(one.surface), volume(other.surface), 1e-6);
}

TEST(Power_crust_3, OfAnOpenSurfaceIsClosedAllTheSame) {
  Cloud bowl = sphere_cloud({0, 0, 0}, 1, 2000, 31);
  std::erase_if(bowl, [](const Point_3& p) { return p.z > 0.3; });
  const Crust_3 crust = crust_of(bowl);
  expect_closed(crust.surface);
  EXPECT_GT(crust.surface.face_count(), 0u);
}

TEST(Power_crust_3, MovesTheCentersOfItsBalls) {
  const Crust_3 crust = crust_of(ellipsoid_cloud(300, 41));
  const std::vector<Ball_3> as_they_are = inner_polar_balls(crust.polar, 0);
  const std::vector<Ball_3> moved = inner_polar_balls(crust.polar, 1e-3);
  ASSERT_EQ(as_they_are.size(), moved.size());
  std::size_t next = 0;
  for (std::size_t p = 0; p < crust.polar.poles->finite_count; ++p) {
    if (crust.polar.is_inner[p] == 0) continue;
    const Ball_3& ball = as_they_are[next];
    EXPECT_EQ(ball, crust.polar.poles->balls[p]);
    EXPECT_EQ(moved[next].radius, ball.radius);
    EXPECT_GT(distance(moved[next].center, ball.center), 0);
    EXPECT_LT(distance(moved[next].center, ball.center), 2e-3 * ball.radius);
    ++next;
  }
  EXPECT_EQ(next, moved.size());
}

TEST(Power_crust_3, HasNoBallsWhereNothingIsEnclosed) {
  Polar_balls_3 polar = crust_of(random_cloud(50, 3)).polar;
  std::ranges::fill(polar.is_inner, std::uint8_t{0});
  Progress progress;
  EXPECT_EQ(power_crust(polar, progress).face_count(), 0u);
  EXPECT_EQ(topology(power_shape(polar, progress)), Topology());
  EXPECT_THROW(inner_polar_balls(polar, 0), Unavailable);
}

TEST(Power_crust_3, OneThreadAndTwoGiveTheSame) {
  const Cloud cloud = ellipsoid_cloud(9000, 51);
  const Crust_3 one = crust_of(cloud, 1);
  const Crust_3 two = crust_of(cloud, 2);
  EXPECT_EQ(one.polar.is_inner, two.polar.is_inner);
  EXPECT_EQ(one.polar.confidence, two.polar.confidence);
  EXPECT_EQ(one.surface.vertices, two.surface.vertices);
  EXPECT_EQ(one.surface.face_vertices, two.surface.face_vertices);
  EXPECT_EQ(one.surface.face_offsets, two.surface.face_offsets);
}

TEST(Power_crust_3, StopsWhenCancelled) {
  const Crust_3 crust = crust_of(ellipsoid_cloud(500, 61));
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  EXPECT_THROW(label_poles(crust.polar.poles, crust.polar.regular, progress), Cancelled);
  EXPECT_THROW(power_crust(crust.polar, progress), Cancelled);
  EXPECT_THROW(power_shape(crust.polar, progress), Cancelled);
}

TEST(Power_crust_3, GrowsNearlyLinearly) {
  const Cloud small = ellipsoid_cloud(4000, 71);
  const Cloud large = ellipsoid_cloud(16000, 72);
  EXPECT_LT(growth([&] { crust_of(small); }, [&] { crust_of(large); }, 5.5), 7);
}

TEST(Power_crust_3, OfRealShapes) {
  MESECINA_NEED_DATA();
  struct Shape {
    std::string file;
    int genus;
  };
  const std::vector<Shape> shapes{{"points_kitten.xyz", 1}, {"points_knot.pts", 1}, {"fertility.off", 4},
                                  {"armadillo.obj", 0},     {"dolphin.off", 0},     {"hand.obj", 0}};
  for (const auto& [file, genus] : shapes) {
    const Crust_3 crust = crust_of(real_cloud(file), 2);
    expect_closed(crust.surface);
    EXPECT_EQ(topology(crust.shape), (Topology{1 - genus, {1, genus, 0}})) << file;
    EXPECT_EQ(topology_of_inner_balls(crust.polar), (Topology{1 - genus, {1, genus, 0}})) << file;
    EXPECT_EQ(topology(primitives_of(crust.surface)), (Topology{2 - 2 * genus, {1, 2 * genus, 1}})) << file;
    EXPECT_GT(volume(crust.surface), 0) << file;
  }
}

TEST(Power_crust_3, OfRealSharpShapesIsClosed) {
  MESECINA_NEED_DATA();
  for (const std::string file : {"fandisk.off", "anchor_dense.off", "goathead.obj", "bad_open_scan_demosthenes.obj"}) {
    const Crust_3 crust = crust_of(real_cloud(file), 2);
    expect_closed(crust.surface);
    EXPECT_EQ(topology(primitives_of(crust.surface))->euler, 2 * topology(crust.shape).euler) << file;
  }
}

}  // namespace
}  // namespace mesecina::test
