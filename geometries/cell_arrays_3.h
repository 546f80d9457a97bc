// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <compare>
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

/// Numbers of the cells of a triangulation of CGAL, by the places of their corners: what is near along a curve is near
/// in memory then, and they depend on the triangulation only, not on how it was made.
template <class Cell>
class Cell_numbers_3 {
 public:
  /// place_of(vertex): less than place_count. O(n) for few cells around each place.
  template <class Place_of>
  Cell_numbers_3(std::vector<Cell> cells, std::size_t place_count, const Place_of& place_of, Progress& progress)
      : cells_(std::move(cells)), corners_(cells_.size()), numbers_(cells_.size()) {
    // In the order of the cells, as that in which they lie in memory.
    parallel_for(cells_.size(), progress, [&](std::size_t c) {
      std::array<int, 4> places{};
      for (int i = 0; i < 4; ++i) places[i] = place_of(cells_[c]->vertex(i));
      corners_[c] = corner_order(places);
    });
    std::vector<int> first(place_count + 1, 0);
    for (const Corner_order_3& corners : corners_) ++first[corners.places[0] + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    struct Entry {
      std::array<int, 3> others;  ///< places of the corners but the least
      int cell;
      auto operator<=>(const Entry&) const = default;
    };
    std::vector<Entry> sorted(cells_.size());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto& places = corners_[c].places;
      sorted[next[places[0]]++] = {{places[1], places[2], places[3]}, static_cast<int>(c)};
    }
    parallel_for(place_count, progress, [&](std::size_t place) {
      std::sort(sorted.begin() + first[place], sorted.begin() + first[place + 1]);
      for (int number = first[place]; number < first[place + 1]; ++number) numbers_[sorted[number].cell] = number;
    });
  }

  std::size_t size() const { return cells_.size(); }
  /// Calls use(cell, its number, its corners) for each cell, on several threads.
  template <class Use>
  void for_each(Progress& progress, const Use& use) const {
    parallel_for(cells_.size(), progress, [&](std::size_t c) { use(cells_[c], numbers_[c], corners_[c]); });
  }

 private:
  std::vector<Cell> cells_;
  std::vector<Corner_order_3> corners_;
  std::vector<int> numbers_;
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
  const Cell_numbers_3<Cell> numbers(std::move(handles), place_of_point.size() + 1, place_of, progress);
  numbers.for_each(progress, [](const Cell& cell, int number, const Corner_order_3&) { cell->info() = number; });
  cells.resize(numbers.size());
  neighbors.resize(numbers.size());
  numbers.for_each(progress, [&](const Cell& cell, int number, const Corner_order_3& corners) {
    std::array<int, 4> points{};
    std::array<int, 4> across{};
    for (int i = 0; i < 4; ++i) {
      points[i] = cell->vertex(corners.from[i])->info();
      across[i] = cell->neighbor(corners.from[i])->info();
    }
    cells[number] = points;
    neighbors[number] = across;
  });
}

}  // namespace mesecina
