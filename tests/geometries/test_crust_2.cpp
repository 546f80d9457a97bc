// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometries/crust_2/one_step_crust.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

struct Result {
  Delaunay_2 triangulation;
  Crust_2 crust;
};

Result reconstruct(std::span<const Point_2> points, int threads = 1) {
  Progress progress({}, {}, threads);
  Delaunay_2 d = delaunay(points, progress);
  Crust_2 crust = one_step_crust(d, progress);
  return {std::move(d), std::move(crust)};
}

Point_2 power_of_two_multiple(const Point_2& p, int exponent) {
  return {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
}

/// Compares at several scales, with both ends and both corners exchanged.
void expect_exact(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& s) {
  if (orientation(p, q, r) == 0 || orientation(p, q, s) == 0) return;
  if (orientation(p, q, r) == orientation(p, q, s)) return;
  // Not both angles obtuse: pq would be no Delaunay edge.
  if (!exact_is_crust_hull_edge(p, q, r) && !exact_is_crust_hull_edge(p, q, s)) return;
  const bool expected = exact_is_crust_edge(p, q, r, s);
  const bool expected_on_hull = exact_is_crust_hull_edge(p, q, r);
  for (const int exponent : {0, 37, -100, 100, -250, 250, -400, 400}) {
    const Point_2 a = power_of_two_multiple(p, exponent);
    const Point_2 b = power_of_two_multiple(q, exponent);
    const Point_2 c = power_of_two_multiple(r, exponent);
    const Point_2 d = power_of_two_multiple(s, exponent);
    ASSERT_EQ(is_crust_edge(a, b, c, d), expected)
        << p.x << " " << p.y << ", " << q.x << " " << q.y << ", " << r.x << " " << r.y << ", " << s.x << " " << s.y
        << " times 2^" << exponent;
    ASSERT_EQ(is_crust_edge(b, a, c, d), expected) << exponent;
    ASSERT_EQ(is_crust_edge(a, b, d, c), expected) << exponent;
    ASSERT_EQ(is_crust_hull_edge(a, b, c), expected_on_hull) << exponent;
    ASSERT_EQ(is_crust_hull_edge(b, a, c), expected_on_hull) << exponent;
  }
}

TEST(Is_crust_edge, known_configurations) {
  const Point_2 p{0, 0};
  const Point_2 q{2, 0};
  // cot 45 = 1 on both sides: a product of exactly 1 belongs to the crust.
  EXPECT_TRUE(is_crust_edge(p, q, {0, 2}, {2, -2}));
  // cot = 1/2 and 2, by the distance from the middle: tan(half angle) = 1 / h.
  EXPECT_TRUE(is_crust_edge(p, q, {0, 4}, {0, -1}));
  EXPECT_FALSE(is_crust_edge(p, q, {0, std::nextafter(4.0, 0.0)}, {0, -1}));
  EXPECT_TRUE(is_crust_edge(p, q, {0, std::nextafter(4.0, 5.0)}, {0, -1}));
  // Right angles: cot = 0.
  EXPECT_FALSE(is_crust_edge(p, q, {1, 1}, {1, -1}));
  EXPECT_FALSE(is_crust_edge(p, q, {1, 1}, {1, -100}));
  EXPECT_FALSE(is_crust_hull_edge(p, q, {1, 1}));
  EXPECT_TRUE(is_crust_hull_edge(p, q, {1, std::nextafter(1.0, 2.0)}));
  EXPECT_FALSE(is_crust_hull_edge(p, q, {1, std::nextafter(1.0, 0.0)}));
}

TEST(Is_crust_edge, is_exact_on_random_points) {
  Random random(1);
  for (int i = 0; i < 1500; ++i) {
    const auto point = [&](double low, double high) {
      const double x = random.uniform(-1, 1);
      return Point_2{x, random.uniform(low, high)};
    };
    expect_exact(point(-0.3, 0.3), point(-0.3, 0.3), point(0, 2), point(-2, 0));
  }
}

TEST(Is_crust_edge, is_exact_on_small_integers) {
  Random random(2);
  for (int i = 0; i < 4000; ++i) {
    const auto point = [&] {
      const double x = random.index(6);
      return Point_2{x, static_cast<double>(random.index(6))};
    };
    expect_exact(point(), point(), point(), point());
  }
}

TEST(Is_crust_edge, is_exact_next_to_equality) {
  // Right-angled corners over a segment of width w, at heights h and -k: the product is h k / w^2.
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double h = 1 + random.index(50);
    const double k = 1 + random.index(50);
    const Point_2 offset{static_cast<double>(random.index(1000)), static_cast<double>(random.index(1000))};
    double width = std::sqrt(h * k);
    for (int step = random.index(3); step > 0; --step) width = std::nextafter(width, random.chance(0.5) ? 0.0 : 1e9);
    const Point_2 p{offset.x, offset.y};
    const Point_2 q{offset.x + width, offset.y};
    expect_exact(p, q, {offset.x, offset.y + h}, {offset.x, offset.y - k});
    // The same rotated by 90 degrees and by an integer similarity.
    expect_exact({-p.y, p.x}, {-q.y, q.x}, {-offset.y - h, offset.x}, {-offset.y + k, offset.x});
  }
}

TEST(Is_crust_edge, is_exact_far_from_the_origin) {
  Random random(4);
  for (int i = 0; i < 500; ++i) {
    const auto point = [&](double low, double high) {
      const double x = 1e8 + random.uniform(0, 1e-6);
      return Point_2{x, 1e8 + random.uniform(low, high)};
    };
    expect_exact(point(-3e-7, 3e-7), point(-3e-7, 3e-7), point(0, 1e-6), point(-1e-6, 0));
  }
}

void expect_crust_by_definition(const Result& result) {
  const auto& [d, crust] = result;
  EXPECT_EQ(sorted_edges(crust.edges), crust_by_definition(d));
  ASSERT_EQ(crust.edges_of_triangle.size(), d.triangles.size());
  std::vector<Edge> marked;
  for (int t = 0; t < static_cast<int>(d.triangles.size()); ++t) {
    EXPECT_LT(crust.edges_of_triangle[t], 8);
    for (int i = 0; i < 3; ++i) {
      const int n = d.neighbors[t][i];
      if (n != -1) {
        EXPECT_EQ(crust.contains(t, i), crust.contains(n, d.mirror_corner(t, i)));
      }
      if (crust.contains(t, i) && d.edge_is_listed(t, i)) marked.push_back(sorted_edge(d.edge(t, i)));
    }
  }
  if (d.dimension == 2) {
    std::ranges::sort(marked);
    EXPECT_EQ(marked, sorted_edges(crust.edges));
  }
}

TEST(One_step_crust, equals_the_definition) {
  for (const auto& sets : {difficult_point_sets(), general_point_sets()}) {
    for (const auto& [name, points] : sets) {
      SCOPED_TRACE(name);
      expect_crust_by_definition(reconstruct(points));
    }
  }
}

TEST(One_step_crust, equals_the_definition_on_real_shapes) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("xy")) {
    SCOPED_TRACE(file.filename());
    expect_crust_by_definition(reconstruct(points_of(file)));
  }
  for (const auto& file : planar_files("wkt")) {
    SCOPED_TRACE(file.filename());
    const std::vector<Point_2> points = vertices_of(outline_of(file));
    if (points.size() < 2500) expect_crust_by_definition(reconstruct(points));
  }
}

TEST(One_step_crust, of_a_dense_sample_is_the_polygon) {
  for (const Smooth_shape& shape : smooth_shapes()) {
    SCOPED_TRACE(shape.name);
    const std::vector<Point_2> points = shape.samples();
    EXPECT_EQ(sorted_edges(reconstruct(points).crust.edges), shape.polygon_edges());
  }
}

TEST(One_step_crust, of_a_line_joins_neighbours) {
  const std::vector<Point_2> points{{4, 4}, {0, 0}, {1, 1}, {4, 4}, {-3, -3}};
  EXPECT_EQ(sorted_edges(reconstruct(points).crust.edges), (std::vector<Edge>{{0, 2}, {1, 2}, {1, 4}}));
  EXPECT_TRUE(reconstruct(std::vector<Point_2>{}).crust.edges.empty());
  EXPECT_TRUE(reconstruct(std::vector<Point_2>{{1, 1}, {1, 1}}).crust.edges.empty());
}

TEST(One_step_crust, does_not_depend_on_threads) {
  const std::vector<Point_2> points = noisy_curve(30000, 0.001, 5);
  const Result one = reconstruct(points, 1);
  const Result two = reconstruct(points, 2);
  EXPECT_EQ(one.crust.edges, two.crust.edges);
  EXPECT_EQ(one.crust.edges_of_triangle, two.crust.edges_of_triangle);
}

}  // namespace
}  // namespace mesecina::test
