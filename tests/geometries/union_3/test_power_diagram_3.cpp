// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/power_diagram_3.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/graph.h"
#include "geometries/modules_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

using Balls = std::vector<Ball_3>;
using Polygon = std::vector<Point_3>;

double power(const Ball_3& ball, const Point_3& p) {
  return squared_distance(ball.center, p) - ball.radius * ball.radius;
}

/// The part of a convex polygon where one ball is no farther in power than another one.
Polygon clipped(const Polygon& polygon, const Ball_3& one, const Ball_3& other) {
  Polygon result;
  const auto excess = [&](const Point_3& p) { return power(one, p) - power(other, p); };  // linear
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point_3& p = polygon[i];
    const Point_3& q = polygon[(i + 1) % polygon.size()];
    const double a = excess(p);
    const double b = excess(q);
    if (a <= 0) result.push_back(p);
    if ((a < 0 && b > 0) || (a > 0 && b < 0)) result.push_back(p + (a / (a - b)) * (q - p));
  }
  return result;
}

double area(const Polygon& polygon) {
  Point_3 doubled;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    doubled = doubled + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return std::sqrt(dot(doubled, doubled)) / 2;
}

constexpr double far = 1e4;

/// The face of two balls, by cutting a large square in their radical plane by all others.
Polygon face_by_definition(const Balls& balls, int a, int b) {
  const Point_3 along = balls[b].center - balls[a].center;
  const double square = dot(along, along);
  if (square == 0) return {};
  const double place = (square + balls[a].radius * balls[a].radius - balls[b].radius * balls[b].radius) / (2 * square);
  const Point_3 foot = balls[a].center + place * along;
  const Point_3 any = std::abs(along.x) < std::abs(along.y) ? Point_3{1, 0, 0} : Point_3{0, 1, 0};
  Point_3 u = cross(along, any);
  u = (1 / std::sqrt(dot(u, u))) * u;
  Point_3 v = cross(along, u);
  v = (1 / std::sqrt(dot(v, v))) * v;
  Polygon polygon;
  for (const auto& [x, y] : {std::pair{-far, -far}, {far, -far}, {far, far}, {-far, far}})
    polygon.push_back(foot + x * u + y * v);
  for (int c = 0; c < static_cast<int>(balls.size()) && !polygon.empty(); ++c)
    if (c != a && c != b) polygon = clipped(polygon, balls[a], balls[c]);
  return polygon;
}

bool is_bounded(const Polygon& polygon) {
  return std::ranges::all_of(polygon, [](const Point_3& p) { return std::sqrt(dot(p, p)) < far / 2; });
}

Polygon polygon_of(const Power_faces_3& faces, std::size_t f) {
  Polygon polygon;
  for (const int corner : faces.face(f)) polygon.push_back(faces.vertices[corner]);
  return polygon;
}

/// Returns how many faces there are.
int expect_by_definition(const Balls& balls) {
  Progress progress;
  const Power_faces_3 faces = bounded_power_faces(regular_triangulation(balls, progress), progress);
  std::map<std::array<int, 2>, Polygon> found;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto [a, b] = std::minmax(faces.balls[f][0], faces.balls[f][1]);
    const Polygon polygon = polygon_of(faces, f);
    EXPECT_TRUE(found.insert({{a, b}, polygon}).second) << "twice";
    Point_3 normal;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      normal = normal + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    EXPECT_GT(dot(normal, balls[faces.balls[f][1]].center - balls[faces.balls[f][0]].center), 0);
    std::set<int> different(faces.face(f).begin(), faces.face(f).end());
    EXPECT_EQ(different.size(), faces.face(f).size());
    for (const Point_3& p : polygon) {
      double least = std::numeric_limits<double>::infinity();
      for (const Ball_3& ball : balls) least = std::min(least, power(ball, p));
      for (const int ball : faces.balls[f]) EXPECT_NEAR(power(balls[ball], p), least, 1e-6 * (1 + dot(p, p)));
    }
  }
  for (int a = 0; a < static_cast<int>(balls.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(balls.size()); ++b) {
      const Polygon expected = face_by_definition(balls, a, b);
      if (!is_bounded(expected)) {
        EXPECT_FALSE(found.contains({a, b}));
        continue;
      }
      const double size = found.contains({a, b}) ? area(found[{a, b}]) : 0;
      EXPECT_NEAR(size, area(expected), 1e-6 * (1 + size)) << a << " " << b;
    }
  }
  return static_cast<int>(found.size());
}

TEST(Power_diagram_3, FacesAreThoseOfTheDefinition) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) EXPECT_GT(expect_by_definition(many_balls(40, 6, seed)), 40);
}

TEST(Power_diagram_3, FacesWithoutAreaAreNoneWhereBallsAreOnALattice) {
  Balls balls;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 4; ++z)
        balls.push_back({{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)}, 0.75});
  // Squares between neighbours, of which at most one coordinate is on the boundary.
  EXPECT_EQ(expect_by_definition(balls), 3 * 3 * 2 * 2);
  balls[21].radius = 1;
  EXPECT_GT(expect_by_definition(balls), 36);
}

TEST(Power_diagram_3, EqualBallsAndBallsInAPlaneHaveNoBoundedFaces) {
  Progress progress;
  const Balls flat{{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, 1, 0}, 1}, {{1, 1, 0}, 1}, {{0.5, 0.5, 0}, 1}};
  for (const Balls& balls :
       {flat, Balls{{{0, 0, 0}, 1}}, Balls(3, {{1, 2, 3}, 1}), Balls{{{0, 0, 0}, 1}, {{9, 0, 0}, 2}}})
    EXPECT_EQ(bounded_power_faces(regular_triangulation(balls, progress), progress).size(), 0u);
}

TEST(Power_diagram_3, EdgesAreThoseOfTheCells) {
  Progress progress;
  const Regular_3 regular = regular_triangulation(many_balls(30, 6, 2), progress);
  const auto edges = edges_of(regular);
  std::set<std::array<int, 2>> expected;
  for (const auto& corners : regular.cells)
    for (const int a : corners)
      for (const int b : corners)
        if (a >= 0 && a < b) expected.insert({a, b});
  EXPECT_EQ(edges, std::vector(expected.begin(), expected.end()));
}

/// The least power to a ball on a convex polygon.
double least_power(const Ball_3& ball, const Polygon& polygon) {
  double least = std::numeric_limits<double>::infinity();
  constexpr int steps = 60;
  Point_3 middle;
  for (const Point_3& p : polygon) middle = middle + (1.0 / static_cast<double>(polygon.size())) * p;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (int k = 0; k <= steps; ++k) {
      const Point_3 rim =
          polygon[i] + (static_cast<double>(k) / steps) * (polygon[(i + 1) % polygon.size()] - polygon[i]);
      for (int out = 0; out <= steps; ++out)
        least = std::min(least, power(ball, middle + (static_cast<double>(out) / steps) * (rim - middle)));
    }
  }
  return least;
}

TEST(Power_diagram_3, TheLayerSaysWhichFacesMeetTheUnion) {
  const Balls balls = many_balls(60, 3, 7);
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(balls_input, balls));
  Progress progress;
  const auto layer = graph.layer("power-diagram", progress);
  ASSERT_TRUE(layer) << layer.reason;
  const Power_faces_3 faces = bounded_power_faces(regular_triangulation(balls, progress), progress);
  ASSERT_EQ(layer.value->polygon_count(), faces.size());
  const Values* meets = layer.value->find_values("meets-union");
  ASSERT_NE(meets, nullptr);
  int met = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const double least = least_power(balls[faces.balls[f][0]], polygon_of(faces, f));
    constexpr double unclear = 1e-3;
    if (std::abs(least) < unclear) continue;
    EXPECT_EQ(meets->data[f] == 1, least < 0) << least;
    met += least < 0 ? 1 : 0;
  }
  EXPECT_GT(met, 5);
  EXPECT_LT(met + 20, static_cast<int>(faces.size()));
  graph.set_inputs(Inputs().with(balls_input, Balls{{{0, 0, 0}, 1}}));
  EXPECT_THAT(graph.layer("power-diagram", progress).reason, testing::HasSubstr("unbounded"));
}

}  // namespace
}  // namespace mesecina::test
