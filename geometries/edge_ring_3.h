// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

namespace mesecina {

/// Walks once around the edge from the i-th to the j-th corner of a tetrahedron, calling use(cell) for each cell,
/// `cell` first; counterclockwise when one looks from the second corner to the first. Ends when `use` returns false or
/// where there is no neighbour (-1), and then returns false. `cells` have positive orientation and distinct corners;
/// O(ring).
template <class Use>
bool walk_around_edge(const std::vector<std::array<int, 4>>& cells, const std::vector<std::array<int, 4>>& neighbors,
                      int cell, int i, int j, const Use& use) {
  // The least of the other two places, or the other one, so that i, j, it and the last make an even permutation.
  constexpr std::array<std::array<int, 4>, 4> next_place{{{-1, 2, 3, 1}, {3, -1, 0, 2}, {1, 3, -1, 0}, {2, 0, 1, -1}}};
  const int a = cells[cell][i];
  const int b = cells[cell][j];
  int behind = cells[cell][next_place[i][j]];
  int current = cell;
  do {
    if (!use(current)) return false;
    int place = 0;
    int kept = 0;
    for (int k = 0; k < 4; ++k) {
      const int corner = cells[current][k];
      if (corner == behind) place = k;
      if (corner != behind && corner != a && corner != b) kept = corner;
    }
    behind = kept;
    current = neighbors[current][place];
  } while (current >= 0 && current != cell);
  return current == cell;
}

}  // namespace mesecina
