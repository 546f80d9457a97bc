// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "geometries/delaunay_3/growing_delaunay_3.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

std::vector<Point_3> random_points(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point_3> points;
  for (int i = 0; i < count; ++i) points.push_back({random.unit(), random.unit(), random.unit()});
  return points;
}
/// Many on one sphere, and equal ones.
std::vector<Point_3> lattice_points(int count, std::uint64_t seed) {
  std::vector<Point_3> points = random_points(count, seed);
  for (Point_3& p : points) p = {std::floor(6 * p.x), std::floor(6 * p.y), std::floor(6 * p.z)};
  return points;
}

/// Cells by their corners, each with the corners of those across from them.
std::map<std::array<int, 4>, std::vector<std::array<int, 4>>> cells_of(const Delaunay_3& triangulation) {
  const auto corners_of = [&](int c) {
    std::array<int, 4> corners{-1, -1, -1, -1};
    if (c >= 0) corners = triangulation.cells[c];
    std::ranges::sort(corners);
    return corners;
  };
  std::map<std::array<int, 4>, std::vector<std::array<int, 4>>> cells;
  for (std::size_t c = 0; c < triangulation.cells.size(); ++c) {
    auto& across = cells[corners_of(static_cast<int>(c))];
    for (const int next : triangulation.neighbors[c]) across.push_back(corners_of(next));
    std::ranges::sort(across);
  }
  return cells;
}

struct Steps {
  std::vector<Point_3> points;
  std::vector<std::size_t> sizes;  ///< how many are there after each step
};
std::vector<Steps> all_steps() {
  return {{random_points(500, 1), {100, 101, 130, 130, 500}},
          {lattice_points(400, 2), {60, 61, 100, 400}},
          {random_points(300, 3), {299, 300}}};
}

TEST(Growing_delaunay_3, IsThatOfAllPointsAtOnce) {
  for (const auto& [points, sizes] : all_steps()) {
    Progress progress;
    Growing_delaunay_3 growing;
    std::size_t count = 0;
    for (const std::size_t size : sizes) {
      growing.add(std::span(points).subspan(count, size - count), progress);
      count = size;
      const Delaunay_3 at_once =
          delaunay({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count)}, progress);
      EXPECT_EQ(growing.get().points, at_once.points);
      EXPECT_EQ(growing.get().site, at_once.site);
      EXPECT_EQ(growing.get().site_count, at_once.site_count);
      EXPECT_EQ(growing.get().cells.size(), at_once.cells.size());
      EXPECT_EQ(cells_of(growing.get()), cells_of(at_once)) << count;
    }
  }
}

TEST(Growing_delaunay_3, SaysWhichNumbersHaveOtherCells) {
  for (const auto& [points, sizes] : all_steps()) {
    Progress progress;
    Growing_delaunay_3 growing;
    Delaunay_3 before;
    for (const std::size_t size : sizes) {
      const std::size_t count = before.points.size();
      const std::vector<int> renewed = growing.add(std::span(points).subspan(count, size - count), progress);
      const Delaunay_3& now = growing.get();
      EXPECT_TRUE(std::ranges::is_sorted(renewed));
      for (int c = 0; c < static_cast<int>(now.cells.size()); ++c) {
        if (std::ranges::binary_search(renewed, c)) continue;
        ASSERT_LT(c, static_cast<int>(before.cells.size()));
        EXPECT_EQ(now.cells[c], before.cells[c]);
        EXPECT_EQ(now.circumcenters[c], before.circumcenters[c]);
        EXPECT_EQ(now.circumradii[c], before.circumradii[c]);
      }
      if (count > 0 && size <= count + 1) {
        EXPECT_LT(renewed.size(), now.cells.size() / 2);
      }
      before = now;
    }
  }
}

TEST(Growing_delaunay_3, CellsMayBecomeFewer) {
  // Cells between two lines, every point of the one with every point of the other; a point between them ends them all.
  std::vector<Point_3> points;
  constexpr int count = 12;
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * (i - (count - 1) / 2.0);
    points.push_back({t, 0, 1});
    points.push_back({0, t, -1});
  }
  Progress progress;
  Growing_delaunay_3 growing;
  growing.add(points, progress);
  const std::size_t before = growing.get().cells.size();
  points.push_back({0.01, 0.02, 0.03});
  const std::vector<int> renewed = growing.add(std::span(points).last(1), progress);
  EXPECT_LT(growing.get().cells.size(), before);
  EXPECT_EQ(cells_of(growing.get()), cells_of(delaunay(points, progress)));
  for (const int c : renewed) EXPECT_LT(c, static_cast<int>(growing.get().cells.size()));
  points.push_back({0.5, 0.5, 0.5});
  growing.add(std::span(points).last(1), progress);
  EXPECT_EQ(cells_of(growing.get()), cells_of(delaunay(points, progress)));
}

}  // namespace
}  // namespace mesecina::test
