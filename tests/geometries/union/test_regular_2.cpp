// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/regular_2/regular_2.h"
#include "tests/geometries/results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/geometries/union/disk_sets.h"
#include "tests/geometries/union/power_oracle.h"

namespace mesecina::test {
namespace {

Rational twice_area(const Exact_disk& a, const Exact_disk& b, const Exact_disk& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Twice the area of the convex hull of the centers, by its edges.
Rational twice_hull_area(const std::vector<Exact_disk>& disks, const std::vector<int>& vertices) {
  Rational result = 0;
  for (const int a : vertices) {
    // The next corner counterclockwise: nothing is to the right of the edge to it, and it is the farthest such one.
    int next = -1;
    for (const int b : vertices) {
      if (b == a) continue;
      if (next == -1) {
        next = b;
        continue;
      }
      const int turn = orientation(disks[a], disks[next], disks[b]);
      const auto square = [&](int i) {
        return Rational((disks[i].x - disks[a].x) * (disks[i].x - disks[a].x) +
                        (disks[i].y - disks[a].y) * (disks[i].y - disks[a].y));
      };
      if (turn < 0 || (turn == 0 && square(b) > square(next))) next = b;
    }
    const bool is_corner =
        std::ranges::all_of(vertices, [&](int b) { return orientation(disks[a], disks[next], disks[b]) >= 0; });
    // A vertex within a side of the hull would count the rest of that side twice.
    const bool is_within_side = std::ranges::any_of(vertices, [&](int b) {
      return b != a && b != next && orientation(disks[a], disks[next], disks[b]) == 0 &&
             sign(Rational((disks[b].x - disks[a].x) * (disks[next].x - disks[a].x) +
                           (disks[b].y - disks[a].y) * (disks[next].y - disks[a].y))) < 0;
    });
    if (!is_corner || is_within_side) continue;
    result += disks[a].x * disks[next].y - disks[a].y * disks[next].x;
  }
  return result;
}

testing::AssertionResult is_linked(const Regular_2& r) {
  const int count = static_cast<int>(r.triangles.size());
  if (r.neighbors.size() != r.triangles.size()) return failure() << "as many neighbors as triangles are needed";
  for (int t = 0; t < count; ++t) {
    for (int i = 0; i < 3; ++i) {
      const int n = r.neighbors[t][i];
      if (n == -1) {
        if (!r.edge_is_listed(t, i)) return failure() << "a hull edge is not listed";
        continue;
      }
      if (n < 0 || n >= count || n == t) return failure() << "triangle " << t << " has neighbour " << n;
      const int mirror = r.mirror_corner(t, i);
      const auto [p, q] = r.edge(t, i);
      if (r.neighbors[n][mirror] != t || r.edge(n, mirror) != Edge{q, p})
        return failure() << "triangles " << t << " and " << n << " do not agree on their edge";
      if (r.edge_is_listed(t, i) == r.edge_is_listed(n, mirror)) return failure() << "an edge is not listed once";
    }
  }
  return testing::AssertionSuccess();
}

/// Everything the header promises, against the power diagram by definition.
testing::AssertionResult is_regular_triangulation(const std::shared_ptr<const Balls_2>& balls) {
  Progress progress;
  const Regular_2 r = regular_triangulation(balls, progress);
  const Power_oracle oracle(exact_disks(*balls));
  const auto& disks = oracle.disks();
  if (r.balls != balls) return failure() << "these are other balls";
  if (r.is_hidden.size() != balls->size()) return failure() << "hidden is not said of every disk";
  std::vector<int> vertices;
  for (int i = 0; i < static_cast<int>(disks.size()); ++i) {
    if ((r.is_hidden[i] != 0) != oracle.is_hidden(i))
      return failure() << "disk " << i << " is " << (r.is_hidden[i] ? "" : "not ") << "said to be hidden";
    if (!r.is_hidden[i]) vertices.push_back(i);
  }
  if (r.vertex_count != vertices.size()) return failure() << "vertex_count " << r.vertex_count;
  int dimension = static_cast<int>(std::min<std::size_t>(vertices.size(), 2)) - 1;
  for (std::size_t i = 2; i < vertices.size(); ++i)
    if (orientation(disks[vertices[0]], disks[vertices[1]], disks[vertices[i]]) != 0) dimension = 2;
  if (r.dimension != dimension) return failure() << "dimension " << r.dimension << ", not " << dimension;

  if (dimension < 2) {
    if (!r.triangles.empty() || !r.neighbors.empty()) return failure() << "triangles in dimension " << dimension;
    std::vector<int> sorted = r.line;
    std::ranges::sort(sorted);
    if (sorted != vertices) return failure() << "the line does not hold every vertex once";
    for (std::size_t i = 2; i < r.line.size(); ++i) {
      const Exact_disk& a = disks[r.line[i - 2]];
      const Exact_disk& b = disks[r.line[i - 1]];
      const Exact_disk& c = disks[r.line[i]];
      if (sign(Rational((b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y))) <= 0)
        return failure() << "the line is not in order";
    }
    for (std::size_t i = 1; i < r.line.size(); ++i)
      if (!oracle.edge(r.line[i - 1], r.line[i]).has_length()) return failure() << "a neighbour on the line is none";
    return testing::AssertionSuccess();
  }

  if (auto result = is_linked(r); !result) return result;
  Rational area = 0;
  std::set<int> used;
  for (const auto& [a, b, c] : r.triangles) {
    if (orientation(disks[a], disks[b], disks[c]) <= 0) return failure() << "a triangle is not counterclockwise";
    area += twice_area(disks[a], disks[b], disks[c]);
    used.insert({a, b, c});
    // No disk in conflict, hidden ones neither.
    if (!oracle.minimum_on_vertex(a, b, c))
      return failure() << "a disk is in conflict with triangle " << a << " " << b << " " << c;
  }
  if (!std::ranges::equal(used, vertices)) return failure() << "corners of triangles are not the vertices";
  if (area != twice_hull_area(disks, vertices)) return failure() << "the triangles do not fill the hull";

  const Power_vertices_2 power = power_vertices(r, progress);
  if (power.vertices.size() != r.triangles.size() || power.powers.size() != r.triangles.size())
    return failure() << "a power vertex per triangle is needed";
  for (std::size_t t = 0; t < r.triangles.size(); ++t) {
    const auto& [a, b, c] = r.triangles[t];
    const Exact_point p = oracle.power_vertex(a, b, c);
    const Point_2 expected{CGAL::to_double(p.x), CGAL::to_double(p.y)};
    // Rounding of the sides and of centers, over the height of the triangle.
    double scale = 0;
    double longest = 0;
    for (const int i : {a, b, c}) {
      scale = std::max({scale, std::abs(balls->centers[i].x), std::abs(balls->centers[i].y), balls->radii[i]});
      longest = std::max(longest, distance(balls->centers[i], balls->centers[a]));
      longest = std::max(longest, distance(balls->centers[i], balls->centers[b]));
    }
    const double height = CGAL::to_double(twice_area(disks[a], disks[b], disks[c])) / longest;
    const double reach = distance(expected, balls->centers[a]) + scale;
    const double tolerance = 1e-14 * (reach * reach + scale * scale) / std::min(height, scale);
    const auto& found = power.vertices[t];
    if (!(distance(found, expected) <= tolerance))
      return failure() << "power vertex of " << a << " " << b << " " << c << " is (" << found.x << ", " << found.y
                       << "), not (" << expected.x << ", " << expected.y << ")";
    const double power_expected = CGAL::to_double(oracle.orthogonal_power(a, b, c));
    if (!(std::abs(power.powers[t] - power_expected) <= tolerance * (reach + scale)))
      return failure() << "power of " << a << " " << b << " " << c << " is " << power.powers[t] << ", not "
                       << power_expected;
  }
  return testing::AssertionSuccess();
}

TEST(Regular_2, equals_the_definition) { expect_of_given_balls(repetitions(40), is_regular_triangulation); }

TEST(Regular_2, equals_the_definition_for_circumscribed_disks) {
  expect_of_circumscribed_balls(repetitions(16), is_regular_triangulation);
}

TEST(Regular_2, equals_the_definition_for_parts_of_circumscribed_disks) {
  expect_of_circumscribed_balls(repetitions(10), [](const std::shared_ptr<const Balls_2>& balls) {
    std::vector<int> kept;
    for (int i = static_cast<int>(balls->size()) - 1; i >= 0; --i)
      if (i % 3 != 1) kept.push_back(i);
    return is_regular_triangulation(std::make_shared<const Balls_2>(subset(*balls, kept)));
  });
}

TEST(Regular_2, of_points_is_a_delaunay_triangulation) {
  for (const auto& [name, points] : difficult_point_sets()) {
    SCOPED_TRACE(name);
    std::vector<Disk_2> disks;
    for (const Point_2& p : points) disks.push_back({p, 0});
    Progress progress;
    const Regular_2 r = regular_triangulation(std::make_shared<const Balls_2>(given_balls(disks)), progress);
    const Delaunay_2 d = delaunay(points, progress);
    EXPECT_EQ(r.dimension, d.dimension);
    EXPECT_EQ(r.vertex_count, d.site_count);
    EXPECT_EQ(r.triangles.size(), d.triangles.size());
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(r.is_hidden[i] != 0, d.site[i] != static_cast<int>(i));
    for (const auto& [a, b, c] : r.triangles) {
      for (const int s : d.site) ASSERT_LE(in_circle(points[a], points[b], points[c], points[s]), 0);
    }
  }
}

}  // namespace
}  // namespace mesecina::test
