// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "geometries/delaunay_2/delaunay_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/shapes.h"
#include "tests/growth.h"

namespace mesecina::test {
namespace {

Delaunay_2 triangulate(std::span<const Point_2> points, int threads = 1) {
  Progress progress({}, {}, threads);
  return delaunay(points, progress);
}

TEST(In_circle, filtered_predicate_equals_rational_arithmetic) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const int bound = i % 2 ? 4 : 1000;
    Point_2 p[4];
    for (Point_2& q : p) q = {static_cast<double>(random.index(bound)), static_cast<double>(random.index(bound))};
    if (i % 3 == 0)
      for (Point_2& q : p) q = {std::ldexp(q.x, -500), std::ldexp(q.y, -500)};
    EXPECT_EQ(in_circle(p[0], p[1], p[2], p[3]), in_circle_by_rationals(p[0], p[1], p[2], p[3]));
  }
}

TEST(Delaunay_2, is_right_on_difficult_inputs) {
  for (const auto& [name, points] : difficult_point_sets()) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(is_delaunay(triangulate(points), points));
  }
}

TEST(Delaunay_2, is_right_on_random_inputs) {
  for (const auto& [name, points] : general_point_sets()) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(is_delaunay(triangulate(points), points));
  }
  const std::vector<Point_2> many = uniform_points(20000, 41);
  EXPECT_TRUE(is_delaunay(triangulate(many), many));
}

TEST(Delaunay_2, is_right_on_every_small_integer_configuration) {
  Random random(2);
  for (int round = 0; round < 1500; ++round) {
    std::vector<Point_2> points(random.index(9));
    for (Point_2& p : points) p = {static_cast<double>(random.index(4)), static_cast<double>(random.index(3))};
    ASSERT_TRUE(is_delaunay(triangulate(points), points)) << "round " << round;
  }
}

TEST(Delaunay_2, is_right_on_smooth_shapes) {
  for (const Smooth_shape& shape : smooth_shapes()) {
    SCOPED_TRACE(shape.name);
    const std::vector<Point_2> points = shape.samples();
    EXPECT_TRUE(is_delaunay(triangulate(points), points));
  }
}

TEST(Delaunay_2, is_right_on_real_shapes) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("xy")) {
    SCOPED_TRACE(file.filename());
    const std::vector<Point_2> points = points_of(file);
    ASSERT_FALSE(points.empty());
    EXPECT_TRUE(is_delaunay(triangulate(points), points));
  }
  for (const auto& file : planar_files("wkt")) {
    SCOPED_TRACE(file.filename());
    const std::vector<Point_2> points = vertices_of(outline_of(file));
    ASSERT_FALSE(points.empty());
    EXPECT_TRUE(is_delaunay(triangulate(points), points));
  }
}

TEST(Delaunay_2, order_of_points_does_not_matter_in_general_position) {
  for (const auto& [name, points] : general_point_sets()) {
    SCOPED_TRACE(name);
    const std::vector<int> permutation = random_permutation(static_cast<int>(points.size()), 5);
    std::vector<Point_2> permuted;
    for (const int i : permutation) permuted.push_back(points[i]);
    std::vector<Triangle> mapped = triangulate(permuted).triangles;
    for (Triangle& t : mapped)
      for (int& corner : t) corner = permutation[corner];
    EXPECT_EQ(normalized(mapped), normalized(triangulate(points).triangles));
  }
}

TEST(Delaunay_2, same_points_give_the_same_bytes) {
  for (const auto& [name, points] : difficult_point_sets()) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(is_identical(triangulate(points), triangulate(points)));
    EXPECT_TRUE(is_identical(triangulate(points, 1), triangulate(points, 2)));
  }
  const std::vector<Point_2> many = with_duplicates(uniform_points(30000, 42), 500, 43);
  EXPECT_TRUE(is_identical(triangulate(many, 1), triangulate(many, 2)));
}

TEST(Delaunay_2, many_points_on_one_line_take_little_time) {
  const auto expect_line_and_fan = [](std::vector<Point_2> points) {
    const Delaunay_2 line = triangulate(points);
    EXPECT_EQ(line.dimension, 1);
    EXPECT_EQ(line.line.size(), points.size());
    // One point that is not on it, the last in every order.
    points.push_back({1e9, -1e9});
    const Delaunay_2 fan = triangulate(points);
    EXPECT_EQ(fan.dimension, 2);
    EXPECT_EQ(fan.triangles.size(), points.size() - 2);
  };
  const std::vector<Point_2> some = collinear_points(20000, 45);
  const std::vector<Point_2> many = collinear_points(200000, 45);
  EXPECT_LT(growth([&] { expect_line_and_fan(some); }, [&] { expect_line_and_fan(many); }, 15), 30);
}

TEST(Delaunay_2, can_be_cancelled) {
  std::stop_source source;
  source.request_stop();
  Progress progress(source.get_token());
  const std::vector<Point_2> points = uniform_points(1000, 44);
  EXPECT_THROW(delaunay(points, progress), Cancelled);
}

/// The bound of a straightforward evaluation in double: its error grows with the thinness of the triangle.
void expect_circumcenters_are_right(const std::vector<Point_2>& points) {
  const Delaunay_2 d = triangulate(points);
  Progress progress;
  const Voronoi_2 v = voronoi(d, progress);
  ASSERT_EQ(v.vertices.size(), d.triangles.size());
  ASSERT_EQ(v.radii.size(), d.triangles.size());
  constexpr double epsilon = 0x1p-52;
  for (std::size_t t = 0; t < d.triangles.size(); ++t) {
    const Point_2& p = d.points[d.triangles[t][0]];
    const Point_2& q = d.points[d.triangles[t][1]];
    const Point_2& r = d.points[d.triangles[t][2]];
    const Exact_point center = exact_circumcenter(p, q, r);
    const Exact_point from = exact(p);
    const Rational dx = center.x - from.x;
    const Rational dy = center.y - from.y;
    const double radius = std::hypot(CGAL::to_double(dx), CGAL::to_double(dy));
    double lengths[3] = {distance(p, q), distance(q, r), distance(r, p)};
    std::ranges::sort(lengths);
    // longest * second longest / (2 area) = 2 radius / shortest
    const double thinness = 2 * radius / lengths[0];
    const double cx = CGAL::to_double(center.x);
    const double cy = CGAL::to_double(center.y);
    const double bound =
        epsilon * (64 * thinness * radius + 4 * (std::abs(cx) + std::abs(cy)) + 4 * std::abs(p.x) + 4 * std::abs(p.y));
    if (!std::isfinite(bound) || !std::isfinite(radius)) continue;
    EXPECT_LE(std::hypot(v.vertices[t].x - cx, v.vertices[t].y - cy), bound) << "triangle " << t;
    EXPECT_LE(std::abs(v.radii[t] - radius), bound) << "triangle " << t;
  }
}

TEST(Voronoi_2, circumcenters_equal_exact_ones_up_to_rounding) {
  for (const auto& sets : {difficult_point_sets(), general_point_sets()}) {
    for (const auto& [name, points] : sets) {
      SCOPED_TRACE(name);
      expect_circumcenters_are_right(points);
    }
  }
}

TEST(Voronoi_2, circumcenters_of_real_shapes) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("xy")) {
    SCOPED_TRACE(file.filename());
    expect_circumcenters_are_right(points_of(file));
  }
}

}  // namespace
}  // namespace mesecina::test
