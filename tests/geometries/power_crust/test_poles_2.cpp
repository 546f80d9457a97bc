// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "geometries/power_crust_2/power_crust_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

Poles_2 poles_of(std::span<const Point_2> samples) {
  Progress progress;
  const Delaunay_2 triangulation = delaunay(samples, progress);
  return find_poles(triangulation, voronoi(triangulation, progress), progress);
}

Rational exact_squared_distance(const Exact_point& p, const Exact_point& q) {
  const Rational x = p.x - q.x;
  const Rational y = p.y - q.y;
  return x * x + y * y;
}

/// The samples next to s along the hull of all; nullopt when s is not on it. By trying every sample against every
/// other.
std::optional<std::array<Point_2, 2>> hull_neighbors(std::span<const Point_2> samples, const Point_2& s) {
  std::optional<Point_2> before;
  std::optional<Point_2> after;
  for (const Point_2& q : samples) {
    if (q == s) continue;
    bool all_left = true;
    bool all_right = true;
    for (const Point_2& x : samples) {
      all_left = all_left && orientation(s, q, x) >= 0;
      all_right = all_right && orientation(s, q, x) <= 0;
    }
    if (all_left && (!after || squared_distance(s, q) < squared_distance(s, *after))) after = q;
    if (all_right && (!before || squared_distance(s, q) < squared_distance(s, *before))) before = q;
  }
  if (!before || !after) return std::nullopt;
  return std::array{*before, *after};
}

/// Squared distances of the poles of a sample by the definition: among all circles through three samples and the sample
/// that contain no other. Nothing for a pole that there is not.
struct Expected_poles {
  bool is_on_hull = false;
  std::optional<Rational> first;
  std::optional<Rational> second;
};

struct Voronoi_vertex {
  Exact_point center;
  Rational squared_radius;
};

std::vector<Voronoi_vertex> exact_voronoi_vertices(const Delaunay_2& triangulation) {
  std::vector<Voronoi_vertex> result;
  for (const auto& [a, b, c] : triangulation.triangles) {
    const Exact_point center =
        exact_circumcenter(triangulation.points[a], triangulation.points[b], triangulation.points[c]);
    result.push_back({center, exact_squared_distance(center, exact(triangulation.points[a]))});
  }
  return result;
}

Expected_poles expected_poles(std::span<const Point_2> samples, const std::vector<Voronoi_vertex>& vertices,
                              const Point_2& s) {
  const Exact_point at = exact(s);
  std::vector<Exact_point> cell;
  for (const Voronoi_vertex& vertex : vertices)
    if (exact_squared_distance(vertex.center, at) == vertex.squared_radius) cell.push_back(vertex.center);

  Expected_poles expected;
  std::function<bool(const Exact_point&)> is_behind;
  if (const auto neighbors = hull_neighbors(samples, s)) {
    expected.is_on_hull = true;
    const auto& [before, after] = *neighbors;
    const auto unit = [](const Point_2& p, const Point_2& q) {
      const long double x = static_cast<long double>(q.x) - p.x;
      const long double y = static_cast<long double>(q.y) - p.y;
      return std::array{x / std::hypot(x, y), y / std::hypot(x, y)};
    };
    const auto in = unit(before, s);
    const auto out = unit(s, after);
    is_behind = [=](const Exact_point& center) {
      const long double x = CGAL::to_double(Rational(center.x - at.x));
      const long double y = CGAL::to_double(Rational(center.y - at.y));
      return (in[1] + out[1]) * x - (in[0] + out[0]) * y < -1e-13L * std::hypot(x, y);
    };
  } else {
    const auto farther = [&](const Exact_point& p, const Exact_point& q) {
      return exact_squared_distance(p, at) < exact_squared_distance(q, at);
    };
    const Exact_point first = *std::ranges::max_element(cell, farther);
    expected.first = exact_squared_distance(first, at);
    is_behind = [=](const Exact_point& center) {
      return (center.x - at.x) * (first.x - at.x) + (center.y - at.y) * (first.y - at.y) < 0;
    };
  }
  for (const Exact_point& center : cell) {
    const Rational d = exact_squared_distance(center, at);
    if (is_behind(center) && (!expected.second || d > *expected.second)) expected.second = d;
  }
  return expected;
}

void expect_poles_by_definition(const std::vector<Point_2>& samples) {
  Progress progress;
  const Delaunay_2 triangulation = delaunay(samples, progress);
  const Poles_2 poles = find_poles(triangulation, voronoi(triangulation, progress), progress);
  const std::vector<Voronoi_vertex> vertices = exact_voronoi_vertices(triangulation);
  // Of equally far vertices any may be the first pole, and the second one depends on it.
  const auto squared_distance_of = [&](int pole) { return vertices[poles.triangles[pole]].squared_radius; };
  for (int s = 0; s < static_cast<int>(samples.size()); ++s) {
    SCOPED_TRACE("sample " + std::to_string(s));
    if (triangulation.site[s] != s) {
      EXPECT_EQ(poles.first[s], -1);
      EXPECT_EQ(poles.second[s], -1);
      continue;
    }
    const Expected_poles expected = expected_poles(samples, vertices, samples[s]);
    ASSERT_GE(poles.first[s], 0);
    EXPECT_EQ(poles.is_infinite(poles.first[s]), expected.is_on_hull);
    if (expected.first) {
      EXPECT_EQ(squared_distance_of(poles.first[s]), *expected.first);
    }
    ASSERT_EQ(poles.second[s] >= 0, expected.second.has_value());
    if (expected.second) {
      EXPECT_EQ(squared_distance_of(poles.second[s]), *expected.second);
    }
  }
}

TEST(Poles, AreThoseOfTheDefinition) {
  expect_poles_by_definition(uniform_points(80, 5));
  expect_poles_by_definition(clustered_points(70, 6));
  expect_poles_by_definition(flower(90, 0.3, 5, 0.8));
  expect_poles_by_definition(with_duplicates(uniform_points(40, 7), 30, 8));
}

TEST(Poles, AreThoseOfTheDefinitionForCocircularSamples) {
  expect_poles_by_definition({{0, 0}, {4, 0}, {0, 3}});
  expect_poles_by_definition({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  expect_poles_by_definition(shuffled(grid_points(7, 5), 3));
  std::vector<Point_2> some(cocircular_points());
  some.resize(60);
  expect_poles_by_definition(some);
  some.push_back({0, 0});
  expect_poles_by_definition(some);
}

TEST(Poles, ArePolesOfTheirSamplesAndEachOnce) {
  for (const auto& [name, points] : difficult_point_sets()) {
    SCOPED_TRACE(name);
    Progress progress;
    const Delaunay_2 triangulation = delaunay(points, progress);
    const Poles_2 poles = find_poles(triangulation, voronoi(triangulation, progress), progress);
    if (triangulation.dimension < 2) {
      EXPECT_EQ(poles.size(), 0u);
      continue;
    }
    for (int p = 0; p < static_cast<int>(poles.size()); ++p) {
      const auto contacts = poles.balls->contacts_of(p);
      if (p > 0 && poles.is_infinite(p) == poles.is_infinite(p - 1)) {
        EXPECT_TRUE(std::ranges::lexicographical_compare(poles.balls->contacts_of(p - 1), contacts));
      }
      ASSERT_FALSE(poles.samples_of(p).empty());
      EXPECT_TRUE(std::ranges::is_sorted(poles.samples_of(p)));
      if (poles.is_infinite(p)) {
        EXPECT_EQ(poles.samples_of(p).size(), 1u);
      }
      for (const int s : poles.samples_of(p)) {
        EXPECT_TRUE(poles.first[s] == p || poles.second[s] == p);
        EXPECT_EQ(poles.opposite(p, s), poles.first[s] == p ? poles.second[s] : poles.first[s]);
        EXPECT_TRUE(std::ranges::binary_search(contacts, s));
      }
    }
    const std::size_t pairs =
        static_cast<std::size_t>(std::ranges::count_if(poles.first, [](int p) { return p >= 0; }) +
                                 std::ranges::count_if(poles.second, [](int p) { return p >= 0; }));
    EXPECT_EQ(poles.samples.size(), pairs);
  }
}

TEST(Poles, AtInfinityHaveDisksThatTouchTheHullFromOutside) {
  const std::vector<Point_2> samples = {{0, 0}, {2, 0}, {4, 0}, {4, 2}, {0, 2}, {1, 1}};
  const Poles_2 poles = poles_of(samples);
  EXPECT_EQ(poles.size() - poles.finite_count(), 5u);
  const double diagonal = std::sqrt(20.0);
  const std::map<int, Point_2> directions = {{0, {-1, -1}}, {1, {0, -1}}, {2, {1, -1}}, {3, {1, 1}}, {4, {-1, 1}}};
  for (const auto& [s, direction] : directions) {
    const int pole = poles.first[s];
    ASSERT_TRUE(poles.is_infinite(pole));
    const double radius = poles.balls->radii[pole];
    EXPECT_NEAR(radius, 1024 * diagonal, 1e-9 * radius);
    const double length = std::hypot(direction.x, direction.y);
    EXPECT_NEAR(poles.balls->centers[pole].x, samples[s].x + radius * direction.x / length, 1e-9 * radius);
    EXPECT_NEAR(poles.balls->centers[pole].y, samples[s].y + radius * direction.y / length, 1e-9 * radius);
    for (const Point_2& other : samples)
      EXPECT_GE(distance(other, poles.balls->centers[pole]), radius * (1 - 1e-15)) << s;
  }
  EXPECT_FALSE(poles.is_infinite(poles.first[5]));
}

/// The poles of every sample, named by the samples on their circles; as they were before the permutation.
std::vector<std::array<std::set<int>, 2>> named_poles(const Poles_2& poles, const std::vector<int>& original) {
  const int count = static_cast<int>(original.size());
  std::vector<std::array<std::set<int>, 2>> result(original.size());
  for (int s = 0; s < count; ++s) {
    for (const bool first : {true, false}) {
      const int pole = first ? poles.first[s] : poles.second[s];
      if (pole < 0) continue;
      std::set<int>& name = result[original[s]][first ? 0 : 1];
      for (const int contact : poles.balls->contacts_of(pole)) name.insert(contact < count ? original[contact] : -1);
    }
  }
  return result;
}

TEST(Poles, DoNotDependOnTheOrderOfTheSamples) {
  for (const auto& [name, points] : general_point_sets()) {
    SCOPED_TRACE(name);
    std::vector<int> identity(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) identity[i] = static_cast<int>(i);
    const auto expected = named_poles(poles_of(points), identity);
    const std::vector<int> permutation = random_permutation(static_cast<int>(points.size()), 99);
    std::vector<Point_2> permuted;
    for (const int i : permutation) permuted.push_back(points[i]);
    EXPECT_EQ(named_poles(poles_of(permuted), permutation), expected);
  }
}

}  // namespace
}  // namespace mesecina::test
