// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/progress.h"

namespace mesecina {

/// Topology-preserving filtration of a graph with edge values.
///
/// K_t is what is left after removing leaf edges (edges with an end that no other edge has) of value less than t, again
/// and again, but never the last edge of a component. Returns per edge the largest t with the edge in K_t: at least its
/// value, growing along every path from a leaf inwards, and +infinity for edges that are never removed: cycles, what
/// lies between them, and one edge of every tree. So the homotopy type of K_t is the same for all t.
///
/// edges: pairs of vertices in [0, vertex_count); values: one per edge, no NaN; names: one per edge, all different; of
/// two edges of the same value the one of the lesser name goes first, so that the order of the edges decides nothing.
/// O(n log n).
std::vector<double> topology_preserving(std::size_t vertex_count, std::span<const std::array<int, 2>> edges,
                                        std::span<const double> values, std::span<const std::array<int, 2>> names,
                                        Progress& progress);

/// Per vertex the largest value of its edges; `isolated` for vertices without one. O(n).
std::vector<double> largest_of_edges(std::size_t vertex_count, std::span<const std::array<int, 2>> edges,
                                     std::span<const double> values, double isolated);

}  // namespace mesecina
