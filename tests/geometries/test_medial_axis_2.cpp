// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>

#include "geometries/medial_axis_2/medial_axis_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

struct Result {
  Delaunay_2 triangulation;
  Voronoi_2 voronoi;
  Crust_2 crust;
  Labels_2 labels;
  Medial_axis_2 axis;
};

Result compute(std::span<const Point_2> points) {
  Progress progress;
  Delaunay_2 d = delaunay(points, progress);
  Voronoi_2 v = voronoi(d, progress);
  Crust_2 crust = one_step_crust(d, progress);
  Labels_2 labels = flood_labels(d, crust, progress);
  Medial_axis_2 axis = medial_axis(d, v, labels, progress);
  return {std::move(d), std::move(v), std::move(crust), std::move(labels), std::move(axis)};
}

Result shape_of(const std::string& name) {
  for (const Smooth_shape& shape : smooth_shapes())
    if (shape.name == name) return compute(shape.samples());
  throw std::invalid_argument(name);
}

/// Largest of the angles, in degrees, under which two of the points are seen from `eye`.
double largest_angle(const Point_2& eye, std::span<const Point_2> points) {
  double result = 0;
  for (const Point_2& p : points) {
    for (const Point_2& q : points) {
      const Point_2 a{p.x - eye.x, p.y - eye.y};
      const Point_2 b{q.x - eye.x, q.y - eye.y};
      result = std::max(result, std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y)));
    }
  }
  return result * 180 / std::numbers::pi;
}

/// By trying all circles through two or three of them.
double smallest_enclosing_radius_of_three(const std::array<Point_2, 3>& p) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Point_2& a = p[i];
    const Point_2& b = p[(i + 1) % 3];
    const Point_2& c = p[(i + 2) % 3];
    const double radius = distance(a, b) / 2;
    // Inside the circle with diameter ab iff the angle at c is not acute.
    if (!exact_is_crust_hull_edge(a, b, c)) best = std::min(best, radius);
  }
  const Exact_point center = exact_circumcenter(p[0], p[1], p[2]);
  const Rational dx = center.x - exact(p[0]).x;
  const Rational dy = center.y - exact(p[0]).y;
  return std::min(best, std::sqrt(CGAL::to_double(dx * dx + dy * dy)));
}

/// Three of the points need as large a circle as all of them.
double smallest_enclosing_radius(std::span<const Point_2> points) {
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        largest = std::max(largest, smallest_enclosing_radius_of_three({points[i], points[j], points[k]}));
  return largest;
}

/// Per triangle the least inner one with the same circle that inner neighbours lead to; -1 for those that are not
/// inner.
std::vector<int> circles_by_rationals(const Delaunay_2& d, const Labels_2& labels) {
  const int count = static_cast<int>(d.triangles.size());
  std::vector<int> circle(count, -1);
  for (int first = 0; first < count; ++first) {
    if (!labels.is_inner[first] || circle[first] >= 0) continue;
    const auto& [a, b, c] = d.triangles[first];
    std::vector<int> reached{first};
    circle[first] = first;
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (const int n : d.neighbors[reached[next]]) {
        if (n < 0 || !labels.is_inner[n] || circle[n] >= 0) continue;
        const auto is_on_circle = [&](int corner) {
          return in_circle(d.points[a], d.points[b], d.points[c], d.points[corner]) == 0;
        };
        if (!std::ranges::all_of(d.triangles[n], is_on_circle)) continue;
        circle[n] = first;
        reached.push_back(n);
      }
    }
  }
  return circle;
}

void expect_axis_by_definition(const Result& r) {
  const auto& [d, v, crust, labels, axis] = r;
  const std::vector<int> circle = circles_by_rationals(d, labels);
  std::vector<int> expected_balls;
  std::vector<std::array<int, 2>> triangles_of_circles;
  for (int t = 0; t < static_cast<int>(circle.size()); ++t) {
    if (circle[t] == t) expected_balls.push_back(t);
    if (circle[t] >= 0) triangles_of_circles.push_back({circle[t], t});
  }
  std::vector<int> balls;
  std::vector<std::array<int, 2>> found_triangles;
  for (std::size_t b = 0; b < axis.triangles.size(); ++b) {
    const int own = circle.at(axis.triangles[b]);
    balls.push_back(own);
    found_triangles.push_back({own, axis.triangles[b]});
    const std::vector<int> contacts = contacts_of_ball(d, axis, static_cast<int>(b));
    std::set<int> expected_contacts;
    for (std::size_t t = 0; t < circle.size(); ++t)
      if (circle[t] == own) expected_contacts.insert(d.triangles[t].begin(), d.triangles[t].end());
    EXPECT_EQ(contacts, std::vector<int>(expected_contacts.begin(), expected_contacts.end()));
  }
  for (const auto& [b, t] : axis.further_triangles) found_triangles.push_back({circle.at(axis.triangles.at(b)), t});
  EXPECT_TRUE(std::ranges::is_sorted(axis.further_triangles));
  std::ranges::sort(triangles_of_circles);
  std::ranges::sort(found_triangles);
  EXPECT_EQ(found_triangles, triangles_of_circles);
  ASSERT_EQ(balls, expected_balls);
  ASSERT_EQ(axis.centers.size(), balls.size());
  ASSERT_EQ(axis.radii.size(), balls.size());
  for (std::size_t b = 0; b < axis.triangles.size(); ++b) {
    EXPECT_EQ(axis.centers[b], v.vertices[axis.triangles[b]]);
    EXPECT_EQ(axis.radii[b], v.radii[axis.triangles[b]]);
  }
  using Full_edge = std::tuple<Edge, Edge>;
  std::vector<Full_edge> expected;
  for (int t = 0; t < static_cast<int>(d.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int n = d.neighbors[t][i];
      if (n > t && labels.is_inner[t] && labels.is_inner[n] && circle[t] != circle[n])
        expected.push_back({sorted_edge({circle[t], circle[n]}), sorted_edge(d.edge(t, i))});
    }
  }
  std::ranges::sort(expected);
  std::vector<Full_edge> found;
  ASSERT_EQ(axis.edges.size(), axis.contacts.size());
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    const auto [a, b] = axis.edges[e];
    found.push_back({sorted_edge({balls.at(a), balls.at(b)}), sorted_edge(axis.contacts[e])});
  }
  std::ranges::sort(found);
  EXPECT_EQ(found, expected);
}

TEST(Medial_axis_2, equals_the_definition) {
  for (const auto& sets : {difficult_point_sets(), general_point_sets()}) {
    for (const auto& [name, points] : sets) {
      SCOPED_TRACE(name);
      expect_axis_by_definition(compute(points));
    }
  }
  for (const Smooth_shape& shape : smooth_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_axis_by_definition(compute(shape.samples()));
  }
}

TEST(Medial_axis_2, equals_the_definition_on_real_shapes) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("xy")) {
    SCOPED_TRACE(file.filename());
    expect_axis_by_definition(compute(points_of(file)));
  }
}

TEST(Medial_axis_2, balls_are_empty_and_touch_three_samples) {
  for (const char* name : {"ellipse", "jittered ellipse", "superellipse", "annulus", "two disjoint circles"}) {
    SCOPED_TRACE(name);
    const Result r = shape_of(name);
    for (std::size_t b = 0; b < r.axis.centers.size(); ++b) {
      const double radius = r.axis.radii[b];
      for (const Point_2& p : r.triangulation.points)
        ASSERT_GE(distance(p, r.axis.centers[b]), radius * (1 - 1e-9)) << "ball " << b;
      for (const int contact : r.triangulation.triangles[r.axis.triangles[b]])
        ASSERT_NEAR(distance(r.triangulation.points[contact], r.axis.centers[b]), radius, 1e-9 * radius);
    }
  }
}

TEST(Medial_axis_2, every_point_of_an_edge_has_its_contacts_as_nearest_samples) {
  const Result r = shape_of("jittered ellipse");
  for (std::size_t e = 0; e < r.axis.edges.size(); ++e) {
    const Point_2& a = r.axis.centers[r.axis.edges[e][0]];
    const Point_2& b = r.axis.centers[r.axis.edges[e][1]];
    for (const double t : {0.1, 0.5, 0.9}) {
      const Point_2 m{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      double nearest = std::numeric_limits<double>::infinity();
      for (const Point_2& p : r.triangulation.points) nearest = std::min(nearest, distance(p, m));
      for (const int contact : r.axis.contacts[e])
        ASSERT_NEAR(distance(r.triangulation.points[contact], m), nearest, 1e-9) << "edge " << e;
    }
  }
}

/// Betti numbers of the axis as a graph.
std::array<int, 2> betti(const Medial_axis_2& axis) {
  std::vector<int> parent(axis.centers.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int a) {
    while (parent[a] != a) a = parent[a];
    return a;
  };
  int components = static_cast<int>(parent.size());
  for (const auto& [a, b] : axis.edges) {
    const int x = root(a);
    const int y = root(b);
    if (x == y) continue;
    parent[x] = y;
    --components;
  }
  return {components, static_cast<int>(axis.edges.size()) - static_cast<int>(axis.centers.size()) + components};
}

TEST(Medial_axis_2, has_the_topology_of_the_shape) {
  EXPECT_EQ(betti(shape_of("ellipse").axis), (std::array{1, 0}));
  EXPECT_EQ(betti(shape_of("jittered flower").axis), (std::array{1, 0}));
  EXPECT_EQ(betti(shape_of("two disjoint circles").axis), (std::array{2, 0}));
  EXPECT_EQ(betti(shape_of("annulus").axis), (std::array{1, 1}));
}

TEST(Medial_axis_2, of_an_ellipse_lies_on_its_long_axis) {
  constexpr double a = 2;
  constexpr double b = 1;
  constexpr double end = (a * a - b * b) / a;
  const Result r = compute(ellipse(a, b, 3000, 0.5, 3));
  Progress progress;
  const std::vector<double> angles = angle_of_edges(r.triangulation, r.axis, progress);
  std::vector<double> reached;
  for (std::size_t e = 0; e < r.axis.edges.size(); ++e) {
    if (angles[e] < 60) continue;
    for (const int ball : r.axis.edges[e]) {
      const Point_2& m = r.axis.centers[ball];
      EXPECT_LT(std::abs(m.y), 0.02);
      EXPECT_LT(std::abs(m.x), end + 0.02);
      reached.push_back(m.x);
    }
  }
  std::ranges::sort(reached);
  ASSERT_FALSE(reached.empty());
  // The axis at x has the contact angle 2 acos(...), 60 degrees only close to the ends.
  const auto angle_at = [&](double x) {
    const double contact_x = x * a * a / (a * a - b * b);
    const double contact_y = b * std::sqrt(1 - contact_x * contact_x / (a * a));
    return 2 * std::atan2(contact_y, contact_x - x) * 180 / std::numbers::pi;
  };
  double last = 0;
  while (last + 1e-4 < end && angle_at(last + 1e-4) > 65) last += 1e-4;
  EXPECT_LT(reached.front(), -last);
  EXPECT_GT(reached.back(), last);
  for (std::size_t i = 1; i < reached.size(); ++i) EXPECT_LT(reached[i] - reached[i - 1], 0.02);
}

void expect_measures_by_definition(const Result& r) {
  const Delaunay_2& d = r.triangulation;
  Progress progress;
  const std::vector<double> edge_lambda = lambda_of_edges(d, r.axis, progress);
  const std::vector<double> edge_angle = angle_of_edges(d, r.axis, progress);
  const std::vector<double> ball_lambda = lambda_of_balls(d, r.axis, progress);
  const std::vector<double> ball_angle = angle_of_balls(d, r.axis, progress);
  const std::vector<double> slopes = slope_of_balls(d, r.axis, progress);
  ASSERT_EQ(slopes.size(), r.axis.centers.size());
  ASSERT_EQ(edge_lambda.size(), r.axis.edges.size());
  ASSERT_EQ(edge_angle.size(), r.axis.edges.size());
  ASSERT_EQ(ball_lambda.size(), r.axis.centers.size());
  ASSERT_EQ(ball_angle.size(), r.axis.centers.size());
  for (std::size_t e = 0; e < r.axis.edges.size(); ++e) {
    const std::array<Point_2, 2> contacts{d.points[r.axis.contacts[e][0]], d.points[r.axis.contacts[e][1]]};
    const double half = distance(contacts[0], contacts[1]) / 2;
    EXPECT_NEAR(edge_lambda[e], half, 1e-12 * half);
    const Point_2& a = r.axis.centers[r.axis.edges[e][0]];
    const Point_2& b = r.axis.centers[r.axis.edges[e][1]];
    // Refined around the best of a row of points.
    double low = 0;
    double high = 1;
    double best = 0;
    for (int round = 0; round < 12; ++round) {
      constexpr int steps = 20;
      double best_t = low;
      for (int i = 0; i <= steps; ++i) {
        const double t = low + (high - low) * i / steps;
        const double angle = largest_angle({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, contacts);
        if (angle >= best) {
          best = angle;
          best_t = t;
        }
      }
      const double width = (high - low) / steps;
      low = std::max(0.0, best_t - width);
      high = std::min(1.0, best_t + width);
    }
    EXPECT_GT(edge_angle[e], 0);
    EXPECT_LE(edge_angle[e], 180);
    EXPECT_NEAR(edge_angle[e], best, 1e-4) << "edge " << e;
  }
  for (std::size_t b = 0; b < r.axis.centers.size(); ++b) {
    std::vector<Point_2> contacts;
    for (const int contact : contacts_of_ball(d, r.axis, static_cast<int>(b))) contacts.push_back(d.points[contact]);
    const double expected = smallest_enclosing_radius(contacts);
    EXPECT_NEAR(ball_lambda[b], expected, 1e-9 * expected) << "ball " << b;
    const double angle = largest_angle(r.axis.centers[b], contacts);
    EXPECT_NEAR(ball_angle[b], angle, 1e-5) << "ball " << b;
    const bool has_center_within = expected > (1 - 1e-12) * r.axis.radii[b];
    EXPECT_NEAR(slopes[b], has_center_within ? 0 : std::cos(angle * std::numbers::pi / 360), 1e-5) << "ball " << b;
  }
}

TEST(Medial_measures_2, equal_the_definitions) {
  for (const char* name : {"jittered ellipse", "flower", "annulus", "circle", "superellipse"}) {
    SCOPED_TRACE(name);
    expect_measures_by_definition(shape_of(name));
  }
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    SCOPED_TRACE(seed);
    expect_measures_by_definition(compute(noisy_curve(150, 0.05, seed)));
  }
}

TEST(Medial_measures_2, equal_the_definitions_of_cocircular_samples) {
  expect_measures_by_definition(compute(grid_points(7, 5)));
  expect_measures_by_definition(compute(rectangle_samples({16, 9}, 1)));
  expect_measures_by_definition(compute(rectangle_samples({16, 9}, 0.7)));
  std::vector<Point_2> arc = shuffled(cocircular_points(), 4);
  arc.resize(24);
  expect_measures_by_definition(compute(arc));
  // The center is not among these.
  std::erase_if(arc, [](const Point_2& p) { return p.y < 0; });
  expect_measures_by_definition(compute(arc));
}

TEST(Medial_axis_2, has_one_ball_where_samples_are_cocircular) {
  const Result square = compute(std::vector<Point_2>{{0, 0}, {3, 0}, {3, 3}, {0, 3}});
  ASSERT_EQ(square.axis.centers, (std::vector<Point_2>{{1.5, 1.5}}));
  EXPECT_TRUE(square.axis.edges.empty());
  EXPECT_EQ(contacts_of_ball(square.triangulation, square.axis, 0), (std::vector{0, 1, 2, 3}));
  const Result circle = compute(cocircular_points());
  ASSERT_EQ(circle.axis.centers.size(), 1U);
  EXPECT_NEAR(distance(circle.axis.centers[0], {0, 0}), 0, 1e-9);
  EXPECT_EQ(contacts_of_ball(circle.triangulation, circle.axis, 0).size(), cocircular_points().size());
  EXPECT_TRUE(circle.axis.edges.empty());
  // The axis of a rectangle whose sides are sampled evenly: one disk for every step inwards or along.
  const Result rectangle = compute(rectangle_samples({12, 8}, 1));
  EXPECT_EQ(betti(rectangle.axis), (std::array{1, 0}));
  for (std::size_t e = 0; e < rectangle.axis.edges.size(); ++e) {
    const auto [a, b] = rectangle.axis.edges[e];
    EXPECT_GT(distance(rectangle.axis.centers[a], rectangle.axis.centers[b]), 0.1) << "edge " << e;
  }
}

TEST(Medial_measures_2, equal_the_definitions_on_real_shapes) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("xy")) {
    SCOPED_TRACE(file.filename());
    expect_measures_by_definition(compute(points_of(file)));
  }
}

TEST(Medial_measures_2, are_scaled_with_the_shape) {
  const std::vector<Point_2> points = flower(600, 0.3, 5, 0.8, 9);
  Progress progress;
  const Result r = compute(points);
  for (const int exponent : {-100, 100}) {
    const Result other = compute(scaled(points, exponent));
    ASSERT_EQ(other.axis.edges, r.axis.edges);
    EXPECT_EQ(angle_of_edges(other.triangulation, other.axis, progress),
              angle_of_edges(r.triangulation, r.axis, progress));
    const std::vector<double> lambda = lambda_of_edges(r.triangulation, r.axis, progress);
    const std::vector<double> other_lambda = lambda_of_edges(other.triangulation, other.axis, progress);
    for (std::size_t e = 0; e < lambda.size(); ++e)
      EXPECT_DOUBLE_EQ(other_lambda[e], std::ldexp(lambda[e], exponent)) << e;
  }
}

}  // namespace
}  // namespace mesecina::test
