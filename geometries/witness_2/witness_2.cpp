// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/witness_2/witness_2.h"

#include <algorithm>
#include <cmath>

#include "geometries/nearest_points.h"
#include "geometries/parallel.h"

namespace mesecina {

Witnesses_2 witness(std::span<const Point_2> witnesses, std::span<const Point_2> landmarks, Progress& progress) {
  const Nearest_points<Point_2> tree({landmarks.begin(), landmarks.end()});
  Witnesses_2 result;
  result.nearest.resize(witnesses.size());
  result.distances.resize(witnesses.size());
  parallel_for(witnesses.size(), progress, [&](std::size_t w) {
    const auto [first, second] = tree.nearest_two(witnesses[w]);
    result.nearest[w] = {first.point, second.point};
    result.distances[w] = std::sqrt(first.squared_distance);
  });
  std::vector<std::array<int, 2>> pairs;
  pairs.reserve(witnesses.size());
  for (std::size_t w = 0; w < witnesses.size(); ++w) {
    if (result.farthest < 0 || result.distances[w] > result.distances[result.farthest])
      result.farthest = static_cast<int>(w);
    const auto [a, b] = result.nearest[w];
    if (b >= 0) pairs.push_back({std::min(a, b), std::max(a, b)});
  }
  std::ranges::sort(pairs);
  for (const auto& pair : pairs) {
    if (result.edges.empty() || result.edges.back().landmarks != pair) result.edges.push_back({pair, 0});
    ++result.edges.back().witnesses;
  }
  return result;
}

}  // namespace mesecina
