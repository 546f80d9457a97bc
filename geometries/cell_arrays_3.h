// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "geometries/parallel.h"

namespace mesecina {

/// The cells of a triangulation of CGAL, of dimension 3, with numbers in its cells and vertices: their vertices by
/// their numbers, and the cells across from these. Vertices that are no points of the input have the number -1. Cells
/// are numbered by the place of the least of their points in an order: with one along a curve, what is near in space is
/// near in memory. `place_of_point`: per point, from 0. O(n).
template <class Triangulation>
void write_cells(Triangulation& triangulation, std::span<const int> place_of_point,
                 std::vector<std::array<int, 4>>& cells, std::vector<std::array<int, 4>>& neighbors,
                 Progress& progress) {
  std::vector<typename Triangulation::Cell_handle> handles;
  handles.reserve(triangulation.tds().number_of_cells());
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
    handles.push_back(cell);
  const auto none = static_cast<int>(place_of_point.size());
  std::vector<int> least(handles.size(), none);
  parallel_for(handles.size(), progress, [&](std::size_t c) {
    for (int i = 0; i < 4; ++i)
      if (const int point = handles[c]->vertex(i)->info(); point >= 0)
        least[c] = std::min(least[c], place_of_point[point]);
  });
  std::vector<int> next(place_of_point.size() + 2, 0);
  for (const int place : least) ++next[place + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t c = 0; c < handles.size(); ++c) handles[c]->info() = next[least[c]]++;
  cells.resize(handles.size());
  neighbors.resize(handles.size());
  parallel_for(handles.size(), progress, [&](std::size_t c) {
    const auto cell = handles[c];
    for (int i = 0; i < 4; ++i) {
      cells[cell->info()][i] = cell->vertex(i)->info();
      neighbors[cell->info()][i] = cell->neighbor(i)->info();
    }
  });
}

}  // namespace mesecina
