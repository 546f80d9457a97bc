// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <sstream>

#include "geometries/union_2/union_medial_axis_2.h"
#include "tests/geometries/results.h"
#include "tests/geometries/union/disk_sets.h"
#include "tests/geometries/union/union_oracle.h"

namespace mesecina::test {
namespace {

using Betti = std::array<std::int64_t, 2>;

/// Of a graph.
Betti betti(const Union_medial_axis_2& axis) {
  std::vector<int> parent(axis.centers.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int a) {
    while (parent[a] != a) a = parent[a];
    return a;
  };
  auto components = static_cast<std::int64_t>(parent.size());
  for (const auto& [a, b] : axis.edges) {
    const int x = root(a);
    const int y = root(b);
    if (x == y) continue;
    parent[x] = y;
    --components;
  }
  return {components, static_cast<std::int64_t>(axis.edges.size() + components - axis.centers.size())};
}

std::string betti_text(const Betti& betti) {
  return "(" + std::to_string(betti[0]) + ", " + std::to_string(betti[1]) + ")";
}

/// Disks that meet and boundary curves give the Betti numbers of the union; the dual complex and the medial axis must
/// have the same.
testing::AssertionResult has_one_topology(const std::shared_ptr<const Balls_2>& balls, double alpha) {
  Progress progress;
  const Union_oracle oracle = union_oracle(*balls, alpha);
  const Betti expected{oracle.component_count, oracle.hole_count};
  const auto boundary = std::make_shared<const Union_boundary_2>(union_boundary(balls, alpha, progress));
  const Topology dual = topology(*boundary->dual);
  if (Betti{dual.betti[0], dual.betti[1]} != expected || dual.betti[2] != 0 || dual.euler != expected[0] - expected[1])
    return failure() << "dual complex " << betti_text({dual.betti[0], dual.betti[1]}) << ", Euler characteristic "
                     << dual.euler << ", union " << betti_text(expected);
  const Union_voronoi_2 voronoi = union_voronoi(boundary, progress);
  for (const bool complete_only : {false, true}) {
    const Betti axis = betti(union_medial_axis(voronoi, complete_only, progress));
    if (axis != expected)
      return failure() << (complete_only ? "complete" : "whole") << " medial axis " << betti_text(axis) << ", union "
                       << betti_text(expected);
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult has_one_topology_for_several_alpha(const std::shared_ptr<const Balls_2>& balls) {
  double square = 0;
  for (const double radius : balls->radii) square = std::max(square, radius * radius);
  const double special = square > 1e-20 && square < 1e20 ? 9 : 0.1 * square;
  for (const double alpha : {special, -special, -0.3 * square})
    if (auto result = has_one_topology(balls, alpha); !result) return result << " (alpha " << alpha << ")";
  return testing::AssertionSuccess();
}

TEST(Union_topology_2, is_one_for_union_dual_and_medial_axis) {
  expect_of_given_balls(repetitions(120), [](const auto& balls) { return has_one_topology(balls, 0); });
}
TEST(Union_topology_2, is_one_for_circumscribed_disks) {
  expect_of_circumscribed_balls(repetitions(13), [](const auto& balls) { return has_one_topology(balls, 0); });
}
TEST(Union_topology_2, is_one_for_other_alpha) {
  expect_of_given_balls(repetitions(15), has_one_topology_for_several_alpha);
  expect_of_circumscribed_balls(repetitions(3), has_one_topology_for_several_alpha);
}

/// Rounded centers and radii of circumscribed disks: many circles nearly through one point.
TEST(Union_topology_2, is_one_for_nearly_special_disks) {
  expect_of_circumscribed_balls(repetitions(8), [](const std::shared_ptr<const Balls_2>& balls) {
    std::vector<Disk_2> disks;
    for (std::size_t i = 0; i < balls->size(); ++i) disks.push_back({balls->centers[i], balls->radii[i]});
    const auto rounded = std::make_shared<const Balls_2>(given_balls(disks));
    const testing::AssertionResult result = has_one_topology(rounded, 0);
    return result ? result : failure() << result.message() << "\n  " << mesecina::test::to_text(*rounded);
  });
  expect_of_circumscribed_balls(repetitions(5), [](const std::shared_ptr<const Balls_2>& balls) {
    return has_one_topology(std::make_shared<const Balls_2>(grown(*balls, 1.1)), 0);
  });
}

}  // namespace
}  // namespace mesecina::test
