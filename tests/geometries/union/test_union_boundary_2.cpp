// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_2/union_boundary_2.h"
#include "tests/geometries/results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tests/geometries/union/disk_sets.h"
#include "tests/geometries/union/union_oracle.h"

namespace mesecina::test {
namespace {

std::string list_text(std::span<const int> numbers) {
  std::string result;
  for (const int n : numbers) result += (result.empty() ? "" : " ") + std::to_string(n);
  return "{" + result + "}";
}

/// Per vertex of the boundary that of the oracle with the same circles through it; where there are two, the nearer one.
testing::AssertionResult match_vertices(const Union_boundary_2& boundary, const Union_oracle& oracle,
                                        std::vector<int>& match) {
  if (boundary.vertices.size() != oracle.vertices.size())
    return failure() << boundary.vertices.size() << " vertices, not " << oracle.vertices.size();
  if (boundary.samples.size() != boundary.vertices.size() ||
      boundary.source_offsets.size() != boundary.vertices.size() + 1)
    return failure() << "sizes are wrong";
  std::vector<bool> taken(oracle.vertices.size(), false);
  const auto is_hidden = [&](int i) { return boundary.dual->regular->is_hidden[i] != 0; };
  std::vector<std::vector<int>> expected_sources;
  for (const Oracle_vertex& w : oracle.vertices) {
    expected_sources.push_back(w.sources);
    std::erase_if(expected_sources.back(), is_hidden);
  }
  for (int v = 0; v < static_cast<int>(boundary.vertices.size()); ++v) {
    const auto sources = boundary.sources_of(v);
    int best = -1;
    for (int w = 0; w < static_cast<int>(oracle.vertices.size()); ++w) {
      if (taken[w] || !std::ranges::equal(expected_sources[w], sources)) continue;
      if (best == -1 || distance(oracle.vertices[w].point(), boundary.vertices[v]) <
                            distance(oracle.vertices[best].point(), boundary.vertices[v]))
        best = w;
    }
    if (best == -1) {
      std::string all;
      for (const auto& numbers : expected_sources) all += list_text(numbers);
      return failure() << "vertex " << v << " (" << boundary.vertices[v].x << ", " << boundary.vertices[v].y
                       << ") on circles " << list_text(sources) << ", but they are on " << all;
    }
    taken[best] = true;
    match.push_back(best);
    const Oracle_vertex& expected = oracle.vertices[best];
    // Where circles nearly touch, rounding by u moves a vertex by about u over the steepness, at most by its root.
    const double tolerance = oracle.scale * std::min(1e-7, 1e-14 / std::max(expected.steepness, 1e-300) + 1e-14);
    if (!(distance(expected.point(), boundary.vertices[v]) <= tolerance))
      return failure() << "vertex " << v << " is (" << boundary.vertices[v].x << ", " << boundary.vertices[v].y
                       << "), not (" << expected.point().x << ", " << expected.point().y << ")";
  }
  return testing::AssertionSuccess();
}

/// The vertex of an edge of the dual complex on its left or right: where its circles meet there, if that is on the
/// boundary.
testing::AssertionResult edges_have_their_vertices(const Union_boundary_2& boundary, const Union_oracle& oracle,
                                                   const std::vector<int>& match) {
  const Dual_2& dual = *boundary.dual;
  if (boundary.vertices_of_edge.size() != dual.edges.size()) return failure() << "two vertices per edge are needed";
  std::vector<bool> used(boundary.vertices.size(), false);
  for (std::size_t e = 0; e < dual.edges.size(); ++e) {
    const auto& [a, b, left, right, kind] = dual.edges[e];
    const auto& found = boundary.vertices_of_edge[e];
    const Real_disk& da = oracle.real_disks[a];
    const Real_disk& db = oracle.real_disks[b];
    const Real ux = db.x - da.x;
    const Real uy = db.y - da.y;
    const bool touches = sign(radical_line(oracle.disks[a], oracle.disks[b]).foot_power) == 0;
    for (const int side : {0, 1}) {
      const bool has_triangle = kind == Dual_kind::interior ||
                                (kind == Dual_kind::regular &&
                                 dual.has_triangle[side == 0 ? (left == -1 ? 0 : left) : (right == -1 ? 0 : right)] &&
                                 (side == 0 ? left : right) != -1);
      const int v = found[side];
      if ((v == -1) != has_triangle)
        return failure() << "edge " << a << " " << b << (v == -1 ? " lacks its vertex" : " has a vertex") << " on side "
                         << side;
      if (v == -1) continue;
      used[v] = true;
      const Oracle_vertex& vertex = oracle.vertices[match[v]];
      if (!std::ranges::binary_search(vertex.sources, a) || !std::ranges::binary_search(vertex.sources, b))
        return failure() << "vertex " << v << " of edge " << a << " " << b << " is not on its circles";
      const Real turn = ux * (vertex.y - da.y) - uy * (vertex.x - da.x);
      if (!touches && (turn > 0) != (side == 0))
        return failure() << "vertex " << v << " of edge " << a << " " << b << " is on the other side";
    }
    if (kind == Dual_kind::singular && touches != (found[0] == found[1]))
      return failure() << "edge " << a << " " << b << " touches in " << found[0] << " and " << found[1];
  }
  if (!std::ranges::all_of(used, [](bool is_used) { return is_used; })) return failure() << "a vertex has no edge";
  return testing::AssertionSuccess();
}

testing::AssertionResult arcs_are_right(const Union_boundary_2& boundary, const Union_oracle& oracle,
                                        const std::vector<int>& match) {
  // A point on another circle: whether its circle counts as an arc is all the same.
  const auto is_arc = [&](const Oracle_arc& arc) { return arc.from == -1 || sign(oracle.disks[arc.ball].weight) > 0; };
  std::vector<Oracle_arc> found;
  for (const Boundary_arc& arc : boundary.arcs) {
    const auto matched = [&](int v) { return v == -1 ? -1 : match.at(v); };
    found.push_back({arc.ball, matched(arc.from), matched(arc.to)});
  }
  // Those of one curve follow each other: a curve ends where it began.
  for (std::size_t a = 0; a < boundary.arcs.size();) {
    const int start = boundary.arcs[a].from;
    std::size_t end = a;
    while (end + 1 < boundary.arcs.size() && boundary.arcs[end].to != start &&
           boundary.arcs[end + 1].from == boundary.arcs[end].to)
      ++end;
    if (boundary.arcs[end].to != start)
      return failure() << "arcs from " << a << " to " << end << " are no closed curve";
    a = end + 1;
  }
  std::erase_if(found, [&](const Oracle_arc& arc) { return !is_arc(arc); });
  std::vector<Oracle_arc> expected;
  std::ranges::copy_if(oracle.arcs, std::back_inserter(expected), is_arc);
  std::ranges::sort(found);
  std::ranges::sort(expected);
  if (found == expected) return testing::AssertionSuccess();
  const auto text = [](const std::vector<Oracle_arc>& arcs) {
    std::string result;
    for (const Oracle_arc& arc : arcs) result += list_text(std::array{arc.ball, arc.from, arc.to});
    return result;
  };
  return failure() << "arcs " << text(found) << ", not " << text(expected);
}

/// A vertex is a sample iff it is one of the contacts that all its circles have in common.
testing::AssertionResult samples_are_right(const Union_boundary_2& boundary, const Union_oracle& oracle,
                                           const std::vector<int>& match) {
  const Balls_2& balls = *boundary.dual->regular->balls;
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v) {
    int expected = -1;
    if (balls.is_circumscribed() && boundary.dual->alpha == 0) {
      const auto sources = boundary.sources_of(static_cast<int>(v));
      for (const int s : balls.contacts_of(sources[0])) {
        const bool is_common = std::ranges::all_of(sources, [&](int i) {
          const auto contacts = balls.contacts_of(i);
          return std::ranges::find(contacts, s) != contacts.end();
        });
        const Point_2& p = (*balls.samples)[s];
        const Oracle_vertex& vertex = oracle.vertices[match[v]];
        const Real away = abs(vertex.x - p.x) + abs(vertex.y - p.y);
        if (is_common && away < 1e-25 * oracle.scale) expected = s;
      }
    }
    if (boundary.samples[v] != expected)
      return failure() << "vertex " << v << " is sample " << boundary.samples[v] << ", not " << expected;
    if (expected != -1 && boundary.vertices[v] != (*balls.samples)[expected])
      return failure() << "vertex " << v << " is not at its sample";
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult is_boundary(const std::shared_ptr<const Balls_2>& balls, double alpha) {
  Progress progress;
  const Union_boundary_2 boundary = union_boundary(balls, alpha, progress);
  const Union_oracle oracle = union_oracle(*balls, alpha);
  if (boundary.radii.size() != balls->size()) return failure() << "a radius per disk is needed";
  for (std::size_t i = 0; i < balls->size(); ++i) {
    if (!(std::abs(boundary.radii[i] - oracle.radii[i]) <= 1e-15 * oracle.scale + 1e-7 * oracle.radii[i]))
      return failure() << "radius " << i << " is " << boundary.radii[i] << ", not " << oracle.radii[i];
  }
  std::vector<int> match;
  if (auto result = match_vertices(boundary, oracle, match); !result) return result;
  if (auto result = edges_have_their_vertices(boundary, oracle, match); !result) return result;
  if (auto result = arcs_are_right(boundary, oracle, match); !result) return result;
  return samples_are_right(boundary, oracle, match);
}

testing::AssertionResult is_boundary_for_several_alpha(const std::shared_ptr<const Balls_2>& balls) {
  double square = 0;
  for (const double radius : balls->radii) square = std::max(square, radius * radius);
  // With 9 radii 4 become 5, and 5 become 4: positions stay special. It must be more than the oracle's rounding.
  const double special = square > 1e-20 && square < 1e20 ? 9 : 0.1 * square;
  for (const double alpha : {special, -special, -0.3 * square})
    if (auto result = is_boundary(balls, alpha); !result) return result << " (alpha " << alpha << ")";
  return testing::AssertionSuccess();
}

TEST(Union_boundary_2, equals_the_definition) {
  expect_of_given_balls(repetitions(30), [](const auto& balls) { return is_boundary(balls, 0); });
}
TEST(Union_boundary_2, equals_the_definition_for_circumscribed_disks) {
  expect_of_circumscribed_balls(repetitions(12), [](const auto& balls) { return is_boundary(balls, 0); });
}
TEST(Union_boundary_2, equals_the_definition_for_other_alpha) {
  expect_of_given_balls(repetitions(8), is_boundary_for_several_alpha);
  expect_of_circumscribed_balls(repetitions(3), is_boundary_for_several_alpha);
}

}  // namespace
}  // namespace mesecina::test
