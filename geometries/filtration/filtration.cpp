// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/filtration/filtration.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace mesecina {

std::vector<double> topology_preserving(std::size_t vertex_count, std::span<const std::array<int, 2>> edges,
                                        std::span<const double> values, std::span<const std::array<int, 2>> names,
                                        Progress& progress) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // Per vertex the number of edges that are left and the exclusive-or of their numbers: with one left, it is that one.
  std::vector<int> degree(vertex_count, 0);
  std::vector<int> rest(vertex_count, 0);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const int v : edges[e]) {
      ++degree[v];
      rest[v] ^= static_cast<int>(e);
    }
  }
  struct Leaf {
    double value;
    int edge;
  };
  const auto goes_later = [names](const Leaf& a, const Leaf& b) {
    return a.value != b.value ? a.value > b.value : names[a.edge] > names[b.edge];
  };
  const auto is_last = [&](int e) { return degree[edges[e][0]] == 1 && degree[edges[e][1]] == 1; };
  std::vector<Leaf> leaves;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (degree[edges[e][0]] == 1 || degree[edges[e][1]] == 1) leaves.push_back({values[e], static_cast<int>(e)});
  std::priority_queue queue(goes_later, std::move(leaves));

  std::vector<double> final_values(edges.size(), infinity);
  double reached = -infinity;
  for (std::size_t step = 0; !queue.empty(); ++step) {
    if (step % 65536 == 0) progress.check();
    const auto [value, e] = queue.top();
    queue.pop();
    if (is_last(e)) continue;
    reached = std::max(reached, value);
    final_values[e] = reached;
    for (const int v : edges[e]) {
      --degree[v];
      rest[v] ^= e;
    }
    for (const int v : edges[e]) {
      if (degree[v] != 1) continue;
      const int next = rest[v];
      // An edge whose other end was a leaf already waits in the queue.
      const int other = edges[next][0] == v ? edges[next][1] : edges[next][0];
      if (degree[other] != 1) queue.push({values[next], next});
    }
  }
  return final_values;
}

std::vector<double> largest_of_edges(std::size_t vertex_count, std::span<const std::array<int, 2>> edges,
                                     std::span<const double> values, double isolated) {
  constexpr double none = -std::numeric_limits<double>::infinity();
  std::vector<double> largest(vertex_count, none);
  std::vector<bool> has_edge(vertex_count, false);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (const int v : edges[e]) {
      largest[v] = std::max(largest[v], values[e]);
      has_edge[v] = true;
    }
  }
  for (std::size_t v = 0; v < vertex_count; ++v)
    if (!has_edge[v]) largest[v] = isolated;
  return largest;
}

}  // namespace mesecina
