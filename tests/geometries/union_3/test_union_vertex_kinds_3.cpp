// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/graph.h"
#include "geometries/modules_3.h"
#include "geometries/union_3/union_3.h"
#include "tests/geometries/union_3/ball_sets.h"
#include "tests/geometries/union_3/power_oracle_3.h"

namespace mesecina::test {
namespace {

using Balls = std::vector<Ball_3>;

Union_vertices_3 vertices_of(const Balls& balls) {
  Progress progress;
  auto regular = std::make_shared<const Regular_3>(regular_triangulation(balls, progress));
  auto dual = std::make_shared<const Dual_3>(dual_complex(std::move(regular), progress));
  return union_vertices(std::move(dual), progress);
}

/// In general position a triangle of the dual complex is singular iff both points where its spheres meet are on the
/// boundary of the union.
TEST(Union_vertex_kinds_3, TwoVerticesOfTheSameBallsAreSingular) {
  int singular_count = 0;
  int other_count = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Balls balls = many_balls(20, 5, seed);
    std::map<Ball_set, int> on_boundary;
    for (const Oracle_vertex_3& vertex : vertices_by_definition(balls))
      if (vertex.is_on_boundary) ++on_boundary[vertex.balls];
    const Union_vertices_3 vertices = vertices_of(balls);
    const std::vector<std::uint8_t> singular = have_singular_triangles(vertices);
    ASSERT_EQ(singular.size(), vertices.points.size());
    for (int v = 0; v < static_cast<int>(vertices.points.size()); ++v) {
      Ball_set set = 0;
      for (const int ball : vertices.balls_of(v)) set |= Ball_set{1} << ball;
      EXPECT_EQ(singular[v] != 0, on_boundary[set] == 2);
      ++(singular[v] != 0 ? singular_count : other_count);
    }
  }
  EXPECT_GT(singular_count, 20);
  EXPECT_GT(other_count, 20);
}

TEST(Union_vertex_kinds_3, AreThoseOfTheTrianglesOfTheirBalls) {
  expect_of_balls(4, [](const Balls& balls) -> testing::AssertionResult {
    const Union_vertices_3 vertices = vertices_of(balls);
    const std::vector<std::uint8_t> singular = have_singular_triangles(vertices);
    for (int v = 0; v < static_cast<int>(vertices.points.size()); ++v) {
      const auto own = vertices.balls_of(v);
      const bool expected = std::ranges::any_of(vertices.dual->triangles, [&](const Dual_3::Triangle& triangle) {
        return triangle.kind == Simplex_kind_3::singular &&
               std::ranges::all_of(triangle.balls, [&](int ball) { return std::ranges::find(own, ball) != own.end(); });
      });
      if (expected != (singular[v] != 0)) return testing::AssertionFailure() << "vertex " << v;
    }
    return testing::AssertionSuccess();
  });
}

TEST(Union_vertex_kinds_3, TheLayerCountsTheBalls) {
  // Three around an axis, and apart from them six spheres through one point.
  Balls balls{{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, 1, 0}, 1}};
  for (const double far : {-1.0, 1.0})
    for (int axis = 0; axis < 3; ++axis)
      balls.push_back({{20 + (axis == 0 ? far : 0), axis == 1 ? far : 0, axis == 2 ? far : 0}, 1});
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(balls_input, balls));
  Progress progress;
  const auto layer = graph.layer("union-vertices", progress);
  ASSERT_TRUE(layer) << layer.reason;
  const Values* count = layer.value->find_values("balls");
  const Values* singular = layer.value->find_values("singular");
  ASSERT_TRUE(count != nullptr && singular != nullptr);
  int of_the_three = 0;
  for (std::size_t v = 0; v < layer.value->points.size(); ++v) {
    const Point_3& p = layer.value->vertices[v];
    if (p.x > 10) {
      EXPECT_GE(count->data[v], 3);
      continue;
    }
    EXPECT_EQ(count->data[v], 3);
    EXPECT_EQ(singular->data[v], 1);
    ++of_the_three;
  }
  EXPECT_EQ(of_the_three, 2);
}

}  // namespace
}  // namespace mesecina::test
