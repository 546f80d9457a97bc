// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/point.h"
#include "core/progress.h"

namespace mesecina {

/// 0 ... count - 1 in an order in which inserting points that are numbered along a curve into a triangulation, each
/// from where the last one lies, is quick for all inputs: rounds of growing size, each along the curve; the last has
/// seven of eight. The same on every run. O(n). [N. Amenta, S. Choi, G. Rote: Incremental constructions con BRIO, 2003]
std::vector<int> insertion_order_along_curve(std::size_t count);

/// Sorts `indices` of points along a Hilbert curve: what is near in space becomes near in memory. O(n log n).
/// `progress` says on how many threads.
void sort_along_hilbert_curve(std::span<const Point_3> points, std::vector<std::size_t>& indices,
                              const Progress& progress);

}  // namespace mesecina
