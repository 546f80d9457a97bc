// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/evolutions_2/curves_2.h"

#include <algorithm>

namespace mesecina {

namespace {

constexpr std::array<int, 2> none{-1, -1};

}  // namespace

Curve_neighbors_2 crust_neighbors(const Delaunay_2& triangulation, const Crust_2& crust) {
  const std::size_t count = triangulation.points.size();
  Curve_neighbors_2 neighbors(count, none);
  std::vector<int> degrees(count, 0);
  const auto join = [&](int p, int q) {
    if (degrees[p] < 2) neighbors[p][degrees[p]] = q;
    ++degrees[p];
  };
  for (const auto& [p, q] : crust.edges) {
    join(p, q);
    join(q, p);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (degrees[i] != 2) neighbors[i] = none;
    if (neighbors[i][0] > neighbors[i][1]) std::swap(neighbors[i][0], neighbors[i][1]);
  }
  for (std::size_t i = 0; i < count; ++i) neighbors[i] = neighbors[triangulation.site[i]];
  return neighbors;
}

Curve_neighbors_2 ring_neighbors(std::size_t count) {
  Curve_neighbors_2 neighbors(count, none);
  if (count < 3) return neighbors;
  const int last = static_cast<int>(count) - 1;
  for (int i = 0; i <= last; ++i) neighbors[i] = {i == 0 ? last : i - 1, i == last ? 0 : i + 1};
  return neighbors;
}

bool has_neighbors(const Curve_neighbors_2& neighbors) {
  return std::ranges::any_of(neighbors, [](const auto& pair) { return pair != none; });
}

std::vector<Point_2> smoothed(std::vector<Point_2> points, const Curve_neighbors_2& neighbors,
                              std::span<const double> factors) {
  for (const double factor : factors) {
    const std::vector<Point_2> before = points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (neighbors[i] == none) continue;
      const Point_2 middle = midpoint(before[neighbors[i][0]], before[neighbors[i][1]]);
      points[i] = {before[i].x + factor * (middle.x - before[i].x), before[i].y + factor * (middle.y - before[i].y)};
    }
  }
  return points;
}

std::vector<Point_2> subdivided(std::span<const Point_2> points, const Curve_neighbors_2& neighbors,
                                std::span<const std::array<int, 2>> edges) {
  std::vector<Point_2> result(points.begin(), points.end());
  result.reserve(points.size() + edges.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (neighbors[i] == none) continue;
    const Point_2& a = points[neighbors[i][0]];
    const Point_2& b = points[neighbors[i][1]];
    result[i] = {0.75 * points[i].x + 0.125 * (a.x + b.x), 0.75 * points[i].y + 0.125 * (a.y + b.y)};
  }
  for (const auto& [p, q] : edges) result.push_back(midpoint(points[p], points[q]));
  return result;
}

std::vector<Point_2> subdivided_ring(std::span<const Point_2> ring) {
  if (ring.size() < 3) return {ring.begin(), ring.end()};
  std::vector<Point_2> result = subdivided(ring, ring_neighbors(ring.size()), {});
  std::vector<Point_2> all;
  all.reserve(2 * ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    all.push_back(result[i]);
    all.push_back(midpoint(ring[i], ring[(i + 1) % ring.size()]));
  }
  return all;
}

std::vector<Point_2> with_noise(std::vector<Point_2> points, const Curve_neighbors_2& neighbors, double amplitude,
                                Portable_random& random) {
  const std::vector<Point_2> before = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (neighbors[i] == none) continue;
    const double part = amplitude * random.within(-1, 1);
    const Point_2& a = before[neighbors[i][0]];
    const Point_2& b = before[neighbors[i][1]];
    points[i].x += part * (a.y - b.y);
    points[i].y += part * (b.x - a.x);
  }
  return points;
}

}  // namespace mesecina
