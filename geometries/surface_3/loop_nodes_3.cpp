// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/loop_nodes_3.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace mesecina {

Loop_nodes_3::Loop_nodes_3(const std::vector<std::vector<Point_3>>& loops, double same, double tiny) : same_(same) {
  for (const auto& loop : loops) {
    const int count = static_cast<int>(loop.size());
    const int first = std::exchange(point_count_, point_count_ + count);
    double size = 0;
    for (const Point_3& p : loop) size = std::max(size, distance(p, loop.front()));
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), first);
    if (size < tiny) {
      tiny_loops_.push_back(static_cast<int>(rows_.size()));
      points_.push_back(loop.front());
      rows_.push_back(std::move(all));
      continue;
    }
    // Rows end where the next point is elsewhere; the first one may reach back across the end of the loop.
    int start = 0;
    while (start < count && distance(loop[start], loop[(start + count - 1) % count]) < same) ++start;
    loops_.emplace_back();
    for (int i = 0; i < count; ++i) {
      const int at = (start + i) % count;
      if (i == 0 || distance(loop[at], points_.back()) >= same) {
        loops_.back().push_back(static_cast<int>(rows_.size()));
        points_.push_back(loop[at]);
        rows_.emplace_back();
      }
      rows_.back().push_back(all[at]);
    }
  }
}

bool Loop_nodes_3::has_touching_nodes() const {
  std::vector<Point_3> sorted = points_;
  std::ranges::sort(sorted, {}, &Point_3::x);
  for (std::size_t i = 0; i < sorted.size(); ++i)
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x - sorted[i].x < same_; ++j)
      if (distance(sorted[i], sorted[j]) < same_) return true;
  return false;
}

std::vector<std::array<int, 3>> Loop_nodes_3::expanded(std::vector<std::array<int, 3>> triangles) const {
  const int nodes = static_cast<int>(rows_.size());
  // First points are told from nodes by their sign until all are done.
  for (const int node : tiny_loops_) open_tiny_loop(node, triangles);
  const auto point = [&](int i) {
    if (i < 0) return -1 - i;
    return i < nodes ? rows_[i].front() : i - nodes + point_count_;
  };
  for (auto& triangle : triangles)
    for (int& corner : triangle) corner = point(corner);
  for (const auto& loop : loops_) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto& row = rows_[loop[i]];
      const int next = rows_[loop[(i + 1) % loop.size()]].front();
      for (std::size_t k = 0; k + 1 < row.size(); ++k) triangles.push_back({row[k], row[k + 1], next});
    }
  }
  return triangles;
}

void Loop_nodes_3::open_tiny_loop(int node, std::vector<std::array<int, 3>>& triangles) const {
  const auto& row = rows_[node];
  const auto as_point = [&](std::size_t k) { return -1 - row[k]; };
  bool is_first = true;
  std::array<int, 2> side{};
  for (auto& triangle : triangles) {
    const auto corner = std::ranges::find(triangle, node);
    if (corner == triangle.end()) continue;
    const auto place = corner - triangle.begin();
    if (is_first) side = {triangle[(place + 1) % 3], triangle[(place + 2) % 3]};
    *corner = as_point(is_first ? 0 : row.size() - 1);
    is_first = false;
  }
  for (std::size_t k = 0; k + 1 < row.size(); ++k) triangles.push_back({as_point(k), as_point(k + 1), side[0]});
  triangles.push_back({as_point(row.size() - 1), as_point(0), side[1]});
}

}  // namespace mesecina
