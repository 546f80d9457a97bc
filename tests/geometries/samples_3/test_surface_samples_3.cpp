// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stop_token>

#include "core/outcome.h"
#include "geometries/samples_3/samples_3.h"
#include "tests/geometries/samples_3/surface_checks_3.h"
#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

Surface_samples_3 samples_of(const Triangle_mesh_3& mesh, double distance) {
  Progress progress;
  return sample_surface(mesh, distance, progress);
}

TEST(Surface_samples_3, CoverTheSurfaceAndKeepTheirDistance) {
  const Triangle_mesh_3 cube = box_mesh({0, 0, 0}, {1, 1, 1});
  const Triangle_mesh_3 far_away = box_mesh({1e6, -1e6, 2e5}, {1e6 + 1, -1e6 + 1, 2e5 + 1});
  const Triangle_mesh_3 needle = box_mesh({0, 0, 0}, {3, 1e-3, 1e-3});
  for (const auto& [mesh, spacing] : {std::pair{cube, 0.21},
                                      {cube, 3.0},
                                      {sphere_mesh({-2, 0, 0}, 1, 24), 0.17},
                                      {sphere_mesh({0, 0, 0}, 1, 4), 0.03},
                                      {far_away, 0.1},
                                      {needle, 0.2},
                                      {needle, 0.01}}) {
    const Surface_samples_3 samples = samples_of(mesh, spacing);
    EXPECT_EQ(samples.covering_radius, spacing);
    ASSERT_EQ(samples.spacing.size(), samples.points.size());
    for (const double s : samples.spacing) EXPECT_EQ(s, spacing);
    for (std::size_t i = 0; i < samples.points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        ASSERT_GE(distance(samples.points[i], samples.points[j]), 0.7 * spacing * (1 - 1e-9)) << i << ' ' << j;
    for (const Point_3& p : random_surface_points(mesh, 2000, 1))
      ASSERT_LE(distance_to_nearest(samples.points, p), spacing * (1 + 1e-9));
    for (const Point_3& p : samples.points) ASSERT_LE(distance_to(mesh, p), 1e-9 * (1 + std::sqrt(dot(p, p))));
  }
}

TEST(Surface_samples_3, CornersComeFirst) {
  const Triangle_mesh_3 cube = box_mesh({0, 0, 0}, {1, 1, 1});
  const Surface_samples_3 samples = samples_of(cube, 0.3);
  ASSERT_GT(samples.points.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(samples.points[i], cube.vertices[i]);
}

TEST(Surface_samples_3, OmitVerticesThatNoTriangleHas) {
  Triangle_mesh_3 cube = box_mesh({0, 0, 0}, {1, 1, 1});
  cube.vertices.push_back({5, 5, 5});
  for (const Point_3& p : samples_of(cube, 0.5).points) EXPECT_LE(p.x, 1);
}

TEST(Surface_samples_3, NormalsOfFlatFacesAreExact) {
  const Surface_samples_3 samples = samples_of(box_mesh({0, 0, 0}, {1, 1, 1}), 0.13);
  ASSERT_EQ(samples.normals.size(), samples.points.size());
  std::size_t flat = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Point_3& p = samples.points[i];
    Point_3 outward{};
    int sides = 0;
    const auto look = [&](double c, const Point_3& axis) {
      if (c == 0) outward = -1.0 * axis;
      if (c == 1) outward = axis;
      if (c == 0 || c == 1) ++sides;
    };
    look(p.x, {1, 0, 0});
    look(p.y, {0, 1, 0});
    look(p.z, {0, 0, 1});
    if (sides != 1) continue;
    ++flat;
    EXPECT_EQ(samples.normals[i], outward) << i;
  }
  EXPECT_GT(flat, 100u);
}

TEST(Surface_samples_3, NormalsHaveLengthOneAndPointOutward) {
  for (const double spacing : {0.4, 0.05}) {
    const Triangle_mesh_3 mesh = sphere_mesh({1, 2, 3}, 2, 16);
    const Surface_samples_3 samples = samples_of(mesh, spacing);
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      const Point_3& n = samples.normals[i];
      EXPECT_NEAR(dot(n, n), 1, 1e-12);
      EXPECT_GT(dot(n, samples.points[i] - Point_3{1, 2, 3}), 0.95 * 2);
    }
  }
  // At edges they are those of one side, which run along the other; outward of the solid also around a cavity.
  const Triangle_mesh_3 hollow = joined({box_mesh({0, 0, 0}, {3, 3, 3}), turned(box_mesh({1, 1, 1}, {2, 2, 2}))});
  const Surface_samples_3 samples = samples_of(hollow, 0.3);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    EXPECT_NEAR(dot(samples.normals[i], samples.normals[i]), 1, 1e-12);
    EXPECT_NE(place_of(hollow, samples.points[i] + 0.05 * samples.normals[i]), Place::inside) << i;
    EXPECT_NE(place_of(hollow, samples.points[i] - 0.05 * samples.normals[i]), Place::outside) << i;
  }
}

TEST(Surface_samples_3, TooManyAreRefused) {
  Progress progress;
  EXPECT_THROW(sample_surface(box_mesh({0, 0, 0}, {1, 1, 1}), 1e-6, progress), Unavailable);
}

TEST(Surface_samples_3, StopWhenCancelled) {
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  EXPECT_THROW(sample_surface(box_mesh({0, 0, 0}, {1, 1, 1}), 0.1, progress), Cancelled);
}

}  // namespace
}  // namespace mesecina::test
