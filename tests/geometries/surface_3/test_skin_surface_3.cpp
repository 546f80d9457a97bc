// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/skin_surface_3.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stop_token>
#include <string_view>

#include "core/outcome.h"
#include "geometries/union_3/union_3.h"
#include "tests/geometries/surface_3/surface_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"
#include "tests/growth.h"

namespace mesecina::test {
namespace {

constexpr double tolerance = 0.02;

Triangle_mesh_3 skin_of(const std::vector<Ball_3>& balls, double shrink_factor = 0.5, double within = tolerance) {
  Progress progress;
  return skin_surface(balls, shrink_factor, within, progress);
}

/// From the definition: the skin surface is the boundary of the union of the shrunk balls of all convex combinations of
/// the balls, grown before. Returns the largest difference, over all of these, of the squared radius and the squared
/// distance from the point: positive inside, zero on the surface. A largest one is a combination of at most four balls,
/// with centers not in a plane (line, point) that fewer span.
double skin_function(const std::vector<Ball_3>& balls, double shrink_factor, const Point_3& at) {
  const double s = shrink_factor;
  const Eigen::Vector3d x(at.x, at.y, at.z);
  const int count = static_cast<int>(balls.size());
  double largest = -std::numeric_limits<double>::infinity();
  const auto look = [&](const std::vector<int>& chosen) {
    // Combinations are p0 + A l, with l >= 0 and sum <= 1; of weights w, that of a combination is
    // |y|^2 - sum of l_i (|p_i|^2 - w_i).
    const auto p = [&](int i) {
      const Point_3& c = balls[chosen[i]].center;
      return Eigen::Vector3d(c.x, c.y, c.z);
    };
    const auto w = [&](int i) { return balls[chosen[i]].radius * balls[chosen[i]].radius / s; };
    const int free = static_cast<int>(chosen.size()) - 1;
    const Eigen::Vector3d origin = p(0);
    Eigen::MatrixXd away(3, free);
    Eigen::VectorXd heights(free);  // of |p_i - p0|^2 - w_i, less that of p0
    for (int i = 0; i < free; ++i) {
      away.col(i) = p(i + 1) - origin;
      heights(i) = away.col(i).squaredNorm() - w(i + 1) + w(0);
    }
    // Of s (|A l|^2 + w0 - heights l) - |x - p0 - A l|^2 the gradient vanishes.
    Eigen::VectorXd parts(free);
    if (free > 0) {
      const Eigen::MatrixXd gram = away.transpose() * away;
      const Eigen::FullPivLU<Eigen::MatrixXd> solver(gram);
      if (solver.rank() < free) return;
      parts = solver.solve(away.transpose() * (x - origin) - s / 2 * heights) / (1 - s);
      if (parts.minCoeff() < 0 || parts.sum() > 1) return;
    }
    const Eigen::Vector3d offset = away * parts;
    const double weight = offset.squaredNorm() + w(0) - heights.dot(parts);
    largest = std::max(largest, s * weight - (x - origin - offset).squaredNorm());
  };
  for (int a = 0; a < count; ++a) {
    look({a});
    for (int b = a + 1; b < count; ++b) {
      look({a, b});
      for (int c = b + 1; c < count; ++c) {
        look({a, b, c});
        for (int d = c + 1; d < count; ++d) look({a, b, c, d});
      }
    }
  }
  return largest;
}

/// The homotopy type of the skin's inside is that of the union of the balls before they are shrunk.
std::array<std::int64_t, 3> betti_of_skin(std::vector<Ball_3> balls, double shrink_factor) {
  for (Ball_3& ball : balls) ball.radius /= std::sqrt(shrink_factor);
  Progress progress;
  auto regular = std::make_shared<const Regular_3>(regular_triangulation(balls, progress));
  const auto solid = topology(dual_complex(std::move(regular), progress)).betti;
  return {solid[0] + solid[2], 2 * solid[1], solid[0] + solid[2]};
}

/// Points take no part.
std::vector<Ball_3> with_radius(std::vector<Ball_3> balls) {
  std::erase_if(balls, [](const Ball_3& ball) { return ball.radius <= 0; });
  return balls;
}

double size_of(const std::vector<Ball_3>& balls) {
  double size = 0;
  for (const Ball_3& ball : balls) size = std::max(size, ball.radius);
  return size;
}

testing::AssertionResult is_skin(const std::vector<Ball_3>& balls, double shrink_factor, const Triangle_mesh_3& skin) {
  if (skin.triangles.empty()) return testing::AssertionFailure() << "no triangles";
  if (const auto result = is_closed_manifold(skin); !result) return result;
  // The value changes by twice the distance times the size, about.
  const double size = size_of(balls);
  const std::size_t step = std::max<std::size_t>(1, skin.vertices.size() / 60);
  for (std::size_t v = 0; v < skin.vertices.size(); v += step) {
    const double value = skin_function(balls, shrink_factor, skin.vertices[v]);
    if (!(std::abs(value) <= 1e-7 * size * size))
      return testing::AssertionFailure() << "vertex " << v << ": " << value << " instead of 0";
  }
  Triangle_mesh_3 near = skin;
  for (Point_3& p : near.vertices) p = p - skin.vertices.front();
  if (signed_volume(near) <= 0) return testing::AssertionFailure() << "volume " << signed_volume(near);
  return testing::AssertionSuccess();
}

TEST(Skin_surface_3, OfOneBallIsItsSphere) {
  const Ball_3 ball{{3, -1, 2}, 2};
  const Triangle_mesh_3 skin = skin_of({ball});
  ASSERT_TRUE(is_closed_manifold(skin));
  EXPECT_EQ(topology(skin).betti, (std::array<std::int64_t, 3>{1, 0, 1}));
  EXPECT_GT(signed_volume(skin), 0);
  for (const Point_3& p : skin.vertices) EXPECT_NEAR(distance(p, ball.center), ball.radius, 1e-12);
  for (const Point_3& p : mesh_points(skin)) EXPECT_NEAR(distance(p, ball.center), ball.radius, 2 * tolerance);
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
    ASSERT_TRUE(is_skin(ring, shrink_factor, skin)) << shrink_factor;
    EXPECT_EQ(topology(skin).betti, (std::array<std::int64_t, 3>{1, 2, 1})) << shrink_factor;
    double farthest = 0;
    for (const Point_3& p : skin.vertices) {
      const double d = distance_to_union(ring, p);
      EXPECT_GT(d, -1e-12) << shrink_factor;
      farthest = std::max(farthest, d);
    }
    EXPECT_GT(farthest, 0.01) << shrink_factor;
    EXPECT_LT(farthest, previous) << shrink_factor;
    previous = farthest;
  }
}

TEST(Skin_surface_3, LiesWhereTheDefinitionSays) {
  for (const double shrink_factor : {0.1, 0.5, 0.9}) {
    expect_of_balls(6, [&](const std::vector<Ball_3>& all) -> testing::AssertionResult {
      const std::vector<Ball_3> balls = with_radius(all);
      if (balls.empty()) return testing::AssertionSuccess();
      return is_skin(balls, shrink_factor, skin_of(balls, shrink_factor, tolerance * size_of(balls)));
    });
  }
}

/// Gradient of the skin function: inward.
Point_3 slope_at(const std::vector<Ball_3>& balls, double shrink_factor, const Point_3& at) {
  const double step = 1e-5 * size_of(balls);
  const auto value = [&](const Point_3& p) { return skin_function(balls, shrink_factor, p); };
  const auto slope = [&](const Point_3& way) { return (value(at + way) - value(at - way)) / (2 * step); };
  return {slope({step, 0, 0}), slope({0, step, 0}), slope({0, 0, step})};
}

double distance_to_skin(const std::vector<Ball_3>& balls, double shrink_factor, const Point_3& at) {
  const Point_3 slope = slope_at(balls, shrink_factor, at);
  return std::abs(skin_function(balls, shrink_factor, at)) / std::sqrt(dot(slope, slope));
}

TEST(Skin_surface_3, HasTrianglesNearTheSurface) {
  // Also such with much between them and the nearest other balls, or nothing on one side.
  const std::vector<std::vector<Ball_3>> sets{
      {{{0, 0, 0}, 1}, {{1.5, 0, 0}, 0.8}},
      {{{0, 0, 0}, 1}, {{1.2, 0.3, 0}, 0.8}, {{0.2, 1.1, 0.1}, 0.7}, {{0.3, 0.2, 1.2}, 0.9}, {{9, 9, 9}, 0.5}},
      many_balls(12, 3, 4)};
  for (const auto& balls : sets) {
    for (const double shrink_factor : {0.2, 0.5, 0.9}) {
      for (const double within : {0.1, 0.01}) {
        const double size = size_of(balls);
        const Triangle_mesh_3 skin = skin_of(balls, shrink_factor, within * size);
        const std::vector<Point_3> points = mesh_points(skin);
        std::size_t far = 0;
        std::size_t looked = 0;
        for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 150, ++looked)
          if (!(distance_to_skin(balls, shrink_factor, points[i]) <= 1.5 * within * size)) ++far;
        EXPECT_EQ(far, 0) << shrink_factor << " " << within << ": " << far << " of " << looked;
      }
    }
  }
}

TEST(Skin_surface_3, HasTheTopologyOfTheGrownUnion) {
  for (const double shrink_factor : {0.3, 0.8}) {
    expect_of_clear_balls(20, [&](const std::vector<Ball_3>& all) -> testing::AssertionResult {
      const std::vector<Ball_3> balls = with_radius(all);
      if (balls.empty()) return testing::AssertionSuccess();
      const auto expected = betti_of_skin(balls, shrink_factor);
      const auto found = topology(skin_of(balls, shrink_factor, tolerance * size_of(balls))).betti;
      if (found == expected) return testing::AssertionSuccess();
      return testing::AssertionFailure() << shrink_factor << ": " << testing::PrintToString(found) << " instead of "
                                         << testing::PrintToString(expected);
    });
  }
}

TEST(Skin_surface_3, OfManyBallsIsClosedAndHasTheTopologyOfTheGrownUnion) {
  for (const double neighbors : {3, 10}) {
    const std::vector<Ball_3> balls = many_balls(800, neighbors, 7);
    const Triangle_mesh_3 skin = skin_of(balls, 0.6, tolerance * size_of(balls));
    EXPECT_TRUE(is_closed_manifold(skin));
    EXPECT_EQ(topology(skin).betti, betti_of_skin(balls, 0.6));
  }
}

TEST(Skin_surface_3, IsTheSameOfBallsOfEachSize) {
  const std::vector<Ball_3> balls = many_balls(20, 6, 3);
  const Triangle_mesh_3 skin = skin_of(balls);
  for (const double size : {0x1p-900, 0x1p-40, 0x1p40, 0x1p900}) {
    std::vector<Ball_3> scaled;
    for (const auto& [center, radius] : balls) scaled.push_back({size * center, size * radius});
    const Triangle_mesh_3 other = skin_of(scaled, 0.5, size * tolerance);
    ASSERT_EQ(other.triangles, skin.triangles) << size;
    for (std::size_t v = 0; v < skin.vertices.size(); ++v)
      ASSERT_LE(distance(other.vertices[v], size * skin.vertices[v]), size * 1e-12) << size;
  }
}

TEST(Skin_surface_3, IsTheSameForEachNumberOfThreads) {
  const std::vector<Ball_3> balls = many_balls(500, 6, 5);
  Progress one({}, {}, 1);
  Progress two({}, {}, 2);
  const Triangle_mesh_3 first = skin_surface(balls, 0.5, tolerance, one);
  const Triangle_mesh_3 second = skin_surface(balls, 0.5, tolerance, two);
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.vertices, second.vertices);
}

TEST(Skin_surface_3, IsClosedOfBallsFarAwayAndOfAllSizes) {
  for (const Ball_3& ball : {Ball_3{{0, 0, 0}, 1e200}, Ball_3{{0, 0, 0}, 1e-200}, Ball_3{{1e9, 1e9, 1e9}, 1e-12}}) {
    const Triangle_mesh_3 skin = skin_of({ball}, 0.5, tolerance * ball.radius);
    EXPECT_TRUE(is_closed_manifold(skin)) << ball.radius;
    EXPECT_GT(skin.triangles.size(), 100) << ball.radius;
  }
  EXPECT_TRUE(is_closed_manifold(skin_of({{{0, 0, 0}, 1}, {{5, 0, 0}, 1e-200}})));
  EXPECT_TRUE(is_closed_manifold(skin_of({{{-1e300, 0, 0}, 1e300}, {{1e300, 0, 0}, 1e299}}, 0.5, 1e297)));
}

TEST(Skin_surface_3, IsAsNearAsItIsToldAtTheLimitsOfItsSettings) {
  const std::vector<Ball_3> balls{{{0, 0, 0}, 1}, {{0.95, 0, 0}, 0.1}};
  for (const double shrink_factor : {0.05, 0.95}) {
    constexpr double within = 2e-5;
    const Triangle_mesh_3 skin = skin_of(balls, shrink_factor, within);
    ASSERT_TRUE(is_skin(balls, shrink_factor, skin)) << shrink_factor;
    const std::vector<Point_3> points = mesh_points(skin);
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 500)
      ASSERT_LE(distance_to_skin(balls, shrink_factor, points[i]), 1.5 * within) << shrink_factor;
  }
}

TEST(Skin_surface_3, StopsWhenItIsCancelled) {
  const std::vector<Ball_3> balls = many_balls(2000, 6, 5);
  for (const std::string_view wanted : {"regular triangulation", "mixed complex", "skin surface"}) {
    std::stop_source stop;
    Progress progress(stop.get_token(), [&](std::string_view stage, double) {
      if (stage == wanted) stop.request_stop();
    });
    EXPECT_THROW(skin_surface(balls, 0.5, tolerance, progress), Cancelled) << wanted;
  }
}

TEST(Skin_surface_3, HasHardlyATriangleThatLiesBackwards) {
  for (const std::uint64_t seed : {4, 5}) {
    const std::vector<Ball_3> balls = many_balls(10, 3, seed);
    const double size = size_of(balls);
    for (const double shrink_factor : {0.2, 0.5, 0.95}) {
      const double within = 0.02 * size;
      const Triangle_mesh_3 skin = skin_of(balls, shrink_factor, within);
      std::size_t backwards = 0;
      std::size_t looked = 0;
      for (std::size_t t = 0; t < skin.triangles.size(); t += 1 + skin.triangles.size() / 250) {
        const auto corner = [&](int i) { return skin.vertices[skin.triangles[t][i % 3]]; };
        const Point_3 normal = cross(corner(1) - corner(0), corner(2) - corner(0));
        double longest = 0;
        for (int i = 0; i < 3; ++i) longest = std::max(longest, distance(corner(i), corner(i + 1)));
        // Needles have no direction.
        if (longest < within || std::sqrt(dot(normal, normal)) < 0.1 * within * longest) continue;
        ++looked;
        if (dot(normal, slope_at(balls, shrink_factor, (1.0 / 3) * (corner(0) + corner(1) + corner(2)))) > 0)
          ++backwards;
      }
      EXPECT_LE(backwards, looked / 50) << shrink_factor << ": " << backwards << " of " << looked;
    }
  }
}

TEST(Skin_surface_3, RefusesWithAReason) {
  EXPECT_THROW(skin_of({}), Unavailable);
  EXPECT_THROW(skin_of({{{1, 2, 3}, 0}}), Unavailable);
}

TEST(Skin_surface_3, GrowsNearlyLinearly) {
  const auto run = [](int count) {
    const std::vector<Ball_3> balls = many_balls(count, 5, 1);
    return [balls] { skin_of(balls, 0.5, tolerance * size_of(balls)); };
  };
  constexpr double enough = 1.7 * 8;
  EXPECT_LT(growth(run(200), run(1600), enough), enough);
}

}  // namespace
}  // namespace mesecina::test
