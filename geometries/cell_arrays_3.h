// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "geometries/parallel.h"

namespace mesecina {

/// Where the corners of a cell of CGAL go, so that it does not depend on how the cell came to be: by their places in an
/// order, but for the last two, which keep the cell's orientation.
struct Corner_order_3 {
  std::array<int, 4> places;         ///< of the corners
  std::array<std::uint8_t, 4> from;  ///< per corner its index in CGAL's cell
};

/// `places`: of the vertices of the cell.
inline Corner_order_3 corner_order(const std::array<int, 4>& places) {
  std::array<std::uint8_t, 4> from{0, 1, 2, 3};
  bool is_even = true;
  const auto order = [&](int i, int j) {
    if (places[from[j]] >= places[from[i]]) return;
    std::swap(from[i], from[j]);
    is_even = !is_even;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  if (!is_even) std::swap(from[2], from[3]);
  return {{places[from[0]], places[from[1]], places[from[2]], places[from[3]]}, from};
}

/// Cells of a triangulation of CGAL sorted by the places of their corners: what is near along a curve is near in memory
/// then, and the order depends on the triangulation only, not on how it was made.
template <class Cell>
class Sorted_cells_3 {
 public:
  /// place_of(vertex): less than place_count. O(n) for few cells around each place.
  template <class Place_of>
  Sorted_cells_3(std::vector<Cell> cells, std::size_t place_count, const Place_of& place_of, Progress& progress)
      : cells_(std::move(cells)), corners_(cells_.size()), order_(cells_.size()) {
    parallel_for(cells_.size(), progress, [&](std::size_t c) {
      std::array<int, 4> places{};
      for (int i = 0; i < 4; ++i) places[i] = place_of(cells_[c]->vertex(i));
      corners_[c] = corner_order(places);
    });
    std::vector<int> first(place_count + 1, 0);
    for (const Corner_order_3& corners : corners_) ++first[corners.places[0] + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t c = 0; c < cells_.size(); ++c) order_[next[corners_[c].places[0]]++] = static_cast<int>(c);
    parallel_for(place_count, progress, [&](std::size_t place) {
      const auto begin = order_.begin() + first[place];
      const auto end = order_.begin() + first[place + 1];
      std::stable_sort(begin, end, [&](int c, int d) { return corners_[c].places < corners_[d].places; });
    });
  }

  std::size_t size() const { return order_.size(); }
  Cell cell(std::size_t number) const { return cells_[order_[number]]; }
  const Corner_order_3& corners(std::size_t number) const { return corners_[order_[number]]; }

 private:
  std::vector<Cell> cells_;
  std::vector<Corner_order_3> corners_;
  std::vector<int> order_;
};

/// The cells of a triangulation of CGAL, of dimension 3, with numbers in its cells and vertices: their vertices by
/// their numbers, and the cells across from these, sorted by the places of the vertices. Vertices that are no points of
/// the input have the number -1. `place_of_point`: per point, from 0. O(n).
template <class Triangulation>
void write_cells(Triangulation& triangulation, std::span<const int> place_of_point,
                 std::vector<std::array<int, 4>>& cells, std::vector<std::array<int, 4>>& neighbors,
                 Progress& progress) {
  using Cell = typename Triangulation::Cell_handle;
  std::vector<Cell> handles;
  handles.reserve(triangulation.tds().number_of_cells());
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
    handles.push_back(cell);
  const auto none = static_cast<int>(place_of_point.size());
  const auto place_of = [&](const typename Triangulation::Vertex_handle& vertex) {
    const int point = vertex->info();
    return point < 0 ? none : place_of_point[point];
  };
  const Sorted_cells_3<Cell> sorted(std::move(handles), place_of_point.size() + 1, place_of, progress);
  parallel_for(sorted.size(), progress, [&](std::size_t c) { sorted.cell(c)->info() = static_cast<int>(c); });
  cells.resize(sorted.size());
  neighbors.resize(sorted.size());
  parallel_for(sorted.size(), progress, [&](std::size_t c) {
    const Cell cell = sorted.cell(c);
    const auto& from = sorted.corners(c).from;
    for (int i = 0; i < 4; ++i) {
      cells[c][i] = cell->vertex(from[i])->info();
      neighbors[c][i] = cell->neighbor(from[i])->info();
    }
  });
}

}  // namespace mesecina
