// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/point.h"

namespace mesecina {

/// 0 ... points.size() - 1 in an order in which inserting them into a triangulation, each from where the last one lies,
/// is quick for all inputs: rounds of growing size, each along a Hilbert curve. The same on every run. O(n log n).
/// [N. Amenta, S. Choi, G. Rote: Incremental constructions con BRIO, 2003]
std::vector<std::size_t> insertion_order(std::span<const Point_3> points);

/// Sorts `indices` of points along a Hilbert curve: what is near in space becomes near in memory. O(n log n).
void sort_along_hilbert_curve(std::span<const Point_3> points, std::vector<std::size_t>& indices);

}  // namespace mesecina
