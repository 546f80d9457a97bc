// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/graph.h"
#include "geometries/delaunay_3/module.h"
#include "geometries/medial_filtrations_3/module.h"
#include "geometries/modules_3.h"
#include "geometries/union_3/module.h"

namespace mesecina::test {
namespace {

/// What is told of one element when somebody rests on it.
class Descriptions_3 : public testing::Test {
 protected:
  void set(Inputs inputs) { graph_.set_inputs(std::move(inputs)); }
  Element_description describe(const char* layer, std::size_t element) {
    return graph_.describe(layer, element, progress_);
  }
  static std::string text(const Element_description& description, const char* name) {
    const auto found = std::ranges::find(description.facts, name, &Fact::name);
    return found == description.facts.end() ? "none" : found->text;
  }

  Graph graph_{make_registry_3()};
  Progress progress_;
};

const std::vector<Ball_3> triangle{{{0, 0, 0}, 0.7}, {{1, 0, 0}, 0.7}, {{0.5, 0.8, 0}, 0.7}};

TEST_F(Descriptions_3, OfAMedialFaceAreItsContactsAndTheBallsOnWhoseSpheresTheyLie) {
  set(Inputs().with(balls_input, triangle));
  const auto axis = graph_.layer("medial-axis", progress_).value;
  const std::size_t face = axis->element_count() - 1;
  ASSERT_EQ(axis->polygon_count(), 1u);
  for (const auto& [layer, element] :
       {std::pair{"medial-axis", face}, {"angle-medial-axis", face}, {"medial-contacts", std::size_t{0}}}) {
    const Element_description known = describe(layer, element);
    EXPECT_EQ(text(known, "balls at contact 1"), "0, 1 and 2") << layer;
    EXPECT_EQ(text(known, "balls at contact 2"), "0, 1 and 2") << layer;
    ASSERT_EQ(known.dual.points.size(), 2u);
    ASSERT_EQ(known.dual.balls.size(), 3u);
    EXPECT_EQ(known.dual.dimension, 3);
    for (const int contact : known.dual.points)
      for (const auto& ball : known.dual.balls)
        EXPECT_NEAR(distance(known.dual.vertices[contact], known.dual.vertices[ball.center]), ball.radius, 1e-9);
  }
}

TEST_F(Descriptions_3, OfAMedialVertexIsItsBallAndOfAnEdgeThoseAtItsEnds) {
  set(Inputs().with(balls_input, triangle));
  const auto axis = graph_.layer("medial-axis", progress_).value;
  const Element_description vertex = describe("medial-axis", 0);
  EXPECT_EQ(text(vertex, "radius"), "0.7");
  ASSERT_EQ(vertex.dual.balls.size(), 1u);
  EXPECT_EQ(vertex.dual.vertices[0], axis->vertices[0]);
  const Element_description edge = describe("medial-axis", axis->points.size());
  EXPECT_EQ(edge.dual.balls.size(), 2u);
  EXPECT_TRUE(describe("medial-axis", axis->element_count()).dual.is_empty());
}

TEST_F(Descriptions_3, OfABallIsItsStarInTheDualComplex) {
  std::vector<Ball_3> balls = triangle;
  balls.push_back({{9, 0, 0}, 1});
  set(Inputs().with(balls_input, balls));
  for (std::size_t ball = 0; ball < 3; ++ball) {
    const Element_description known = describe("balls", ball);
    EXPECT_EQ(text(known, "neighbours in the dual complex"), "2");
    EXPECT_EQ(known.dual.segments.size(), 2u);
  }
  EXPECT_EQ(describe("balls", 3).dual.segments.size(), 0u);
}

TEST_F(Descriptions_3, OfASimplexAreItsBallsAndItsPartOfThePowerDiagram) {
  // A small ball in the middle of a crooked cube of others: its power cell is bounded.
  std::vector<Ball_3> balls{{{0.1, 0.2, 0}, 0.4}};
  for (const double x : {-1.0, 1.1})
    for (const double y : {-1.2, 1.0})
      for (const double z : {-1.0, 1.3}) balls.push_back({{x + 0.1 * z, y - 0.05 * x, z + 0.07 * y}, 1.4 + 0.05 * x});
  set(Inputs().with(balls_input, balls));
  const auto power = [&](const Point_3& p, const Ball_3& ball) {
    return dot(p - ball.center, p - ball.center) - ball.radius * ball.radius;
  };
  std::array<std::size_t, 4> bounded{};
  for (const char* layer : {"regular-triangulation", "dual", "dual-edges", "dual-triangles"}) {
    const auto drawn = graph_.layer(layer, progress_).value;
    const std::size_t edges_end = drawn->points.size() + drawn->segments.size();
    for (std::size_t e = 0; e < drawn->element_count(); ++e) {
      const Element_description known = describe(layer, e);
      std::vector<Point_3> corners;
      if (e < drawn->points.size()) {
        corners = {drawn->vertices[drawn->points[e]]};
      } else if (e < edges_end) {
        for (const int v : drawn->segments[e - drawn->points.size()]) corners.push_back(drawn->vertices[v]);
      } else {
        for (const int v : drawn->triangles[e - edges_end]) corners.push_back(drawn->vertices[v]);
      }
      ASSERT_EQ(known.dual.balls.size(), corners.size()) << layer << ", " << e;
      for (std::size_t i = 0; i < corners.size(); ++i)
        EXPECT_EQ(known.dual.vertices[known.dual.balls[i].center], corners[i]) << layer << ", " << e;
      // What comes after the centers are points of the power diagram: as near to the balls, and to none nearer.
      for (std::size_t v = corners.size(); v < known.dual.vertices.size(); ++v) {
        const Point_3& p = known.dual.vertices[v];
        double least = power(p, balls[0]);
        for (const Ball_3& ball : balls) least = std::min(least, power(p, ball));
        for (const Ball& ball : known.dual.balls)
          EXPECT_NEAR(power(p, {known.dual.vertices[ball.center], ball.radius}), least, 1e-6) << layer << ", " << e;
      }
      bounded[corners.size()] += known.dual.polygon_count() + known.dual.segments.size();
      const bool is_of_dual = std::string_view(layer).starts_with("dual");
      EXPECT_EQ(text(known, "in the dual complex") != "none", is_of_dual);
      EXPECT_NE(text(known, corners.size() == 1 ? "ball" : "balls"), "none");
    }
    EXPECT_TRUE(describe(layer, drawn->element_count()).facts.empty());
  }
  EXPECT_EQ(bounded[1], 0u);
  EXPECT_GE(bounded[2], 8u) << "faces between the middle and the corners";
  EXPECT_GT(bounded[3], 0u);
  EXPECT_EQ(text(describe("regular-triangulation", 0), "neighbours in the regular triangulation"), "8");
  EXPECT_EQ(text(describe("regular-triangulation", 0), "radius"), "0.4");
}

TEST_F(Descriptions_3, OfADelaunayTriangleIsTheVoronoiEdgeAndOfAVoronoiFaceItsSamples) {
  std::vector<Point_3> points{{0.1, 0.2, 0}};
  for (const double x : {-1.0, 1.1})
    for (const double y : {-1.2, 1.0})
      for (const double z : {-1.0, 1.3}) points.push_back({x + 0.1 * z, y - 0.05 * x, z + 0.07 * y});
  set(Inputs().with(cloud_input, points));
  const auto triangles = graph_.layer("delaunay", progress_).value;
  std::size_t edges = 0;
  for (std::size_t t = 0; t < triangles->triangles.size(); ++t) {
    const Element_description known = describe("delaunay", t);
    const auto& corners = triangles->triangles[t];
    edges += known.dual.segments.size();
    // Points of the edge are equally far from the corners.
    for (const Point_3& center : known.dual.vertices) {
      const double radius = distance(center, triangles->vertices[corners[0]]);
      EXPECT_NEAR(distance(center, triangles->vertices[corners[1]]), radius, 1e-9 * radius);
      EXPECT_NEAR(distance(center, triangles->vertices[corners[2]]), radius, 1e-9 * radius);
    }
  }
  EXPECT_GT(edges, 0u);
  EXPECT_LT(edges, triangles->triangles.size()) << "edges of triangles on the hull are rays";
  const auto faces = graph_.layer("voronoi", progress_).value;
  ASSERT_GT(faces->polygon_count(), 0u);
  for (std::size_t f = 0; f < faces->polygon_count(); ++f) {
    const Element_description known = describe("voronoi", f);
    ASSERT_EQ(known.dual.vertices.size(), 2u);
    for (const int v : faces->polygon(f))
      EXPECT_NEAR(distance(faces->vertices[v], known.dual.vertices[0]),
                  distance(faces->vertices[v], known.dual.vertices[1]), 1e-9);
  }
}

}  // namespace
}  // namespace mesecina::test
