// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <numeric>
#include <random>

#include "core/formats/polygon_triangles.h"

namespace mesecina {
namespace {

using testing::ElementsAre;
using Triangle = std::array<int, 3>;

Triangle_mesh_3 mesh_of(std::vector<Point_3> vertices) {
  std::vector<int> polygon(vertices.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  Triangle_mesh_3 mesh{std::move(vertices), {}};
  EXPECT_TRUE(append_triangles(mesh, polygon));
  return mesh;
}

Point_3 area(const Point_3& a, const Point_3& b, const Point_3& c) { return 0.5 * cross(b - a, c - a); }

/// No triangle is turned over, and together they have the polygon's area: so none overlap.
void expect_partition(const Triangle_mesh_3& mesh) {
  const std::vector<Point_3>& p = mesh.vertices;
  ASSERT_EQ(mesh.triangles.size(), p.size() - 2);
  Point_3 of_polygon;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) of_polygon = of_polygon + area(p[0], p[i], p[i + 1]);
  const double size = std::sqrt(dot(of_polygon, of_polygon));
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double part = dot(area(p[a], p[b], p[c]), of_polygon) / size;
    EXPECT_GE(part, -1e-12 * size);
    sum += part;
  }
  EXPECT_NEAR(sum, size, 1e-9 * size);
}

TEST(Polygon_triangles, ConvexPolygonsAreFansOfTheirFirstCorner) {
  EXPECT_THAT(mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).triangles,
              ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  // In all coordinate planes and both orientations, with a straight corner.
  for (const auto& [u, v] :
       {std::pair(Point_3{1, 0, 0}, Point_3{0, 1, 0}), std::pair(Point_3{0, 1, 0}, Point_3{0, 0, 1}),
        std::pair(Point_3{0, 0, 1}, Point_3{1, 0, 0})}) {
    for (const auto& [first, second] : {std::pair(u, v), std::pair(v, u)}) {
      const auto mesh = mesh_of({first, first + second, second, 0.5 * second, {0, 0, 0}});
      EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 4}));
    }
  }
}

TEST(Polygon_triangles, NonconvexPolygonsAreCovered) {
  // An arrow head, from each of its corners: a fan of two of them would be wrong.
  const std::vector<Point_3> arrow = {{0, 0, 0}, {2, 1, 2}, {0, 2, 0}, {1, 1, 1}};
  for (int turn = 0; turn < 4; ++turn) {
    std::vector<Point_3> turned = arrow;
    std::ranges::rotate(turned, turned.begin() + turn);
    expect_partition(mesh_of(turned));
    std::ranges::reverse(turned);
    expect_partition(mesh_of(turned));
  }
  // Turns left everywhere but the notch; a comb; a spiral.
  expect_partition(mesh_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}, {2, 4, 0}, {1, 1, 0}, {0, 4, 0}}));
  std::vector<Point_3> spiral;
  for (int i = 0; i <= 60; ++i)
    spiral.push_back({(1 + i / 20.) * std::cos(i * 0.3), (1 + i / 20.) * std::sin(i * 0.3), 0});
  for (int i = 60; i >= 0; --i) {
    const double radius = 1.3 + i / 20.;
    spiral.push_back({radius * std::cos(i * 0.3), radius * std::sin(i * 0.3), 0});
  }
  expect_partition(mesh_of(spiral));
}

TEST(Polygon_triangles, PolygonsMayTouchThemselves) {
  // A square with a slit from a corner, which turns right nowhere; and a square around a hole, with a bridge.
  for (std::vector<Point_3> points :
       {std::vector<Point_3>{{0, 0, 1}, {1, 1, 1}, {0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {0, 4, 1}},
        std::vector<Point_3>{{0, 0, 1},
                             {4, 0, 1},
                             {4, 4, 1},
                             {0, 4, 1},
                             {0, 0, 1},
                             {1, 1, 1},
                             {1, 2, 1},
                             {2, 2, 1},
                             {2, 1, 1},
                             {1, 1, 1}}}) {
    for (std::size_t turn = 0; turn < points.size(); ++turn) {
      expect_partition(mesh_of(points));
      std::ranges::rotate(points, points.begin() + 1);
    }
  }
}

TEST(Polygon_triangles, RandomStarsInRandomPlanes) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 200; ++round) {
    const Point_3 u{uniform(random), uniform(random), uniform(random)};
    const Point_3 v{uniform(random), uniform(random), uniform(random)};
    std::vector<Point_3> star;
    const int count = 4 + round % 30;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * std::numbers::pi * i / count;
      const double radius = 1.1 + uniform(random);
      star.push_back(radius * std::cos(angle) * u + radius * std::sin(angle) * v);
    }
    expect_partition(mesh_of(star));
  }
}

TEST(Polygon_triangles, DegeneratePolygonsGiveTrianglesAllTheSame) {
  for (const std::vector<Point_3>& points : {
           std::vector<Point_3>(5, Point_3{1, 1, 1}),
           std::vector<Point_3>{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 1, 1}},
           std::vector<Point_3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
           std::vector<Point_3>{{0, 0, 0}, {1e308, 0, 0}, {1e308, 1e308, 0}, {0, -1e308, 1e308}, {1, 1, 1}},
       })
    EXPECT_EQ(mesh_of(points).triangles.size(), points.size() - 2);
  // A pentagram turns left everywhere, but twice around.
  std::vector<Point_3> pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.push_back({std::cos(i * 0.8 * std::numbers::pi), std::sin(i * 0.8 * std::numbers::pi), 0});
  EXPECT_EQ(mesh_of(pentagram).triangles.size(), 3u);
}

TEST(Polygon_triangles, LargeOnesAreRefusedUnlessConvex) {
  std::vector<Point_3> circle;
  for (int i = 0; i < 100'000; ++i) circle.push_back({std::cos(i * 6e-5), std::sin(i * 6e-5), 0});
  EXPECT_EQ(mesh_of(circle).triangles.size(), 99'998u);
  circle[500] = {0.5, 0.01, 0};
  std::vector<int> polygon(circle.size());
  std::iota(polygon.begin(), polygon.end(), 0);
  Triangle_mesh_3 mesh{circle, {}};
  EXPECT_FALSE(append_triangles(mesh, polygon));
  EXPECT_TRUE(mesh.triangles.empty());
}

TEST(Polygon_triangles, TheLargestNonconvexPolygonTakesNotLong) {
  std::vector<Point_3> comb;
  for (std::size_t i = 0; i + 2 < most_corners_of_nonconvex_polygons; ++i)
    comb.push_back({static_cast<double>(i), i % 2 == 0 ? 0 : 1000.0, 0});
  comb.push_back({1e4, 2e3, 0});
  comb.push_back({0, 2e3, 0});
  const auto begin = std::clock();
  expect_partition(mesh_of(comb));
  // And one that crosses itself everywhere.
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (Point_3& p : comb) p = {uniform(random), uniform(random), 0};
  EXPECT_EQ(mesh_of(comb).triangles.size(), comb.size() - 2);
  EXPECT_LT(std::clock() - begin, 20 * CLOCKS_PER_SEC) << "an optimized build takes about 0.5 s";
}

}  // namespace
}  // namespace mesecina
