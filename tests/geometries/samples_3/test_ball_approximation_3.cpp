// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/outcome.h"
#include "tests/geometries/samples_3/approximations_3.h"
#include "tests/geometries/samples_3/surface_checks_3.h"
#include "tests/geometries/solid_3/meshes_3.h"

namespace mesecina::test {
namespace {

struct Case {
  std::string name;
  Triangle_mesh_3 mesh;
  double distance;
  std::array<std::int64_t, 3> betti;
  double error = 0.4;
};

std::vector<Case> cases() {
  const std::vector<Point_2> angle{{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}};
  return {{"cube", box_mesh({0, 0, 0}, {1, 1, 1}), 0.05, {1, 0, 0}},
          {"coarse_cube", box_mesh({0, 0, 0}, {1, 1, 1}), 0.3, {1, 0, 0}},
          {"plate", box_mesh({0, 0, 0}, {1, 1, 0.01}), 0.05, {1, 0, 0}},
          {"angle", column_mesh(angle, 1), 0.05, {1, 0, 0}},
          {"two_spheres", joined({sphere_mesh({0, 0, 0}, 1, 24), sphere_mesh({2.02, 0, 0}, 1, 24)}), 0.08, {2, 0, 0}},
          {"hollow_sphere",
           joined({sphere_mesh({0, 0, 0}, 1, 24), turned(sphere_mesh({0, 0, 0}, 0.8, 24))}),
           0.08,
           {1, 0, 1}},
          {"thin_hollow_sphere",
           joined({sphere_mesh({0, 0, 0}, 1, 16), turned(sphere_mesh({0, 0, 0}, 0.95, 16))}),
           0.1,
           {1, 0, 1}},
          {"torus", torus_mesh(1, 0.3, 48, 24), 0.06, {1, 1, 0}},
          {"thin_torus", torus_mesh(1, 0.03, 48, 12), 0.1, {1, 1, 0}}};
}

std::string name_of(const testing::TestParamInfo<Case>& parameter) { return parameter.param.name; }

class Approximated_shape_3 : public testing::TestWithParam<Case> {};

TEST_P(Approximated_shape_3, HasTheTopologyOfTheSolidAndIsNearIt) {
  const auto& [name, mesh, distance, betti, limit] = GetParam();
  const Solid_3 solid = solid_of(mesh);
  ASSERT_TRUE(solid.topology);
  EXPECT_EQ(solid.topology->betti, betti);
  const Ball_approximation_3 result = approximation_of(solid, distance, 2);
  EXPECT_EQ(topology(*result.dual).betti, betti);
  EXPECT_EQ(topology_of_axis(result).betti, betti);
  EXPECT_FALSE(result.is_exhausted);
  EXPECT_LE(error_of(solid, result, distance), limit);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Approximated_shape_3, testing::ValuesIn(cases()), name_of);

TEST(Ball_approximation_3, OfAWedgeHasNoTunnelsAlongItsEdge) {
  constexpr double spacing = 0.05;
  for (const double half : {0.05, 0.1, 0.2, 0.3, 0.6}) {
    const Solid_3 solid = solid_of(column_mesh({{0, 0}, {1, -half}, {1, half}}, 1));
    const Ball_approximation_3 result = approximation_of(solid, spacing, 2);
    const std::array<std::int64_t, 3> ball{1, 0, 0};
    EXPECT_EQ(topology(*result.dual).betti, ball) << half;
    EXPECT_EQ(topology_of_axis(result).betti, ball) << half;
    EXPECT_FALSE(result.is_exhausted) << half;
    EXPECT_LE(error_of(solid, result, spacing), 0.4) << half;
  }
}

TEST(Ball_approximation_3, IsOneWhole) {
  const Solid_3 solid = solid_of(box_mesh({0, 0, 0}, {1, 1, 0.05}));
  const Ball_approximation_3 result = approximation_of(solid, 0.1);
  ASSERT_FALSE(result.balls.empty());
  EXPECT_EQ(result.regular->balls.size(), result.balls.size());
  EXPECT_EQ(result.dual->regular, result.regular);
  EXPECT_EQ(result.samples.covering_radius, 0.1);
  EXPECT_GT(result.samples.points.size(), result.even_sample_count);
  Progress progress;
  const Surface_samples_3 even = sample_surface(solid.surface, 0.1, progress);
  ASSERT_EQ(even.points.size(), result.even_sample_count);
  EXPECT_TRUE(std::equal(even.points.begin(), even.points.end(), result.samples.points.begin()));
  for (const Ball_3& ball : result.balls) {
    EXPECT_NEAR(distance_to_nearest(result.samples.points, ball.center), ball.radius, 1e-3 * ball.radius);
    for (const auto& [c, top] : {std::pair{ball.center.x, 1.0}, {ball.center.y, 1.0}, {ball.center.z, 0.05}}) {
      EXPECT_GT(c, -1e-4);
      EXPECT_LT(c, top + 1e-4);
    }
  }
}

TEST(Ball_approximation_3, NeedsNoMoreSamplesWhereTheEvenOnesDo) {
  const Solid_3 solid = solid_of(sphere_mesh({0, 0, 0}, 1, 48));
  const Ball_approximation_3 result = approximation_of(solid, 0.1);
  EXPECT_EQ(result.samples.points.size(), result.even_sample_count);
}

TEST(Ball_approximation_3, FollowsSizeAndPlace) {
  const Triangle_mesh_3 mesh = column_mesh({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}, 0.05);
  for (const double scale : {1e-6, 1e6}) {
    Triangle_mesh_3 other = mesh;
    for (Point_3& p : other.vertices) p = scale * (p + Point_3{-70, 30, 5});
    const Solid_3 solid = solid_of(other);
    const Ball_approximation_3 result = approximation_of(solid, 0.1 * scale);
    EXPECT_EQ(topology(*result.dual).betti, (std::array<std::int64_t, 3>{1, 0, 0})) << scale;
    EXPECT_LE(error_of(solid, result, 0.1 * scale), 0.4) << scale;
  }
}

TEST(Ball_approximation_3, OfASolidThinnerThanAnythingIsSomethingOrAReason) {
  for (const double thickness : {1e-7, 1e-12}) {
    const Solid_3 solid = solid_of(box_mesh({0, 0, 0}, {1, 1, thickness}));
    std::string reason;
    std::optional<Ball_approximation_3> result;
    try {
      result = approximation_of(solid, 0.3, 2);
    } catch (const Unavailable& error) {
      reason = error.what();
    }
    EXPECT_NE(result.has_value(), reason.find("choose a smaller {delta}") != std::string::npos) << thickness;
    if (!result) continue;
    EXPECT_LE(result->samples.points.size(), 2 * result->even_sample_count + 100'000) << thickness;
    for (const Ball_3& ball : result->balls) EXPECT_LT(ball.radius, 0.3) << thickness;
  }
}

TEST(Ball_approximation_3, TooFineASamplingIsRefused) {
  Progress progress;
  EXPECT_THROW(approximate_by_balls(solid_of(box_mesh({0, 0, 0}, {1, 1, 1})), 1e-6, 1e-4, progress), Unavailable);
}

TEST(Ball_approximation_3, StopsSoonWhenCancelled) {
  using Clock = std::chrono::steady_clock;
  const Solid_3 solid = solid_of(torus_mesh(1, 0.05, 96, 24));
  constexpr double distance = 0.02;
  const auto start = Clock::now();
  approximation_of(solid, distance, 2);
  const auto whole = Clock::now() - start;
  constexpr int parts = 10;
  int cancelled = 0;
  for (int part = 0; part < parts; ++part) {
    std::stop_source stop;
    Clock::time_point asked;
    std::jthread timer([&] {
      std::this_thread::sleep_for(whole * part / parts);
      asked = Clock::now();
      stop.request_stop();
    });
    Progress progress(stop.get_token(), {}, 2);
    try {
      approximate_by_balls(solid, distance, 1e-4, progress);
    } catch (const Cancelled&) {
      ++cancelled;
    }
    const auto end = Clock::now();
    timer.join();
    // Relative to the whole, which sanitizers and other programs make longer, too.
    EXPECT_LT(std::chrono::duration<double>(end - asked).count(),
              std::max(0.5, std::chrono::duration<double>(whole).count() / 2))
        << part;
  }
  EXPECT_GE(cancelled, parts / 2);
}

TEST(Ball_approximation_3, IsTheSameForEveryNumberOfThreads) {
  const Solid_3 solid = solid_of(torus_mesh(1, 0.02, 180, 30));
  const Ball_approximation_3 one = approximation_of(solid, 0.06, 1);
  EXPECT_GT(one.samples.points.size(), one.even_sample_count);
  const Ball_approximation_3 two = approximation_of(solid, 0.06, 2);
  ASSERT_EQ(one.balls.size(), two.balls.size());
  for (std::size_t i = 0; i < one.balls.size(); ++i) {
    ASSERT_EQ(one.balls[i].center, two.balls[i].center) << i;
    ASSERT_EQ(one.balls[i].radius, two.balls[i].radius) << i;
  }
  EXPECT_EQ(one.samples.points, two.samples.points);
  EXPECT_EQ(one.even_sample_count, two.even_sample_count);
  EXPECT_EQ(one.is_exhausted, two.is_exhausted);
}

}  // namespace
}  // namespace mesecina::test
