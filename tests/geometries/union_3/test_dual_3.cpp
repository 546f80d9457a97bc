// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "geometries/union_3/regular_3.h"
#include "tests/geometries/results.h"
#include "tests/geometries/union_3/axis_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"
#include "tests/geometries/union_3/power_oracle_3.h"

namespace mesecina::test {
namespace {

std::string names(Ball_set set) {
  std::string result = "{";
  for (const int i : members(set)) result += (result.size() > 1 ? " " : "") + std::to_string(i);
  return result + "}";
}

Dual_3 dual_of(const std::vector<Ball_3>& balls) {
  Progress progress;
  return dual_complex(std::make_shared<const Regular_3>(regular_triangulation(balls, progress)), progress);
}

/// All simplices of the complex, with their kinds; cells are interior.
std::map<Ball_set, Simplex_kind_3> simplices(const Dual_3& dual) {
  std::map<Ball_set, Simplex_kind_3> result;
  for (int i = 0; i < static_cast<int>(dual.vertices.size()); ++i)
    if (dual.vertices[i] != Simplex_kind_3::outside) result.emplace(bit(i), dual.vertices[i]);
  for (const Dual_3::Edge& e : dual.edges) result.emplace(set_of(e.balls), e.kind);
  for (const Dual_3::Triangle& t : dual.triangles) result.emplace(set_of(t.balls), t.kind);
  for (std::size_t i = 0; i < dual.has_cell.size(); ++i)
    if (dual.has_cell[i]) result.emplace(set_of(dual.regular->cells[i]), Simplex_kind_3::interior);
  return result;
}

/// By the definition of the kinds, from the simplices alone.
Simplex_kind_3 kind_of(Ball_set simplex, const std::vector<Ball_set>& all) {
  if (std::popcount(simplex) == 4) return Simplex_kind_3::interior;
  bool is_singular = true;
  bool is_surrounded = true;
  bool has_cell = false;
  for (const Ball_set other : all) {
    if ((other & simplex) != simplex) continue;
    if (other != simplex) is_singular = false;
    if (std::popcount(other) == 4) has_cell = true;
    if (std::popcount(other) == 3) {
      const auto cells = std::ranges::count_if(
          all, [&](Ball_set cell) { return std::popcount(cell) == 4 && (cell & other) == other; });
      if (cells != 2) is_surrounded = false;
    } else if (std::popcount(other) == 2) {
      is_surrounded = is_surrounded && std::ranges::any_of(all, [&](Ball_set cell) {
                        return std::popcount(cell) == 4 && (cell & other) == other;
                      });
    }
  }
  if (is_singular) return Simplex_kind_3::singular;
  return has_cell && is_surrounded ? Simplex_kind_3::interior : Simplex_kind_3::regular;
}

testing::AssertionResult has_topology_of_the_nerve(const std::vector<Ball_3>& balls) {
  const Topology expected = topology_of_simplices(nerve(power_minima(balls)));
  const Topology found = topology(dual_of(balls));
  if (found == expected) return testing::AssertionSuccess();
  return failure() << "dual complex " << to_text(found) << ", union " << to_text(expected);
}

testing::AssertionResult is_complex_of_the_definition(const std::vector<Ball_3>& balls) {
  const std::vector<Power_minimum> minima = power_minima(balls);
  const std::vector<Ball_set> expected = nerve(minima);
  const Dual_3 dual = dual_of(balls);
  const std::map<Ball_set, Simplex_kind_3> found = simplices(dual);
  std::size_t count = std::ranges::count_if(dual.vertices, [](auto kind) { return kind != Simplex_kind_3::outside; });
  count += dual.edges.size() + dual.triangles.size() + std::ranges::count(dual.has_cell, 1);
  if (count != found.size()) return failure() << "a simplex is there twice";
  std::vector<Ball_set> all;
  for (const auto& [simplex, kind] : found) all.push_back(simplex);
  for (const auto& [simplex, kind] : found) {
    if (kind == Simplex_kind_3::outside) return failure() << names(simplex) << " is listed and outside";
    if (!std::ranges::binary_search(expected, simplex)) return failure() << names(simplex) << " is not in the union";
    for (const int i : members(simplex))
      if (simplex != bit(i) && !found.contains(simplex & ~bit(i)))
        return failure() << "a face of " << names(simplex) << " is missing";
    if (kind != kind_of(simplex, all))
      return failure() << names(simplex) << " is of kind " << static_cast<int>(kind) << ", by definition "
                       << static_cast<int>(kind_of(simplex, all));
  }
  for (std::size_t i = 0; i < dual.has_cell.size(); ++i) {
    if (!dual.has_cell[i]) {
      if (dual.is_flat[i]) return failure() << "a cell outside is flat";
      continue;
    }
    const Ball_set cell = set_of(dual.regular->cells[i]);
    const auto it = std::ranges::find(minima, cell, &Power_minimum::simplex);
    if (it == minima.end()) return failure() << "cell " << names(cell) << " is not regular";
    if (it->is_on_spheres != static_cast<bool>(dual.is_flat[i]))
      return failure() << "cell " << names(cell) << " is flat " << it->is_on_spheres;
  }
  for (const Dual_3::Triangle& t : dual.triangles) {
    std::array<const std::array<int, 4>*, 2> cells{};
    for (int i = 0; i < 2; ++i) {
      cells[i] = &dual.regular->cells[t.cells[i]];
      for (const int ball : t.balls)
        if (std::ranges::find(*cells[i], ball) == cells[i]->end()) return failure() << "wrong cells of a triangle";
    }
    // The normal points to the ball of the second cell, away from that of the first.
    const auto& b = dual.regular->balls;
    for (int i = 0; i < 2; ++i)
      for (const int ball : *cells[i])
        if (ball >= 0 && std::ranges::find(t.balls, ball) == t.balls.end() &&
            orientation(b[t.balls[0]], b[t.balls[1]], b[t.balls[2]], b[ball]) != (i == 1 ? 1 : -1))
          return failure() << "the cells of triangle " << names(set_of(t.balls)) << " are exchanged";
  }
  if (is_general(minima))
    for (const Ball_set simplex : expected)
      if (!found.contains(simplex)) return failure() << names(simplex) << " is missing";
  return testing::AssertionSuccess();
}

TEST(Power_oracle_3, knows_the_topology_of_simple_unions) {
  for (const Named_balls& set : difficult_ball_sets()) {
    SCOPED_TRACE(set.name);
    EXPECT_EQ(topology_of_simplices(nerve(power_minima(set.balls))).betti, set.betti);
  }
}

TEST(Dual_3, knows_the_topology_of_simple_unions) {
  for (const Named_balls& set : difficult_ball_sets()) {
    SCOPED_TRACE(set.name);
    EXPECT_EQ(topology(dual_of(set.balls)).betti, set.betti);
  }
}

TEST(Dual_3, has_the_topology_of_the_union) { expect_of_balls(repetitions(100), has_topology_of_the_nerve); }

TEST(Dual_3, is_the_complex_of_the_definition) { expect_of_balls(repetitions(100), is_complex_of_the_definition); }

}  // namespace
}  // namespace mesecina::test
