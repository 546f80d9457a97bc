// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/point.h"
#include "core/progress.h"

namespace mesecina {

/// How points, the witnesses, see a few of them, the landmarks.
struct Witnesses_2 {
  /// Per witness the nearest landmark and the next; of landmarks equally far the lesser first; -1 where there is none.
  std::vector<std::array<int, 2>> nearest;
  std::vector<double> distances;  ///< per witness to the nearest landmark
  /// The witness farthest from all landmarks, of several the least; -1 without witnesses.
  int farthest = -1;

  /// Of the witness complex: two landmarks, the lesser first, that are the nearest two of some witness. All are edges
  /// of the Delaunay triangulation of the landmarks.
  struct Edge {
    std::array<int, 2> landmarks;
    int witnesses = 0;  ///< how many witnesses it has
    bool operator==(const Edge&) const = default;
  };
  std::vector<Edge> edges;  ///< ascending
};

/// O((n + m) log m) for n witnesses and m landmarks.
/// [L. Guibas, S. Oudot: Reconstruction using witness complexes, 2007]
Witnesses_2 witness(std::span<const Point_2> witnesses, std::span<const Point_2> landmarks, Progress& progress);

}  // namespace mesecina
