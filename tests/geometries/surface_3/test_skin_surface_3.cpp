// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/skin_surface_3.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/outcome.h"
#include "tests/geometries/surface_3/surface_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

/// Vertices are that near to the skin surface of balls of size 1.
constexpr double near = 0.015;

Triangle_mesh_3 skin_of(const std::vector<Ball_3>& balls, double shrink_factor = 0.5) {
  Progress progress;
  return skin_surface(balls, shrink_factor, progress);
}

TEST(Skin_surface_3, OfOneBallIsItsSphere) {
  const Ball_3 ball{{3, -1, 2}, 2};
  const Triangle_mesh_3 skin = skin_of({ball});
  ASSERT_TRUE(is_closed_manifold(skin));
  EXPECT_EQ(topology(skin).betti, (std::array<std::int64_t, 3>{1, 0, 1}));
  EXPECT_GT(signed_volume(skin), 0);
  for (const Point_3& p : skin.vertices) EXPECT_NEAR(distance(p, ball.center), ball.radius, near * ball.radius);
}

TEST(Skin_surface_3, GoesAroundTheUnionAndKeepsItsShape) {
  std::vector<Ball_3> ring;
  for (int i = 0; i < 12; ++i) {
    const double turn = i * std::numbers::pi / 6;
    ring.push_back({{2 * std::cos(turn), 2 * std::sin(turn), 0}, 0.7});
  }
  double previous = 1e9;
  for (const double shrink_factor : {0.3, 0.6, 0.9}) {
    const Triangle_mesh_3 skin = skin_of(ring, shrink_factor);
    ASSERT_TRUE(is_closed_manifold(skin)) << shrink_factor;
    EXPECT_EQ(topology(skin).betti, (std::array<std::int64_t, 3>{1, 2, 1})) << shrink_factor;
    double farthest = 0;
    for (const Point_3& p : skin.vertices) {
      const double d = distance_to_union(ring, p);
      EXPECT_GT(d, -near) << shrink_factor;
      farthest = std::max(farthest, d);
    }
    EXPECT_GT(farthest, 0.01) << shrink_factor;
    EXPECT_LT(farthest, previous) << shrink_factor;
    previous = farthest;
  }
}

TEST(Skin_surface_3, IsClosedOfDifficultSets) {
  for (const auto& [name, balls, betti] : difficult_ball_sets()) {
    if (std::ranges::all_of(balls, [](const Ball_3& ball) { return ball.radius == 0; })) continue;
    const Triangle_mesh_3 skin = skin_of(balls);
    EXPECT_FALSE(skin.triangles.empty()) << name;
    EXPECT_TRUE(is_closed_manifold(skin)) << name;
  }
}

TEST(Skin_surface_3, RefusesWithAReason) {
  EXPECT_THROW(skin_of({}), Unavailable);
  EXPECT_THROW(skin_of({{{1, 2, 3}, 0}}), Unavailable);
  EXPECT_THROW(skin_of(many_balls(static_cast<int>(most_skin_balls) + 1, 4, 1)), Unavailable);
}

}  // namespace
}  // namespace mesecina::test
