// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/dual_2/dual_2.h"
#include "tests/geometries/results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "tests/geometries/union/disk_sets.h"
#include "tests/geometries/union/power_oracle.h"

namespace mesecina::test {
namespace {

const char* name(Dual_kind kind) {
  constexpr std::array names{"outside", "singular", "regular", "interior"};
  return names[static_cast<std::size_t>(kind)];
}

struct Expected_edge {
  int left = -1;   ///< triangle on the left of the edge from the lesser to the greater disk
  int right = -1;  ///< -1 outside of the hull
};

/// Least power distances on the faces of the power diagram, by which alone it is said what is in the dual complex.
struct Face_minima {
  std::vector<std::optional<Rational>> cells;
  std::vector<std::optional<Rational>> triangles;
  std::vector<Rational> orthogonal_powers;  ///< per triangle
  std::map<Edge, std::optional<Rational>> edges;
};

Face_minima face_minima(const Regular_2& r) {
  const Power_oracle oracle(exact_disks(*r.balls));
  Face_minima result;
  for (int i = 0; i < static_cast<int>(r.balls->size()); ++i) result.cells.push_back(oracle.minimum_on_cell(i));
  const auto add_edge = [&](Edge edge) {
    const Edge key = sorted_edge(edge);
    if (!result.edges.contains(key)) result.edges[key] = oracle.minimum_on_edge(key[0], key[1]);
  };
  for (const auto& [a, b, c] : r.triangles) {
    result.triangles.push_back(oracle.minimum_on_vertex(a, b, c));
    result.orthogonal_powers.push_back(oracle.orthogonal_power(a, b, c));
    for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) add_edge(edge);
  }
  for (std::size_t i = 1; i < r.line.size(); ++i) add_edge({r.line[i - 1], r.line[i]});
  return result;
}

/// Every simplex by definition, and the kinds by looking around.
testing::AssertionResult is_dual_complex(const std::shared_ptr<const Regular_2>& r, const Face_minima& minima,
                                         double alpha) {
  Progress progress;
  const Dual_2 dual = dual_complex(r, alpha, progress);
  if (dual.regular != r || dual.alpha != alpha) return failure() << "it is of something else";
  if (dual.has_triangle.size() != r->triangles.size() || dual.is_flat.size() != r->triangles.size() ||
      dual.vertices.size() != r->balls->size())
    return failure() << "sizes are wrong";
  const Rational limit(alpha);
  const auto meets = [&](const std::optional<Rational>& minimum) { return minimum && *minimum <= limit; };

  std::map<Edge, Expected_edge> edges;
  for (int t = 0; t < static_cast<int>(r->triangles.size()); ++t) {
    const auto& [a, b, c] = r->triangles[t];
    const bool is_in = meets(minima.triangles[t]);
    if ((dual.has_triangle[t] != 0) != is_in)
      return failure() << "triangle " << a << " " << b << " " << c << " is " << (is_in ? "not " : "") << "in it";
    const bool is_flat = minima.orthogonal_powers[t] == limit;
    if ((dual.is_flat[t] != 0) != is_flat)
      return failure() << "triangle " << a << " " << b << " " << c << " is " << (is_flat ? "not " : "") << "flat";
    for (int i = 0; i < 3; ++i) {
      const auto [p, q] = r->edge(t, i);
      (p < q ? edges[{p, q}].left : edges[{q, p}].right) = t;
    }
  }
  for (std::size_t i = 1; i < r->line.size(); ++i) edges[sorted_edge({r->line[i - 1], r->line[i]})] = {};

  const auto is_in = [&](int t) { return t != -1 && dual.has_triangle[t] != 0; };
  std::set<Edge> seen;
  for (const Dual_edge& e : dual.edges) {
    const Edge key = sorted_edge({e.a, e.b});
    if (!seen.insert(key).second) return failure() << "edge " << e.a << " " << e.b << " is there twice";
    const auto it = edges.find(key);
    if (it == edges.end()) return failure() << "edge " << e.a << " " << e.b << " is not of the triangulation";
    const auto [left, right] = it->second;
    if (e.left != (e.a < e.b ? left : right) || e.right != (e.a < e.b ? right : left))
      return failure() << "edge " << e.a << " " << e.b << " has other triangles beside it";
    const int sides = (is_in(left) ? 1 : 0) + (is_in(right) ? 1 : 0);
    const Dual_kind kind = sides == 0 ? Dual_kind::singular : sides == 1 ? Dual_kind::regular : Dual_kind::interior;
    if (e.kind != kind) return failure() << "edge " << e.a << " " << e.b << " is " << name(e.kind);
  }
  std::vector<int> edge_count(r->balls->size(), 0);
  for (const auto& [key, beside] : edges) {
    const bool expected = meets(minima.edges.at(key));
    if (seen.contains(key) != expected)
      return failure() << "edge " << key[0] << " " << key[1] << " is " << (expected ? "not " : "") << "in it";
    if (!expected && (is_in(beside.left) || is_in(beside.right))) return failure() << "it is not closed under faces";
    if (!expected) continue;
    ++edge_count[key[0]];
    ++edge_count[key[1]];
  }
  for (int i = 0; i < static_cast<int>(r->balls->size()); ++i) {
    Dual_kind kind = Dual_kind::outside;
    if (!r->is_hidden[i] && meets(minima.cells[i])) {
      bool is_surrounded = r->dimension == 2;
      for (int t = 0; t < static_cast<int>(r->triangles.size()); ++t) {
        if (std::ranges::find(r->triangles[t], i) == r->triangles[t].end()) continue;
        if (!is_in(t)) is_surrounded = false;
        const int corner = r->corner_of(t, i);
        if (r->neighbors[t][(corner + 1) % 3] == -1 || r->neighbors[t][(corner + 2) % 3] == -1) is_surrounded = false;
      }
      kind = is_surrounded ? Dual_kind::interior : edge_count[i] > 0 ? Dual_kind::regular : Dual_kind::singular;
    } else if (edge_count[i] > 0) {
      return failure() << "vertex " << i << " has edges and is outside by definition";
    }
    if (dual.vertices[i] != kind)
      return failure() << "vertex " << i << " is " << name(dual.vertices[i]) << ", not " << name(kind);
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult is_dual_complex_for_several_alpha(const std::shared_ptr<const Balls_2>& balls) {
  Progress progress;
  const auto r = std::make_shared<const Regular_2>(regular_triangulation(balls, progress));
  const Face_minima minima = face_minima(*r);
  double square = 0;
  for (const double radius : balls->radii) square = std::max(square, radius * radius);
  // With 9 radii 4 become 5, and 5 become 4: positions stay special.
  for (const double alpha : {0.0, 9.0, -9.0, 0.3 * square, -0.3 * square}) {
    if (auto result = is_dual_complex(r, minima, alpha); !result) return result << " (alpha " << alpha << ")";
  }
  return testing::AssertionSuccess();
}

TEST(Dual_2, equals_the_definition) { expect_of_given_balls(repetitions(25), is_dual_complex_for_several_alpha); }

TEST(Dual_2, equals_the_definition_for_circumscribed_disks) {
  expect_of_circumscribed_balls(repetitions(9), is_dual_complex_for_several_alpha);
}

TEST(Dual_2, of_simple_sets) {
  const auto dual_of = [](std::vector<Disk_2> disks) {
    Progress progress;
    const auto balls = std::make_shared<const Balls_2>(given_balls(disks));
    return dual_complex(std::make_shared<const Regular_2>(regular_triangulation(balls, progress)), 0, progress);
  };
  const Dual_2 one = dual_of({{{1, 2}, 3}});
  EXPECT_EQ(one.vertices, (std::vector{Dual_kind::singular}));
  EXPECT_EQ(topology(one).betti[0], 1);
  EXPECT_TRUE(dual_of({{{0, 0}, 1}, {{5, 0}, 1}}).edges.empty());
  EXPECT_EQ(dual_of({{{0, 0}, 1}, {{3, 0}, 2}}).edges.size(), 1U);
  const Dual_2 flat = dual_of({{{5, 0}, 5}, {{-3, 4}, 5}, {{-3, -4}, 5}});
  EXPECT_EQ(flat.has_triangle, (std::vector<std::uint8_t>{1}));
  EXPECT_EQ(flat.is_flat, (std::vector<std::uint8_t>{1}));
  const Dual_2 hole = dual_of({{{0, 0}, 5.5}, {{10, 0}, 5.5}, {{5, 8}, 5}});
  EXPECT_EQ(hole.has_triangle, (std::vector<std::uint8_t>{0}));
  EXPECT_EQ(topology(hole).betti[1], 1);
  EXPECT_EQ(topology(hole).euler, 0);
}

}  // namespace
}  // namespace mesecina::test
