// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <map>
#include <random>
#include <set>

#include "core/primitives.h"

namespace mesecina {
namespace {

Primitive_set complex_in_space() {
  Primitive_set set;
  set.dimension = 3;
  set.is_complex = true;
  return set;
}

void add_polygon(Primitive_set& set, const std::vector<int>& corners) {
  if (set.polygon_offsets.empty()) set.polygon_offsets.push_back(0);
  set.polygon_vertices.insert(set.polygon_vertices.end(), corners.begin(), corners.end());
  set.polygon_offsets.push_back(static_cast<int>(set.polygon_vertices.size()));
}

/// With the vertices from 0 to the largest that is used.
Primitive_set with_vertices(Primitive_set set) {
  int largest = -1;
  for (const auto& triangle : set.triangles) largest = std::max(largest, *std::ranges::max_element(triangle));
  for (const auto& segment : set.segments) largest = std::max(largest, *std::ranges::max_element(segment));
  for (const int vertex : set.polygon_vertices) largest = std::max(largest, vertex);
  for (const int vertex : set.points) largest = std::max(largest, vertex);
  set.vertices.resize(static_cast<std::size_t>(largest + 1));
  return set;
}

Primitive_set of_triangles(std::vector<std::array<int, 3>> triangles) {
  Primitive_set set = complex_in_space();
  set.triangles = std::move(triangles);
  return with_vertices(set);
}

using Row = std::vector<bool>;

std::int64_t rank(std::vector<Row> rows) {
  std::int64_t result = 0;
  for (std::size_t column = 0; !rows.empty() && column < rows[0].size(); ++column) {
    const auto begin = rows.begin() + result;
    const auto pivot = std::find_if(begin, rows.end(), [&](const Row& row) { return row[column]; });
    if (pivot == rows.end()) continue;
    std::iter_swap(begin, pivot);
    for (auto row = begin + 1; row != rows.end(); ++row) {
      if (!(*row)[column]) continue;
      for (std::size_t i = 0; i < row->size(); ++i) (*row)[i] = (*row)[i] != (*begin)[i];
    }
    ++result;
  }
  return result;
}

/// From the definition: ranks of the boundary maps over the field of two elements.
Topology naive_topology(const Primitive_set& set) {
  std::vector<std::vector<int>> faces;
  for (const auto& triangle : set.triangles) faces.emplace_back(triangle.begin(), triangle.end());
  for (std::size_t i = 0; i < set.polygon_count(); ++i)
    faces.emplace_back(set.polygon(i).begin(), set.polygon(i).end());
  std::set<int> vertices(set.points.begin(), set.points.end());
  std::map<std::pair<int, int>, std::size_t> edges;
  const auto edge = [&](int a, int b) {
    vertices.insert({a, b});
    return edges.try_emplace(std::minmax(a, b), edges.size()).first->second;
  };
  std::vector<std::vector<std::size_t>> boundaries;
  for (const auto& [a, b] : set.segments) edge(a, b);
  for (const auto& face : faces) {
    boundaries.emplace_back();
    for (std::size_t i = 0; i < face.size(); ++i)
      boundaries.back().push_back(edge(face[i], face[(i + 1) % face.size()]));
  }
  std::vector<Row> second(faces.size(), Row(edges.size(), false));
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (const std::size_t side : boundaries[i]) second[i][side] = !second[i][side];
  std::vector<Row> first;
  for (const auto& [ends, number] : edges) {
    Row& row = first.emplace_back(set.vertices.size(), false);
    for (const int end : {ends.first, ends.second}) row[static_cast<std::size_t>(end)] = true;
  }
  const std::int64_t rank_1 = rank(first);
  const std::int64_t rank_2 = rank(second);
  const auto count = [](const auto& all) { return static_cast<std::int64_t>(all.size()); };
  return {count(vertices) - count(edges) + count(faces),
          {count(vertices) - rank_1, count(edges) - rank_1 - rank_2, count(faces) - rank_2}};
}

std::string text(const Topology& topology) {
  std::string result = std::to_string(topology.euler) + ":";
  for (const std::int64_t number : topology.betti) result += " " + std::to_string(number);
  return result;
}

/// Known, by the definition, and as computed.
void expect_betti(const Primitive_set& set, std::array<std::int64_t, 3> betti) {
  const auto computed = topology(set);
  ASSERT_TRUE(computed);
  EXPECT_EQ(text(*computed), text({betti[0] - betti[1] + betti[2], betti}));
  EXPECT_EQ(text(naive_topology(set)), text(*computed));
}

const std::vector<std::array<int, 3>> tetrahedron = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};

/// A torus, or with `is_klein` a Klein bottle, of n * n quadrangles, each of two triangles.
Primitive_set torus(int n, bool is_klein = false) {
  Primitive_set set = complex_in_space();
  const auto at = [&](int i, int j) { return i < n ? i * n + j % n : (is_klein ? (2 * n - j) % n : j % n); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      set.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      set.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return with_vertices(set);
}

TEST(Topology_in_space, OfSpheresAndDisks) {
  expect_betti(complex_in_space(), {0, 0, 0});
  expect_betti(of_triangles(tetrahedron), {1, 0, 1});
  auto open = tetrahedron;
  open.pop_back();
  expect_betti(of_triangles(open), {1, 0, 0});
  open.pop_back();
  open.pop_back();
  expect_betti(of_triangles(open), {1, 0, 0});
  Primitive_set cube = complex_in_space();
  for (const auto& face :
       {std::array{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}})
    add_polygon(cube, {face.begin(), face.end()});
  expect_betti(with_vertices(cube), {1, 0, 1});
  cube.triangles = {{0, 3, 5}, {0, 5, 6}, {0, 3, 6}, {3, 5, 6}};  // a tetrahedron within, at four of its vertices
  expect_betti(with_vertices(cube), {1, 3, 2});
}

TEST(Topology_in_space, OfSurfaces) {
  expect_betti(torus(3), {1, 2, 1});
  expect_betti(torus(5), {1, 2, 1});
  expect_betti(torus(5, true), {1, 2, 1});
  Primitive_set punctured = torus(4);
  punctured.triangles.pop_back();
  expect_betti(punctured, {1, 2, 0});
  // The projective plane of six vertices has a cycle over this field.
  expect_betti(of_triangles({{0, 1, 2},
                             {0, 2, 3},
                             {0, 3, 4},
                             {0, 4, 5},
                             {0, 5, 1},
                             {1, 2, 4},
                             {2, 3, 5},
                             {3, 4, 1},
                             {4, 5, 2},
                             {5, 1, 3}}),
               {1, 1, 1});
}

TEST(Topology_in_space, OfSpheresThatShareACell) {
  Primitive_set apart = of_triangles(tetrahedron);
  for (const auto& [a, b, c] : tetrahedron) apart.triangles.push_back({a + 4, b + 4, c + 4});
  expect_betti(with_vertices(apart), {2, 0, 2});
  const auto second_sphere_on = [](std::array<int, 4> corners) {
    std::set<std::array<int, 3>> triangles;
    for (const auto& triangle : tetrahedron) {
      triangles.insert(triangle);
      std::array<int, 3> other{};
      for (std::size_t i = 0; i < 3; ++i) other[i] = corners[static_cast<std::size_t>(triangle[i])];
      std::ranges::sort(other);
      triangles.insert(other);
    }
    return of_triangles({triangles.begin(), triangles.end()});
  };
  expect_betti(second_sphere_on({0, 4, 5, 6}), {1, 0, 2});
  expect_betti(second_sphere_on({0, 1, 4, 5}), {1, 0, 2});
  expect_betti(second_sphere_on({0, 1, 2, 4}), {1, 0, 2});
  // Opened each on its own side, and opened between them.
  Primitive_set open = second_sphere_on({0, 1, 4, 5});
  std::erase_if(open.triangles, [](const auto& t) { return t == std::array{1, 2, 3} || t == std::array{1, 4, 5}; });
  expect_betti(open, {1, 0, 0});
  Primitive_set without_wall = second_sphere_on({0, 1, 2, 4});
  std::erase(without_wall.triangles, std::array{0, 1, 2});
  expect_betti(without_wall, {1, 0, 1});
}

TEST(Topology_in_space, OfMixedCells) {
  Primitive_set set = of_triangles(tetrahedron);
  set.segments = {{0, 4}, {4, 1}, {0, 1}, {1, 0}, {5, 6}};
  set.points = {8, 0};
  expect_betti(with_vertices(set), {3, 1, 1});
  // The same cell twice is a sphere; a polygon that visits an edge twice is not bounded by it.
  expect_betti(of_triangles({{0, 1, 2}, {2, 0, 1}}), {1, 0, 1});
  Primitive_set slit = complex_in_space();
  add_polygon(slit, {0, 1, 2, 3, 2});
  expect_betti(with_vertices(slit), {1, 0, 0});
  add_polygon(slit, {0, 1, 2});
  expect_betti(with_vertices(slit), {1, 0, 1});
  Primitive_set folded = complex_in_space();
  add_polygon(folded, {0, 1, 2, 1});
  expect_betti(with_vertices(folded), {1, 0, 1});
}

TEST(Topology_in_space, OfWhatLiesInAPlaneIsThatInThePlane) {
  std::mt19937 random(11);
  constexpr int side = 12;
  for (int round = 0; round < 50; ++round) {
    Primitive_set set = complex_in_space();
    set.vertices.resize(side * side);
    for (int v = 0; v < side * (side - 1); ++v) {
      if (v % side == side - 1) continue;
      if (random() % 3 != 0) set.triangles.push_back({v, v + 1, v + side});
      if (random() % 3 != 0) set.triangles.push_back({v + 1, v + side + 1, v + side});
      if (random() % 5 == 0) set.segments.push_back({v + 1, v});
    }
    const Topology in_space = *topology(set);
    EXPECT_EQ(text(in_space), text(naive_topology(set)));
    set.dimension = 2;
    EXPECT_EQ(text(*topology(set)), text(in_space));
  }
}

TEST(Topology_in_space, NeedsAComplexOfKnownCells) {
  Primitive_set set = of_triangles(tetrahedron);
  EXPECT_TRUE(topology(set));
  set.balls = {{0, 1}};
  EXPECT_FALSE(topology(set));
  set.known_topology = Topology{7, {8, 9, 10}};
  EXPECT_EQ(topology(set), set.known_topology);
  Primitive_set planar = complex_in_space();
  add_polygon(planar, {0, 1, 2});
  EXPECT_TRUE(topology(with_vertices(planar)));
  planar.dimension = 2;
  EXPECT_FALSE(topology(with_vertices(planar)));
}

TEST(Topology_in_space, OfRandomComplexesIsThatOfTheDefinition) {
  std::mt19937 random(7);
  std::int64_t largest = 0;
  for (int round = 0; round < 1500; ++round) {
    const int vertex_count = 4 + round % 9;
    std::uniform_int_distribution<int> vertex(0, vertex_count - 1);
    std::uniform_int_distribution<int> number(0, 6 + round % 40);
    Primitive_set set = complex_in_space();
    set.vertices.resize(static_cast<std::size_t>(vertex_count));
    const auto corners = [&](std::size_t count) {
      std::vector<int> result;
      while (result.size() < count) {
        const int next = vertex(random);
        if (std::ranges::find(result, next) == result.end()) result.push_back(next);
      }
      return result;
    };
    for (int left = number(random); left > 0; --left) {
      const auto triangle = corners(3);
      set.triangles.push_back({triangle[0], triangle[1], triangle[2]});
    }
    for (int left = number(random); left > 0; --left) add_polygon(set, corners(4));
    for (int left = number(random) / 8; left > 0; --left) {
      const auto segment = corners(2);
      set.segments.push_back({segment[0], segment[1]});
    }
    if (round % 3 == 0) set.points = {vertex(random), vertex(random)};
    if (set.triangles.empty() && set.polygon_count() == 0) continue;
    ASSERT_EQ(text(*topology(set)), text(naive_topology(set))) << round;
    largest = std::max(largest, topology(set)->betti[2]);
  }
  EXPECT_GT(largest, 10);
}

/// The walls of n^3 cubes.
Primitive_set foam(int n) {
  Primitive_set set = complex_in_space();
  const int m = n + 1;
  const std::array steps = {m * m, m, 1};
  for (int x = 0; x < m; ++x) {
    for (int y = 0; y < m; ++y) {
      for (int z = 0; z < m; ++z) {
        const std::array inside = {x < n, y < n, z < n};
        const int corner = x * steps[0] + y * steps[1] + z;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t j = (i + 1) % 3;
          if (inside[i] && inside[j])
            add_polygon(set, {corner, corner + steps[i], corner + steps[i] + steps[j], corner + steps[j]});
        }
      }
    }
  }
  return with_vertices(set);
}

TEST(Topology_in_space, OfFoamsWhoseEdgesAllHaveManyFaces) {
  expect_betti(foam(1), {1, 0, 1});
  expect_betti(foam(2), {1, 0, 8});
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round) {
    Primitive_set all = foam(3);
    std::vector<bool> keep(all.polygon_count());
    for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = random() % 10 != 0;
    const Primitive_set some = select(all, keep);
    ASSERT_EQ(text(*topology(some)), text(naive_topology(some)));
  }
}

TEST(Topology_in_space, OfAHundredThousandFacesIsQuick) {
  const Primitive_set walls = foam(35);
  const auto begin = std::clock();
  EXPECT_EQ(topology(walls)->betti, (std::array<std::int64_t, 3>{1, 0, 35 * 35 * 35}));
  // Spheres around one common edge.
  Primitive_set book = complex_in_space();
  for (int i = 0; i < 100'000; i += 2) {
    const int u = 2 + i;
    const int v = u + 1;
    book.triangles.insert(book.triangles.end(), {{0, 1, u}, {0, 1, v}, {0, u, v}, {1, u, v}});
  }
  EXPECT_EQ(topology(with_vertices(book))->betti, (std::array<std::int64_t, 3>{1, 0, 50'000}));
  EXPECT_LT(std::clock() - begin, 20 * CLOCKS_PER_SEC) << "an optimized build takes about 0.1 s";
}

}  // namespace
}  // namespace mesecina
