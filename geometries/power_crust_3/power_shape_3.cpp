// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "geometries/power_crust_3/power_crust_3.h"

namespace mesecina {

namespace {

/// An edge as a cell around it sees it.
struct Seen_edge {
  std::array<int, 2> balls{};
  bool has_gap = false;  ///< the cell is not in the shape
  bool has_triangle = false;
};

Simplex_kind_3 kind_of(bool has_larger, bool has_gap) {
  if (!has_larger) return Simplex_kind_3::singular;
  return has_gap ? Simplex_kind_3::regular : Simplex_kind_3::interior;
}

}  // namespace

Dual_3 power_shape(const Polar_balls_3& polar, Progress& progress) {
  progress.begin_stage("power shape");
  const Regular_3& regular = *polar.regular;
  const auto is_in = [&](int ball) { return ball >= 0 && polar.is_inner[ball] != 0; };
  Dual_3 shape;
  shape.regular = polar.regular;
  shape.is_flat.assign(regular.cells.size(), 0);
  shape.has_cell.reserve(regular.cells.size());
  for (const auto& corners : regular.cells) shape.has_cell.push_back(std::ranges::all_of(corners, is_in) ? 1 : 0);

  std::vector<Seen_edge> seen;
  std::vector<std::uint8_t> has_gap(regular.balls.size(), 0);
  for (int c = 0; c < static_cast<int>(regular.cells.size()); ++c) {
    constexpr int often = 4096;
    if (c % often == 0) progress.check();
    const auto& corners = regular.cells[c];
    const bool is_gap = shape.has_cell[c] == 0;
    for (int i = 0; i < 4; ++i) {
      if (is_gap && corners[i] >= 0) has_gap[corners[i]] = 1;
      for (int j = i + 1; j < 4; ++j) {
        if (!is_in(corners[i]) || !is_in(corners[j])) continue;
        const auto others = std::ranges::count_if(corners, is_in) - 2;
        seen.push_back({{std::min(corners[i], corners[j]), std::max(corners[i], corners[j])}, is_gap, others > 0});
      }
      // The normal of these corners points away from the i-th.
      constexpr std::array<std::array<int, 3>, 4> across{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
      const std::array<int, 3> balls{corners[across[i][0]], corners[across[i][1]], corners[across[i][2]]};
      const int next = regular.neighbors[c][i];
      if (next < c || !std::ranges::all_of(balls, is_in)) continue;
      const bool has_next = shape.has_cell[next] != 0;
      shape.triangles.push_back({balls, {c, next}, kind_of(!is_gap || has_next, is_gap || !has_next)});
    }
  }
  progress.check();
  std::ranges::sort(seen, {}, &Seen_edge::balls);
  std::vector<std::uint8_t> has_edge(regular.balls.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < seen.size(); begin = end) {
    Seen_edge edge = seen[begin];
    for (end = begin; end < seen.size() && seen[end].balls == edge.balls; ++end) {
      edge.has_gap = edge.has_gap || seen[end].has_gap;
      edge.has_triangle = edge.has_triangle || seen[end].has_triangle;
    }
    shape.edges.push_back({edge.balls, kind_of(edge.has_triangle, edge.has_gap)});
    for (const int ball : edge.balls) has_edge[ball] = 1;
  }
  shape.vertices.assign(regular.balls.size(), Simplex_kind_3::outside);
  for (int b = 0; b < static_cast<int>(regular.balls.size()); ++b)
    if (is_in(b) && regular.cell_of_ball[b] >= 0) shape.vertices[b] = kind_of(has_edge[b] != 0, has_gap[b] != 0);
  return shape;
}

}  // namespace mesecina
