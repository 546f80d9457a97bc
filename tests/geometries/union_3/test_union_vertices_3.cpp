// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "geometries/union_3/union_3.h"
#include "tests/geometries/results.h"
#include "tests/geometries/union_3/ball_sets.h"
#include "tests/geometries/union_3/boundary_oracle_3.h"

namespace mesecina::test {
namespace {

std::string place(const Point_3& p) {
  std::ostringstream text;
  text.precision(17);
  text << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return text.str();
}

Union_vertices_3 union_vertices_of(const std::vector<Ball_3>& balls) {
  Progress progress;
  auto regular = std::make_shared<const Regular_3>(regular_triangulation(balls, progress));
  auto dual = std::make_shared<const Dual_3>(dual_complex(std::move(regular), progress));
  return union_vertices(std::move(dual), progress);
}

/// The same points, with the same balls as far as they are not hidden.
testing::AssertionResult are_vertices_of_the_definition(const std::vector<Ball_3>& balls) {
  const Union_vertices_3 found = union_vertices_of(balls);
  const Boundary_oracle_3 boundary(balls);
  Ball_set shown = 0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (found.dual->regular->cell_of_ball[i] >= 0) shown |= Ball_set{1} << i;
  std::vector<Oracle_vertex_3> expected = vertices_by_definition(balls);
  std::erase_if(expected, [](const Oracle_vertex_3& v) { return !v.is_on_boundary; });
  std::vector<bool> is_taken(expected.size());
  // Spheres that nearly touch meet in points that are known to half the digits only.
  const double tolerance = 1e-6 * boundary.scale() + 1000 * boundary.precision();
  for (int i = 0; i < static_cast<int>(found.points.size()); ++i) {
    Ball_set set = 0;
    for (const int ball : found.balls_of(i)) set |= Ball_set{1} << ball;
    if (!std::ranges::is_sorted(found.balls_of(i))) return failure() << "balls of a vertex are not in order";
    int best = -1;
    for (int k = 0; k < static_cast<int>(expected.size()); ++k)
      if (!is_taken[k] && (expected[k].balls & shown) == set &&
          (best < 0 || distance(expected[k].point, found.points[i]) < distance(expected[best].point, found.points[i])))
        best = k;
    if (best < 0) {
      std::string names;
      for (const int ball : found.balls_of(i)) names += " " + std::to_string(ball);
      return failure() << "there is no vertex " << place(found.points[i]) << " of balls" << names;
    }
    if (distance(expected[best].point, found.points[i]) > tolerance)
      return failure() << "vertex at " << place(found.points[i]) << " instead of " << place(expected[best].point);
    is_taken[best] = true;
  }
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (is_taken[k]) continue;
    std::string names;
    for (const int ball : members(expected[k].balls)) names += " " + std::to_string(ball);
    return failure() << "vertex " << place(expected[k].point) << " is missing, of balls" << names;
  }
  return testing::AssertionSuccess();
}

TEST(Union_vertices_3, are_those_of_simple_unions) {
  const std::vector<std::pair<std::string, std::size_t>> counts{{"one", 0},
                                                                {"two crossing", 0},
                                                                {"three", 2},
                                                                {"three around a hole", 0},
                                                                {"four", 4},
                                                                {"three through a point, which they surround", 1},
                                                                {"six through a point, which they surround", 8},
                                                                {"four through a point, on one side", 2},
                                                                {"two parts touching in a point", 1},
                                                                {"cube of balls around a cavity", 12}};
  for (const auto& [name, count] : counts) {
    SCOPED_TRACE(name);
    const std::vector<Named_balls> sets = difficult_ball_sets();
    const auto set = std::ranges::find(sets, name, &Named_balls::name);
    ASSERT_NE(set, sets.end());
    EXPECT_EQ(union_vertices_of(set->balls).points.size(), count);
  }
}

TEST(Union_vertices_3, are_those_of_the_definition) {
  expect_of_balls(repetitions(60), are_vertices_of_the_definition);
}

}  // namespace
}  // namespace mesecina::test
