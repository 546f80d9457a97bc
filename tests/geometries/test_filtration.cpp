// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

#include "geometries/filtration/filtration.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

struct Graph_with_values {
  std::size_t vertex_count = 0;
  std::vector<Edge> edges;
  std::vector<double> values;
};

std::vector<double> filtration_of(const Graph_with_values& graph) {
  Progress progress;
  std::vector<Edge> names;
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) names.push_back({e, 0});
  return topology_preserving(graph.vertex_count, graph.edges, graph.values, names, progress);
}

std::vector<int> degrees(const Graph_with_values& graph, const std::vector<bool>& kept) {
  std::vector<int> degree(graph.vertex_count, 0);
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (!kept[e]) continue;
    for (const int v : graph.edges[e]) ++degree[v];
  }
  return degree;
}

/// K_t: of all leaf edges of value less than t the one of least value and index goes, until there is none.
std::vector<bool> remaining(const Graph_with_values& graph, double t) {
  std::vector<bool> kept(graph.edges.size(), true);
  for (;;) {
    const std::vector<int> degree = degrees(graph, kept);
    int next = -1;
    for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
      if (!kept[e] || !(graph.values[e] < t)) continue;
      const auto [v, w] = graph.edges[e];
      if ((degree[v] == 1) == (degree[w] == 1)) continue;  // no leaf, or the last edge of its component
      if (next == -1 || graph.values[e] < graph.values[next]) next = e;
    }
    if (next == -1) return kept;
    kept[next] = false;
  }
}

std::vector<double> filtration_by_definition(const Graph_with_values& graph) {
  std::set<double> thresholds(graph.values.begin(), graph.values.end());
  std::vector<double> result(graph.edges.size(), -infinity);
  for (const double t : thresholds) {
    const std::vector<bool> kept = remaining(graph, t);
    for (std::size_t e = 0; e < kept.size(); ++e)
      if (kept[e]) result[e] = std::max(result[e], t);
  }
  // Beyond all finite values nothing changes any more.
  const std::vector<bool> kept = remaining(graph, infinity);
  for (std::size_t e = 0; e < kept.size(); ++e)
    if (kept[e]) result[e] = infinity;
  return result;
}

/// Of what remains: components with an edge, and independent cycles.
std::array<int, 2> betti(const Graph_with_values& graph, const std::vector<bool>& kept) {
  std::vector<int> parent(graph.vertex_count);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  int used = 0;
  for (const int degree : degrees(graph, kept)) used += degree > 0;
  int components = used;
  int edges = 0;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (!kept[e]) continue;
    ++edges;
    const int v = root(graph.edges[e][0]);
    const int w = root(graph.edges[e][1]);
    if (v == w) continue;
    parent[v] = w;
    --components;
  }
  return {components, edges - used + components};
}

void expect_invariants(const Graph_with_values& graph, const std::vector<double>& result) {
  ASSERT_EQ(result.size(), graph.edges.size());
  for (std::size_t e = 0; e < result.size(); ++e) ASSERT_GE(result[e], graph.values[e]) << "edge " << e;
  const std::array<int, 2> expected = betti(graph, std::vector<bool>(graph.edges.size(), true));
  const std::set<double> distinct(result.begin(), result.end());
  const std::vector<double> thresholds(distinct.begin(), distinct.end());
  const std::size_t step = 1 + thresholds.size() / 40;
  for (std::size_t i = 0; i < thresholds.size(); i += step) {
    const double t = thresholds[i];
    std::vector<bool> kept(result.size());
    for (std::size_t e = 0; e < result.size(); ++e) kept[e] = result[e] >= t;
    ASSERT_EQ(betti(graph, kept), expected) << "t = " << t;
  }
}

void expect_by_definition(const Graph_with_values& graph) {
  const std::vector<double> result = filtration_of(graph);
  expect_invariants(graph, result);
  EXPECT_EQ(result, filtration_by_definition(graph));
}

/// Values that are distinct, or often equal, or sometimes infinite.
enum class Kind { distinct, ties, infinities };
constexpr Kind kinds[] = {Kind::distinct, Kind::ties, Kind::infinities};

void add_values(Graph_with_values& graph, Kind kind, Random& random) {
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    double value = kind == Kind::distinct ? random.uniform(-1, 1) : random.index(5);
    if (kind == Kind::infinities && random.chance(0.2)) value = random.chance(0.8) ? infinity : -infinity;
    graph.values.push_back(value);
  }
}

/// Each vertex after the first hangs on an earlier one, `reach` back at most, in random order and with shuffled names.
Graph_with_values tree(int size, int reach, Random& random) {
  Graph_with_values graph{static_cast<std::size_t>(size), {}, {}};
  const std::vector<int> names = random_permutation(size, random.next());
  for (int v = 1; v < size; ++v) {
    const int parent = v - 1 - random.index(std::min(v, reach));
    graph.edges.push_back(random.chance(0.5) ? Edge{names[v], names[parent]} : Edge{names[parent], names[v]});
  }
  std::vector<Edge> edges;
  for (const int e : random_permutation(size - 1, random.next())) edges.push_back(graph.edges[e]);
  graph.edges = edges;
  return graph;
}

Graph_with_values cycle(int size) {
  Graph_with_values graph{static_cast<std::size_t>(size), {}, {}};
  for (int v = 0; v < size; ++v) graph.edges.push_back({v, (v + 1) % size});
  return graph;
}

Graph_with_values together(const Graph_with_values& a, const Graph_with_values& b) {
  Graph_with_values result = a;
  const int shift = static_cast<int>(a.vertex_count);
  result.vertex_count += b.vertex_count;
  for (const Edge& edge : b.edges) result.edges.push_back({edge[0] + shift, edge[1] + shift});
  return result;
}

Graph_with_values random_graph(int size, int edge_count, Random& random) {
  std::set<Edge> edges;
  while (static_cast<int>(edges.size()) < edge_count) {
    const int v = random.index(size);
    const int w = random.index(size);
    if (v != w) edges.insert(sorted_edge({v, w}));
  }
  return {static_cast<std::size_t>(size), {edges.begin(), edges.end()}, {}};
}

void try_all_kinds(const std::function<Graph_with_values(Random&)>& make, int rounds) {
  for (const Kind kind : kinds) {
    for (int round = 0; round < rounds; ++round) {
      Random random(1000 * static_cast<int>(kind) + round);
      Graph_with_values graph = make(random);
      add_values(graph, kind, random);
      SCOPED_TRACE(testing::Message() << "kind " << static_cast<int>(kind) << ", round " << round);
      expect_by_definition(graph);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(Topology_preserving, small_examples) {
  EXPECT_TRUE(filtration_of({0, {}, {}}).empty());
  EXPECT_TRUE(filtration_of({3, {}, {}}).empty());
  EXPECT_EQ(filtration_of({2, {{0, 1}}, {5}}), (std::vector<double>{infinity}));
  // A path: the ends go first, the middle holds the outer ones up.
  EXPECT_EQ(filtration_of({4, {{0, 1}, {1, 2}, {2, 3}}, {1, 9, 2}}), (std::vector<double>{1, infinity, 2}));
  EXPECT_EQ(filtration_of({4, {{0, 1}, {1, 2}, {2, 3}}, {5, 1, 7}}), (std::vector<double>{5, 5, infinity}));
  // A triangle with a tail.
  EXPECT_EQ(filtration_of({5, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}}, {0, 0, 0, 1, 3}}),
            (std::vector<double>{infinity, infinity, infinity, 3.0, 3.0}));
  // Two triangles and the bridge between them.
  EXPECT_EQ(filtration_of({6, {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 3}}, {0, 0, 0, -5, 0, 0, 0}}),
            std::vector<double>(7, infinity));
}

TEST(Topology_preserving, of_random_trees) {
  try_all_kinds([](Random& random) { return tree(2 + random.index(30), 100, random); }, 60);
}

TEST(Topology_preserving, of_paths_and_stars) {
  try_all_kinds([](Random& random) { return tree(2 + random.index(30), 1, random); }, 60);
  try_all_kinds([](Random& random) { return tree(2 + random.index(30), 3, random); }, 60);
}

TEST(Topology_preserving, of_cycles_and_unicyclic_graphs) {
  try_all_kinds([](Random& random) { return cycle(3 + random.index(8)); }, 5);
  try_all_kinds(
      [](Random& random) {
        Graph_with_values graph = tree(5 + random.index(25), 100, random);
        const std::set<Edge> present = [&] {
          const std::vector<Edge> edges = sorted_edges(graph.edges);
          return std::set<Edge>(edges.begin(), edges.end());
        }();
        for (;;) {
          const int count = static_cast<int>(graph.vertex_count);
          const Edge edge = sorted_edge({random.index(count), random.index(count)});
          if (edge[0] == edge[1] || present.contains(edge)) continue;
          graph.edges.push_back(edge);
          return graph;
        }
      },
      60);
}

TEST(Topology_preserving, of_forests_with_isolated_vertices) {
  try_all_kinds(
      [](Random& random) {
        Graph_with_values graph = together(tree(2 + random.index(10), 100, random), tree(2, 1, random));
        graph = together(graph, {3, {}, {}});
        return together(graph, together(cycle(4), tree(2 + random.index(8), 2, random)));
      },
      40);
}

TEST(Topology_preserving, of_sparse_and_dense_graphs) {
  try_all_kinds([](Random& random) { return random_graph(20, 15 + random.index(10), random); }, 60);
  try_all_kinds([](Random& random) { return random_graph(9, 30, random); }, 10);
}

TEST(Topology_preserving, grows_along_every_path_from_a_leaf) {
  Random random(7);
  for (int round = 0; round < 30; ++round) {
    Graph_with_values graph = tree(200, 20, random);
    add_values(graph, Kind::distinct, random);
    const std::vector<double> result = filtration_of(graph);
    expect_invariants(graph, result);
    // Towards the one edge of infinite value, which is never removed, values never fall.
    std::vector<std::vector<int>> edges_of(graph.vertex_count);
    for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
      for (const int v : graph.edges[e]) edges_of[v].push_back(e);
    std::vector<int> queue;
    for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
      if (std::isinf(result[e])) queue.push_back(e);
    ASSERT_EQ(queue.size(), 1U);
    std::vector<bool> reached(graph.edges.size(), false);
    reached[queue[0]] = true;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      for (const int v : graph.edges[queue[next]]) {
        for (const int e : edges_of[v]) {
          if (reached[e]) continue;
          reached[e] = true;
          queue.push_back(e);
          EXPECT_LE(result[e], result[queue[next]]) << "edge " << e;
        }
      }
    }
    EXPECT_EQ(queue.size(), graph.edges.size());
  }
}

TEST(Topology_preserving, of_large_graphs) {
  Random random(8);
  Graph_with_values graph = tree(200000, 1000, random);
  for (int i = 0; i < 5; ++i) graph.edges.push_back({random.index(100000), 100000 + random.index(100000)});
  add_values(graph, Kind::distinct, random);
  expect_invariants(graph, filtration_of(graph));
}

TEST(Largest_of_edges, equals_the_definition) {
  Random random(9);
  for (const Kind kind : kinds) {
    Graph_with_values graph = random_graph(50, 40, random);
    add_values(graph, kind, random);
    const std::vector<double> result = largest_of_edges(graph.vertex_count, graph.edges, graph.values, -77);
    ASSERT_EQ(result.size(), graph.vertex_count);
    for (int v = 0; v < 50; ++v) {
      std::vector<double> own;
      for (std::size_t e = 0; e < graph.edges.size(); ++e)
        if (graph.edges[e][0] == v || graph.edges[e][1] == v) own.push_back(graph.values[e]);
      EXPECT_EQ(result[v], own.empty() ? -77 : *std::ranges::max_element(own)) << v;
    }
  }
  // Values below `isolated` count all the same.
  EXPECT_EQ(largest_of_edges(3, std::vector<Edge>{{0, 1}}, std::vector{-5.0}, 0),
            (std::vector<double>{-5.0, -5.0, 0.0}));
}

TEST(Filtration, depends_on_names_and_not_on_the_order_of_edges) {
  Progress progress;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random(seed);
    Graph_with_values graph = tree(30, 4, random);
    add_values(graph, Kind::ties, random);
    std::vector<Edge> names;
    for (const int name : random_permutation(static_cast<int>(graph.edges.size()), seed))
      names.push_back({name / 5, name % 5});
    const std::vector<double> expected =
        topology_preserving(graph.vertex_count, graph.edges, graph.values, names, progress);
    Graph_with_values other{graph.vertex_count, {}, {}};
    std::vector<Edge> other_names;
    std::vector<double> other_expected;
    for (const int e : random_permutation(static_cast<int>(graph.edges.size()), seed + 1)) {
      other.edges.push_back({graph.edges[e][1], graph.edges[e][0]});
      other.values.push_back(graph.values[e]);
      other_names.push_back(names[e]);
      other_expected.push_back(expected[e]);
    }
    EXPECT_EQ(topology_preserving(other.vertex_count, other.edges, other.values, other_names, progress), other_expected)
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace mesecina::test
