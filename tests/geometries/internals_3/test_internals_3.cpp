// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/graph.h"
#include "geometries/internals_3/module.h"
#include "geometries/modules_3.h"
#include "geometries/union_3/module.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

using Balls = std::vector<Ball_3>;

class Ball_graph {
 public:
  explicit Ball_graph(Balls of) : balls(std::move(of)), graph(make_registry_3()) {
    graph.set_inputs(Inputs().with(balls_input, balls));
  }
  Primitive_set layer(const char* id) {
    const auto outcome = graph.layer(id, progress);
    EXPECT_TRUE(outcome) << outcome.reason;
    return outcome ? *outcome.value : Primitive_set();
  }
  template <class T>
  std::shared_ptr<const T> get(Key<T> key) {
    return graph.structure(key, progress).value;
  }

  Balls balls;
  Graph graph;
  Progress progress;
};

const std::vector<double>& values_of(const Primitive_set& set, const char* name) {
  const Values* values = set.find_values(name);
  EXPECT_NE(values, nullptr) << name;
  static const std::vector<double> none;
  return values != nullptr ? values->data : none;
}

TEST(Internals_3, OriginsAreTheBallsOnWhoseSpheresAVertexLies) {
  Ball_graph graph(many_balls(60, 8, 2));
  const Primitive_set set = graph.layer("union-vertices-origin");
  const auto vertices = graph.get(union_vertices_3_key);
  std::vector<int> counts(vertices->points.size(), 0);
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    const Ball_3& ball = graph.balls[static_cast<std::size_t>(values_of(set, "ball")[i])];
    const Point_3& vertex = set.vertices[set.segments[i][0]];
    EXPECT_EQ(set.vertices[set.segments[i][1]], ball.center);
    EXPECT_EQ(vertex, vertices->points[set.id(i)]);
    EXPECT_NEAR(distance(vertex, ball.center), ball.radius, 1e-6 * ball.radius);
    ++counts[set.id(i)];
  }
  ASSERT_GT(counts.size(), 20u);
  EXPECT_GE(std::ranges::min(counts), 3);
}

/// The vertices of the axis that have a face.
std::set<std::array<double, 3>> corners_of_faces(const Medial_complex_3& axis) {
  std::set<std::array<double, 3>> corners;
  for (const int v : axis.face_vertices) corners.insert({axis.centers[v].x, axis.centers[v].y, axis.centers[v].z});
  return corners;
}

TEST(Internals_3, InteriorVoronoiVerticesAreVerticesOfTheMedialAxis) {
  for (const double neighbors : {5.0, 20.0}) {
    Ball_graph graph(many_balls(80, neighbors, 3));
    const Primitive_set set = graph.layer("union-voronoi-interior");
    const auto axis = graph.get(medial_axis_3_key);
    const auto vertices = graph.get(union_vertices_3_key);
    std::set<std::array<double, 3>> medial;
    for (const Point_3& c : axis->centers) medial.insert({c.x, c.y, c.z});
    std::set<std::array<double, 3>> found;
    ASSERT_GT(set.points.size(), 20u);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      const Point_3& p = set.vertices[set.points[i]];
      EXPECT_TRUE(found.insert({p.x, p.y, p.z}).second) << "twice";
      EXPECT_TRUE(medial.contains({p.x, p.y, p.z}));
      double nearest = std::numeric_limits<double>::infinity();
      for (const Point_3& v : vertices->points) nearest = std::min(nearest, distance(v, p));
      EXPECT_NEAR(values_of(set, "radius")[i], nearest, 1e-6 * nearest);
      const double ball = values_of(set, "ball")[i];
      if (ball >= 0) {
        EXPECT_EQ(graph.balls[static_cast<std::size_t>(ball)].center, p);
      }
    }
    EXPECT_GT(std::ranges::count(values_of(set, "ball"), -1.0), 5);
    // Singular triangles of the dual complex are faces, too, but of centers of balls.
    for (const auto& corner : corners_of_faces(*axis)) {
      const Point_3 p{corner[0], corner[1], corner[2]};
      const bool is_center = std::ranges::any_of(graph.balls, [&](const Ball_3& ball) { return ball.center == p; });
      EXPECT_TRUE(is_center || found.contains(corner));
    }
  }
}

TEST(Internals_3, DelaunayEdgesOfTheVerticesKnowTheBallsOfBothEnds) {
  Ball_graph graph(many_balls(80, 12, 5));
  const Primitive_set set = graph.layer("union-vertices-delaunay");
  std::set<std::array<int, 2>> edges;
  ASSERT_GT(set.segments.size(), 50u);
  for (std::size_t i = 0; i < set.segments.size(); ++i) {
    EXPECT_TRUE(edges.insert(set.segments[i]).second);
    int common = 0;
    for (const Ball_3& ball : graph.balls) {
      const auto is_on = [&](int v) {
        return std::abs(distance(set.vertices[v], ball.center) - ball.radius) < 1e-7 * ball.radius;
      };
      common += is_on(set.segments[i][0]) && is_on(set.segments[i][1]) ? 1 : 0;
    }
    EXPECT_EQ(values_of(set, "common-balls")[i], common);
  }
  // Each face of the medial axis that is no singular triangle is dual to one of them: its contacts are the ends.
  const auto axis = graph.get(medial_axis_3_key);
  std::set<std::array<double, 6>> ends;
  for (const auto& [a, b] : set.segments) {
    for (const auto& [p, q] : {std::pair{set.vertices[a], set.vertices[b]}, {set.vertices[b], set.vertices[a]}})
      ends.insert({p.x, p.y, p.z, q.x, q.y, q.z});
  }
  std::size_t dual_faces = 0;
  for (const auto& [p, q] : axis->contacts) dual_faces += ends.contains({p.x, p.y, p.z, q.x, q.y, q.z}) ? 1 : 0;
  std::size_t singular = 0;
  for (const Dual_3::Triangle& triangle : graph.get(dual_3_key)->triangles)
    singular += triangle.kind == Simplex_kind_3::singular ? 1 : 0;
  EXPECT_GE(dual_faces + singular, axis->face_count());
  EXPECT_GT(dual_faces, 10u);
}

TEST(Internals_3, AreEmptyWhereTheUnionHasNoVertices) {
  Ball_graph graph({{{0, 0, 0}, 1}, {{1, 0, 0}, 1}});
  for (const char* id : {"union-vertices-origin", "union-vertices-delaunay", "union-voronoi-interior"})
    EXPECT_TRUE(graph.layer(id).is_empty()) << id;
}

}  // namespace
}  // namespace mesecina::test
