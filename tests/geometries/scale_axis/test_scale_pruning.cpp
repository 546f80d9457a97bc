// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "tests/geometries/results.h"
#include "tests/geometries/scale_axis/scale_stages.h"
#include "tests/geometries/union/disk_sets.h"

/// Which branches of the grown medial axis are left out. [B. Miklos: The Scale Axis Transform, 2010, section 6.1.2]
namespace mesecina::test {
namespace {

struct Graph_edge {
  std::array<int, 2> ends;
  std::array<int, 2> contacts;
  double angle = 0;
};

std::vector<Graph_edge> complete_edges(const Union_medial_axis_2& axis) {
  const std::vector<double> angles = angle_of_edges(axis);
  std::vector<Graph_edge> result;
  for (std::size_t e = 0; e < axis.edges.size(); ++e)
    if (axis.kinds[e] != Axis_edge_kind::incomplete) result.push_back({axis.edges[e], axis.contacts[e], angles[e]});
  return result;
}

std::map<int, int> degrees(const std::vector<Graph_edge>& edges) {
  std::map<int, int> result;
  for (const Graph_edge& edge : edges)
    for (const int end : edge.ends) ++result[end];
  return result;
}

/// Removes the leaf of the least angle (of equal ones that of the least contacts) below the limit, as long as there is
/// one that is not the last edge of its component.
std::vector<Graph_edge> pruned(std::vector<Graph_edge> edges, double min_angle) {
  while (true) {
    std::map<int, int> degree = degrees(edges);
    auto least = edges.end();
    for (auto edge = edges.begin(); edge != edges.end(); ++edge) {
      const int a = degree[edge->ends[0]];
      const int b = degree[edge->ends[1]];
      if (edge->angle >= min_angle || (a > 1 && b > 1) || (a == 1 && b == 1)) continue;
      if (least == edges.end() || edge->angle < least->angle ||
          (edge->angle == least->angle && edge->contacts < least->contacts))
        least = edge;
    }
    if (least == edges.end()) return edges;
    edges.erase(least);
  }
}

using Placed_edge = std::array<std::array<double, 2>, 2>;
Placed_edge placed(const Point_2& a, const Point_2& b) {
  const std::array<double, 2> p{a.x, a.y};
  const std::array<double, 2> q{b.x, b.y};
  return {std::min(p, q), std::max(p, q)};
}

testing::AssertionResult prunes_by_definition(const std::shared_ptr<const Balls_2>& balls) {
  Scale_stages stages = scale_stages(balls, 1);
  for (const double scale : {1.0, 1.2, 2.0}) {
    stages = at_scale(stages, scale);
    const std::vector<Graph_edge> complete = complete_edges(stages.grown_axis);
    for (const double min_angle : {0.0, 10.0, 30.0, 90.0, 150.0, 180.0}) {
      std::multiset<Placed_edge> expected;
      for (const Graph_edge& edge : pruned(complete, min_angle))
        expected.insert(placed(stages.grown_axis.centers[edge.ends[0]], stages.grown_axis.centers[edge.ends[1]]));
      // Sampling at 0 degrees cuts only edges whose disks, shrunk, are apart.
      const Scale_axis_2 axis = stages.scale_axis(min_angle, 0);
      std::multiset<Placed_edge> found;
      for (const auto& [a, b] : axis.edges) found.insert(placed(axis.centers[a], axis.centers[b]));
      std::multiset<Placed_edge> surplus;
      std::ranges::set_difference(found, expected, std::inserter(surplus, surplus.end()));
      std::size_t cut = 0;
      for (const Placed_edge& edge : expected) cut += found.contains(edge) ? 0 : 1;
      // Only cut edges may be missing, each for at least two pieces.
      if (surplus.size() < 2 * cut || (cut == 0 && !surplus.empty()))
        return failure() << "scale " << scale << ", least angle " << min_angle << ": " << surplus.size()
                         << " edges not expected, " << cut << " missing";
    }
  }
  return testing::AssertionSuccess();
}

TEST(Scale_pruning_2, removes_leaves_of_small_angle_one_by_one) {
  expect_of_given_balls(repetitions(12), prunes_by_definition);
  expect_of_circumscribed_balls(repetitions(3), prunes_by_definition);
}

/// On the result itself, whatever it was made from.
testing::AssertionResult has_no_small_leaf(const Scale_axis_2& axis, double min_angle) {
  std::vector<std::vector<int>> edges_at(axis.centers.size());
  for (std::size_t e = 0; e < axis.edges.size(); ++e)
    for (const int end : axis.edges[e]) edges_at[end].push_back(static_cast<int>(e));
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    const auto [a, b] = axis.edges[e];
    if (axis.monotone_angles[e] < min_angle) return failure() << "an edge that should have gone";
    if (axis.monotone_angles[e] < axis.angles[e]) return failure() << "an edge goes before its own angle";
    const bool is_leaf = edges_at[a].size() == 1 || edges_at[b].size() == 1;
    if (is_leaf && axis.angles[e] < min_angle && axis.monotone_angles[e] != infinity)
      return failure() << "a leaf of " << axis.angles[e] << " degrees";
    // Inwards it grows: at one end the edge is the last of all.
    const auto is_last_at = [&](int end) {
      return std::ranges::all_of(edges_at[end],
                                 [&](int other) { return axis.monotone_angles[other] <= axis.monotone_angles[e]; });
    };
    if (!is_last_at(a) && !is_last_at(b)) return failure() << "an edge goes before what lies beyond it on both sides";
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult has_no_small_leaf_anywhere(const std::shared_ptr<const Balls_2>& balls) {
  Scale_stages stages = scale_stages(balls, 1);
  for (const double scale : {1.0, 1.1, 1.5, 3.0}) {
    stages = at_scale(stages, scale);
    for (const double min_angle : {0.0, 30.0, 100.0, 180.0})
      if (auto result = has_no_small_leaf(stages.scale_axis(min_angle, 150), min_angle); !result)
        return result << ", scale " << scale << ", least angle " << min_angle;
  }
  return testing::AssertionSuccess();
}

TEST(Scale_pruning_2, leaves_no_small_leaf_and_grows_inwards) {
  expect_of_given_balls(repetitions(12), has_no_small_leaf_anywhere);
  expect_of_circumscribed_balls(repetitions(4), has_no_small_leaf_anywhere);
}

TEST(Scale_pruning_2, of_a_bump_on_a_large_disk) {
  // A small disk that looks out of a large one by a tenth of its radius; the axis is the line of centers.
  const auto balls = std::make_shared<const Balls_2>(given_balls(std::vector<Disk_2>{{{0, 0}, 10}, {{9.1, 0}, 1}}));
  const Scale_stages stages = scale_stages(balls, 1);
  const Scale_axis_2 whole = stages.scale_axis(0, 0);
  ASSERT_EQ(whole.edges.size(), 1U);
  // The circles meet at x = (100 - 1 + 9.1^2) / 18.2; seen from the small disk's center that is behind it.
  const double x = (100 - 1 + 9.1 * 9.1) / 18.2;
  const double angle = 2 * std::atan2(std::sqrt(100 - x * x), std::max(0.0, x - 9.1)) * 180 / 3.141592653589793;
  EXPECT_NEAR(whole.angles[0], angle, 1e-9);
  // The last edge stays at any limit; and the large disk covers the small one when it has grown by 9.1 / 9.
  EXPECT_EQ(whole.monotone_angles[0], infinity);
  EXPECT_EQ(stages.scale_axis(180, 0).edges.size(), 1U);
  EXPECT_EQ(at_scale(stages, 1.0110).scale_axis(30, 0).edges.size(), 1U);
  const Scale_axis_2 covered = at_scale(stages, 1.0112).scale_axis(30, 0);
  ASSERT_EQ(covered.centers.size(), 1U);
  EXPECT_EQ(covered.centers[0], (Point_2{0, 0}));
  EXPECT_DOUBLE_EQ(covered.radii[0], 10);
}

}  // namespace
}  // namespace mesecina::test
