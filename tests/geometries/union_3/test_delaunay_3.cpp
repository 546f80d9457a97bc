// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/outcome.h"
#include "geometries/delaunay_3/delaunay_3.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"
#include "tests/geometries/union_3/alpha_complex_3.h"
#include "tests/geometries/union_3/ball_sets.h"

/// The Delaunay triangulation beside GUDHI's, which goes by CGAL's triangulations of any dimension: the same cells,
/// also where more than four points lie on one sphere.
namespace mesecina::test {
namespace {

/// The first point of each position.
std::vector<int> sites_of(const std::vector<Point_3>& points) {
  std::map<std::array<double, 3>, int> first;
  std::vector<int> sites;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    sites.push_back(first.try_emplace({points[i].x, points[i].y, points[i].z}, i).first->second);
  return sites;
}

std::vector<Ball_3> without_radii(const std::vector<Ball_3>& balls) {
  std::vector<Ball_3> points = balls;
  for (Ball_3& b : points) b.radius = 0;
  return points;
}

/// Of the centers.
testing::AssertionResult centers_agree_with_gudhi(const std::vector<Ball_3>& balls) {
  const Alpha_complex theirs = alpha_complex(without_radii(balls));
  std::map<Simplex_3, double> cells;
  for (const auto& [simplex, value] : theirs.values)
    if (simplex.front() >= 0) cells.emplace(simplex, value);
  std::vector<Point_3> points;
  double largest = 0;
  for (const Ball_3& b : balls) {
    points.push_back(b.center);
    largest = std::max({largest, std::abs(b.center.x), std::abs(b.center.y), std::abs(b.center.z)});
  }
  Delaunay_3 ours;
  try {
    Progress progress;
    ours = delaunay(points, progress);
  } catch (const Unavailable&) {
    return cells.empty() ? testing::AssertionSuccess() : failure() << "there is a tetrahedron";
  }
  const std::vector<int> sites = sites_of(points);
  if (ours.points != points) return failure() << "other points";
  if (ours.site != sites) return failure() << "other sites";
  if (ours.site_count != std::set<int>(sites.begin(), sites.end()).size())
    return failure() << "a wrong number of sites";
  if (ours.cells.size() != cells.size()) return failure() << ours.cells.size() << " cells, theirs " << cells.size();
  for (std::size_t i = 0; i < ours.cells.size(); ++i) {
    const auto it = cells.find(simplex_of(ours.cells[i]));
    if (it == cells.end()) return failure() << "cell " << testing::PrintToString(ours.cells[i]) << " is not in theirs";
    const double radius = std::sqrt(it->second);
    if (std::abs(ours.circumradii[i] - radius) > 1e-9 * radius + 1e-13 * largest)
      return failure() << "radius " << ours.circumradii[i] << ", theirs " << radius;
    for (int place = 0; place < 4; ++place) {
      const int across = ours.neighbors[i][place];
      if (across < 0) continue;
      for (int k = 0; k < 4; ++k)
        if (k != place && std::ranges::count(ours.cells[across], ours.cells[i][k]) == 0)
          return failure() << "a neighbor lacks a corner";
    }
  }
  return testing::AssertionSuccess();
}

TEST(Delaunay_3, of_special_points_has_the_cells_of_gudhi) {
  expect_of_balls(repetitions(30), [](const std::vector<Ball_3>& balls) {
    return may_underflow(balls) ? testing::AssertionSuccess() : centers_agree_with_gudhi(balls);
  });
}

TEST(Delaunay_3, of_random_points_has_the_cells_of_gudhi) {
  for (const int count : {4, 5, 20, 200, 1000})
    for (std::uint64_t seed = 0; seed < repetitions(2); ++seed)
      EXPECT_TRUE(centers_agree_with_gudhi(many_balls(count, 1, seed))) << count << " points, seed " << seed;
}

TEST(Delaunay_3, of_a_lattice_has_the_cells_of_gudhi) {
  std::vector<Ball_3> points;
  for (int i = 0; i < 6 * 6 * 6; ++i) points.push_back({{1.0 * (i % 6), 1.0 * (i / 6 % 6), 1.0 * (i / 36)}, 0});
  EXPECT_TRUE(centers_agree_with_gudhi(points));
  // Another order, and each there twice.
  const std::vector<Ball_3> copy = points;
  points.insert(points.end(), copy.rbegin(), copy.rend());
  std::ranges::rotate(points, points.begin() + 50);
  EXPECT_TRUE(centers_agree_with_gudhi(points));
}

}  // namespace
}  // namespace mesecina::test
