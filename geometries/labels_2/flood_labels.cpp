// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometries/labels_2/labels_2.h"

namespace mesecina {

namespace {

constexpr std::uint8_t unknown = 2;
constexpr std::size_t triangles_between_checks = 1 << 16;

/// Every edge (each once; those of the hull too) that does not do what the crust says.
std::vector<std::array<int, 2>> find_conflicts(const Delaunay_2& triangulation, const Crust_2& crust,
                                               const std::vector<std::uint8_t>& is_inner) {
  std::vector<std::array<int, 2>> conflicts;
  for (int t = 0; t < static_cast<int>(triangulation.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!triangulation.edge_is_listed(t, i)) continue;
      const int u = triangulation.neighbors[t][i];
      const bool changes = is_inner[t] != (u < 0 ? 0 : is_inner[u]);
      if (changes != crust.contains(t, i)) conflicts.push_back(triangulation.edge(t, i));
    }
  }
  return conflicts;
}

std::vector<std::uint8_t> flood_in_order(const Delaunay_2& triangulation, const Crust_2& crust, Progress& progress) {
  const int count = static_cast<int>(triangulation.triangles.size());
  std::vector<std::uint8_t> is_inner(count, unknown);
  std::vector<int> queue;
  queue.reserve(count);
  const auto reach = [&](int t, std::uint8_t label) {
    is_inner[t] = label;
    queue.push_back(t);
  };
  for (int t = 0; t < count; ++t)
    for (int i = 0; i < 3; ++i)
      if (triangulation.neighbors[t][i] < 0 && is_inner[t] == unknown) reach(t, crust.contains(t, i) ? 1 : 0);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    if (next % triangles_between_checks == 0) progress.check();
    const int t = queue[next];
    for (int i = 0; i < 3; ++i) {
      const int u = triangulation.neighbors[t][i];
      if (u >= 0 && is_inner[u] == unknown) reach(u, is_inner[t] ^ (crust.contains(t, i) ? 1 : 0));
    }
  }
  return is_inner;
}

/// How sure it is whether an edge belongs to the crust: |log(cot cot)|, infinite where one angle is not acute.
double certainty(const Delaunay_2& triangulation, int t, int i) {
  const auto cotangent = [&](int triangle, int corner) {
    const auto [a, b] = triangulation.edge(triangle, corner);
    const Point_2& p = triangulation.points[a];
    const Point_2& q = triangulation.points[b];
    const Point_2& r = triangulation.points[triangulation.triangles[triangle][corner]];
    const double cross = (p.x - r.x) * (q.y - r.y) - (p.y - r.y) * (q.x - r.x);
    return ((p.x - r.x) * (q.x - r.x) + (p.y - r.y) * (q.y - r.y)) / cross;
  };
  const int u = triangulation.neighbors[t][i];
  // A hull edge has one Voronoi vertex at infinity; its other one decides: inside or not.
  if (u < 0) return std::numeric_limits<double>::infinity();
  const double product = cotangent(t, i) * cotangent(u, triangulation.mirror_corner(t, i));
  return product > 0 ? std::abs(std::log(product)) : std::numeric_limits<double>::infinity();
}

/// Union-find that also knows whether an element differs from its root.
class Parity_forest {
 public:
  explicit Parity_forest(std::size_t size) : parent_(size), differs_(size, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  std::pair<int, std::uint8_t> find(int element) {
    int root = element;
    std::uint8_t parity = 0;
    while (parent_[root] != root) {
      parity ^= differs_[root];
      root = parent_[root];
    }
    const std::uint8_t result = parity;
    while (parent_[element] != root && parent_[element] != element) {
      const int next = parent_[element];
      const std::uint8_t step = differs_[element];
      parent_[element] = root;
      differs_[element] = parity;
      parity ^= step;
      element = next;
    }
    return {root, result};
  }
  void unite(int a, int b, std::uint8_t differ) {
    const auto [root_a, parity_a] = find(a);
    const auto [root_b, parity_b] = find(b);
    if (root_a == root_b) return;
    parent_[root_a] = root_b;
    differs_[root_a] = parity_a ^ parity_b ^ differ;
  }

 private:
  std::vector<int> parent_;
  std::vector<std::uint8_t> differs_;
};

std::vector<std::uint8_t> flood_surest_first(const Delaunay_2& triangulation, const Crust_2& crust,
                                             Progress& progress) {
  struct Ranked_edge {
    double certainty;
    int triangle;
    int corner;
  };
  const int count = static_cast<int>(triangulation.triangles.size());
  std::vector<Ranked_edge> edges;
  edges.reserve(3 * triangulation.triangles.size() / 2);
  for (int t = 0; t < count; ++t) {
    if (t % triangles_between_checks == 0) progress.check();
    for (int i = 0; i < 3; ++i)
      if (triangulation.edge_is_listed(t, i)) edges.push_back({certainty(triangulation, t, i), t, i});
  }
  // Many are equally sure; their end points decide, so that nothing depends on the order of the triangles.
  const auto sorted_ends = [&](const Ranked_edge& edge) {
    const auto [p, q] = triangulation.edge(edge.triangle, edge.corner);
    return std::pair(std::min(p, q), std::max(p, q));
  };
  std::ranges::sort(edges, [&](const Ranked_edge& a, const Ranked_edge& b) {
    progress.check();
    return a.certainty != b.certainty ? a.certainty > b.certainty : sorted_ends(a) < sorted_ends(b);
  });
  const int outside = count;
  Parity_forest forest(triangulation.triangles.size() + 1);
  for (const Ranked_edge& edge : edges) {
    progress.check();
    const int u = triangulation.neighbors[edge.triangle][edge.corner];
    forest.unite(edge.triangle, u < 0 ? outside : u, crust.contains(edge.triangle, edge.corner) ? 1 : 0);
  }
  std::vector<std::uint8_t> is_inner(count);
  const auto [root, outside_parity] = forest.find(outside);
  for (int t = 0; t < count; ++t) is_inner[t] = forest.find(t).second ^ outside_parity;
  return is_inner;
}

}  // namespace

Labels_2 flood_labels(const Delaunay_2& triangulation, const Crust_2& crust, Progress& progress) {
  Labels_2 labels;
  labels.is_inner = flood_in_order(triangulation, crust, progress);
  labels.conflicts = find_conflicts(triangulation, crust, labels.is_inner);
  if (!labels.conflicts.empty()) {
    labels.is_inner = flood_surest_first(triangulation, crust, progress);
    labels.conflicts = find_conflicts(triangulation, crust, labels.is_inner);
  }
  return labels;
}

Labels_2 outline_labels(const Delaunay_2& triangulation, const Voronoi_2& voronoi, const Crust_2& crust,
                        const Outline_2& outline, Progress& progress) {
  Labels_2 labels;
  labels.is_inner = is_inside(outline, voronoi.vertices, progress);
  labels.conflicts = find_conflicts(triangulation, crust, labels.is_inner);
  return labels;
}

}  // namespace mesecina
