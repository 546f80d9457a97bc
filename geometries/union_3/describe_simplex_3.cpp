// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/describe_simplex_3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_set>
#include <vector>

#include "geometries/edge_ring_3.h"
#include "geometries/primitives_2.h"
#include "geometries/primitives_3.h"
#include "geometries/union_3/power_center_3.h"

namespace mesecina {

namespace {

int place_of(const std::array<int, 4>& corners, int ball) {
  return static_cast<int>(std::ranges::find(corners, ball) - corners.begin());
}

bool has_all(const std::array<int, 4>& corners, std::span<const int> balls) {
  return std::ranges::all_of(balls, [&](int ball) { return std::ranges::count(corners, ball) > 0; });
}

/// All cells that have the ball, found from one to the next.
std::vector<int> cells_around(const Regular_3& regular, int ball) {
  std::vector<int> cells;
  if (regular.cell_of_ball[ball] < 0) return cells;
  cells.push_back(regular.cell_of_ball[ball]);
  std::unordered_set<int> known{cells.front()};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int cell = cells[i];
    for (int place = 0; place < 4; ++place) {
      if (regular.cells[cell][place] == ball) continue;
      const int next = regular.neighbors[cell][place];
      if (has_all(regular.cells[next], std::array{ball}) && known.insert(next).second) cells.push_back(next);
    }
  }
  return cells;
}

/// Of the finite cells that are given, in their order.
void add_power_centers(Primitive_set& set, const Regular_3& regular, const std::vector<int>& cells) {
  Box box;
  for (const int cell : cells)
    for (const int ball : regular.cells[cell]) box.add(regular.balls[ball].center);
  constexpr double part_of_cells = 1e-9;
  for (const int cell : cells) set.vertices.push_back(power_center(regular, cell, part_of_cells * box.diagonal()));
}

/// The polygon of power centers around the edge between two balls, if it is bounded.
void add_power_face(Primitive_set& set, const Regular_3& regular, int cell, int a, int b) {
  std::vector<int> ring;
  const auto& corners = regular.cells[cell];
  const bool is_whole = walk_around_edge(regular.cells, regular.neighbors, cell, place_of(corners, a),
                                         place_of(corners, b), [&](int current) {
                                           if (regular.is_infinite(current)) return false;
                                           ring.push_back(current);
                                           return true;
                                         });
  if (!is_whole) return;
  const int first = static_cast<int>(set.vertices.size());
  add_power_centers(set, regular, ring);
  set.polygon_offsets = {0, static_cast<int>(ring.size())};
  for (int v = first; v < static_cast<int>(set.vertices.size()); ++v) set.polygon_vertices.push_back(v);
}

/// The segment between the power centers of the two cells at a triangle, if both are finite.
void add_power_edge(Primitive_set& set, const Regular_3& regular, const std::vector<int>& cells) {
  if (cells.size() != 2 || regular.is_infinite(cells[0]) || regular.is_infinite(cells[1])) return;
  const int first = static_cast<int>(set.vertices.size());
  add_power_centers(set, regular, cells);
  set.segments.push_back({first, first + 1});
}

std::size_t count_neighbors(const Regular_3& regular, const std::vector<int>& cells, int ball) {
  std::unordered_set<int> others;
  for (const int cell : cells)
    for (const int corner : regular.cells[cell])
      if (corner >= 0 && corner != ball) others.insert(corner);
  return others.size();
}

}  // namespace

Element_description describe_simplex(const Regular_3& regular, std::span<const int> balls) {
  Element_description description;
  Primitive_set& dual = description.dual;
  dual.dimension = 3;
  std::vector<int> cells = cells_around(regular, balls[0]);
  std::erase_if(cells, [&](int cell) { return !has_all(regular.cells[cell], balls); });
  if (cells.empty()) return description;
  for (const int ball : balls) {
    dual.balls.push_back({static_cast<int>(dual.vertices.size()), regular.balls[ball].radius});
    dual.vertices.push_back(regular.balls[ball].center);
  }
  std::vector<Fact>& facts = description.facts;
  const Ball_3& first = regular.balls[balls[0]];
  if (balls.size() == 1) {
    facts.push_back({"ball", std::to_string(balls[0])});
    facts.push_back(fact("center", first.center));
    facts.push_back(fact("radius", first.radius));
    facts.push_back(
        {"neighbours in the regular triangulation", std::to_string(count_neighbors(regular, cells, balls[0]))});
    return description;
  }
  facts.push_back({"balls", enumeration(balls)});
  if (balls.size() == 2) {
    facts.push_back(fact("distance of the centers", distance(first.center, regular.balls[balls[1]].center)));
    add_power_face(dual, regular, cells.front(), balls[0], balls[1]);
  } else {
    add_power_edge(dual, regular, cells);
  }
  return description;
}

const char* kind_in_words(Simplex_kind_3 kind) {
  switch (kind) {
    case Simplex_kind_3::outside:
      return "outside of it";
    case Simplex_kind_3::singular:
      return "singular: part of nothing larger in it";
    case Simplex_kind_3::regular:
      return "on its boundary";
    default:
      return "in its interior";
  }
}

}  // namespace mesecina
