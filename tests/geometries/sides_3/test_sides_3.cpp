// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/graph.h"
#include "geometries/delaunay_3/module.h"
#include "geometries/modules_3.h"
#include "geometries/power_crust_3/module.h"
#include "geometries/samples_3/module.h"
#include "geometries/sides_3/module.h"
#include "tests/geometries/power_crust_3/clouds_3.h"
#include "tests/geometries/solid_3/meshes_3.h"

namespace mesecina::test {
namespace {

/// A graph of one input.
class Sides_graph {
 public:
  explicit Sides_graph(const Cloud& cloud) : graph(make_registry_3()) {
    graph.set_inputs(Inputs().with(cloud_input, cloud));
  }
  explicit Sides_graph(const Triangle_mesh_3& mesh) : graph(make_registry_3()) {
    graph.set_inputs(Inputs().with(mesh_input, mesh));
    graph.set_settings(Settings().with("delta", 0.04));
  }
  template <class T>
  std::shared_ptr<const T> get(Key<T> key) {
    const auto outcome = graph.structure(key, progress);
    EXPECT_TRUE(outcome) << outcome.reason;
    return outcome.value;
  }
  Primitive_set layer(const char* id) {
    const auto outcome = graph.layer(id, progress);
    EXPECT_TRUE(outcome) << outcome.reason;
    return outcome ? *outcome.value : Primitive_set();
  }

  Graph graph;
  Progress progress;
};

double volume(const Delaunay_3& triangulation, int cell) {
  const auto& corners = triangulation.cells[cell];
  const auto to = [&](int i) { return triangulation.points[corners[i]] - triangulation.points[corners[0]]; };
  return dot(cross(to(1), to(2)), to(3)) / 6;
}

/// Cells with one sphere agree, and the boundary of the inner ones is closed and has their volume.
void expect_sound(Sides_graph& graph) {
  const auto triangulation = graph.get(delaunay_3_key);
  const auto sides = graph.get(voronoi_sides_3_key);
  ASSERT_EQ(sides->vertex_of_cell, cells_by_sphere(*triangulation, graph.progress));
  double inner = 0;
  for (std::size_t c = 0; c < triangulation->cells.size(); ++c) {
    EXPECT_EQ(sides->is_inner[c], sides->is_inner[sides->vertex_of_cell[c]]);
    if (sides->is_inner[c] != 0) inner += volume(*triangulation, static_cast<int>(c));
  }
  EXPECT_GT(inner, 0);
  std::map<std::array<int, 2>, int> turns;
  double enclosed = 0;
  for (const auto& triangle : boundary_of_inner_cells(*triangulation, *sides)) {
    for (int i = 0; i < 3; ++i) {
      const int a = triangle[i];
      const int b = triangle[(i + 1) % 3];
      turns[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
    const auto& p = triangulation->points;
    enclosed += dot(p[triangle[0]], cross(p[triangle[1]], p[triangle[2]])) / 6;
  }
  for (const auto& [edge, sum] : turns) EXPECT_EQ(sum, 0);
  EXPECT_NEAR(enclosed, inner, 1e-9 * inner);
}

double height_over_torus(const Point_3& p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; }

void expect_torus(Sides_graph& graph, double margin) {
  const auto triangulation = graph.get(delaunay_3_key);
  const auto sides = graph.get(voronoi_sides_3_key);
  int inner = 0;
  int outer = 0;
  for (std::size_t c = 0; c < triangulation->cells.size(); ++c) {
    const double height = height_over_torus(triangulation->circumcenters[c]);
    if (std::abs(height) < margin) continue;
    EXPECT_EQ(sides->is_inner[c] != 0, height < 0);
    ++(height < 0 ? inner : outer);
  }
  EXPECT_GT(inner, 200);
  EXPECT_GT(outer, 200);
}

TEST(Sides_3, AreThoseOfATorusGivenByAMesh) {
  Sides_graph graph(torus_mesh(1, 0.4, 64, 32));
  expect_torus(graph, 0.02);
  expect_sound(graph);
}

TEST(Sides_3, AreThoseOfATorusGivenByPoints) {
  Sides_graph graph(torus_cloud(1, 0.4, 2500, 3));
  expect_torus(graph, 0.1);
  expect_sound(graph);
}

TEST(Sides_3, OfAMeshAreThoseOfItsSolid) {
  Sides_graph graph(joined({box_mesh({0, 0, 0}, {3, 1, 1}), box_mesh({5, 0, 0}, {6, 1, 1})}));
  const auto triangulation = graph.get(delaunay_3_key);
  const auto sides = graph.get(voronoi_sides_3_key);
  const auto is_in_box = [](const Point_3& p, double from, double to, double margin) {
    return from + margin < p.x && p.x < to - margin && margin < p.y && p.y < 1 - margin && margin < p.z &&
           p.z < 1 - margin;
  };
  const auto is_in = [&](const Point_3& p, double margin) {
    return is_in_box(p, 0, 3, margin) || is_in_box(p, 5, 6, margin);
  };
  constexpr double rounding = 1e-9;
  for (std::size_t c = 0; c < triangulation->cells.size(); ++c) {
    const Point_3& p = triangulation->circumcenters[sides->vertex_of_cell[c]];
    if (is_in(p, rounding) == is_in(p, -rounding)) {
      EXPECT_EQ(sides->is_inner[c] != 0, is_in(p, 0));
    }
  }
  expect_sound(graph);
  EXPECT_EQ(topology(graph.layer("inner-delaunay"))->betti[0], 2);
}

void expect_sides_of_nearest_balls(const Delaunay_3& triangulation, const Polar_balls_3& polar,
                                   const Voronoi_sides_3& sides) {
  int inner = 0;
  for (std::size_t c = 0; c < triangulation.cells.size(); ++c) {
    if (sides.vertex_of_cell[c] != static_cast<int>(c)) continue;
    std::array<double, 2> least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (std::size_t p = 0; p < polar.regular->balls.size(); ++p) {
      const auto& [center, radius] = polar.regular->balls[p];
      const double away = distance(triangulation.circumcenters[c], center);
      double& side = least[polar.is_inner[p]];
      side = std::min(side, (away - radius) * (away + radius));
    }
    if (std::abs(least[0] - least[1]) < 1e-6) continue;
    EXPECT_EQ(sides.is_inner[c] != 0, least[1] < least[0]);
    inner += sides.is_inner[c];
  }
  EXPECT_GT(inner, 0);
}

TEST(Sides_3, OfPointsAreThoseOfTheNearestPole) {
  // Random points enclose nothing clear; the rule holds all the same.
  for (const Cloud& cloud : {random_cloud(300, 5), ellipsoid_cloud(200, 3), cube_surface(6), lattice(4)}) {
    Sides_graph graph(cloud);
    expect_sides_of_nearest_balls(*graph.get(delaunay_3_key), *graph.get(polar_balls_3_key),
                                  *graph.get(voronoi_sides_3_key));
  }
}

TEST(Sides_3, AreFoundFromHiddenPolesAsWell) {
  Sides_graph graph(torus_cloud(1, 0.4, 800, 3));
  const auto triangulation = graph.get(delaunay_3_key);
  Polar_balls_3 polar = *graph.get(polar_balls_3_key);
  std::vector<Ball_3> balls = polar.poles->balls;
  for (std::size_t p = 0; p < polar.poles->finite_count; ++p)
    if (p % 3 != 0) balls[p].radius *= 0.1;
  polar.regular = std::make_shared<const Regular_3>(regular_triangulation(balls, graph.progress));
  EXPECT_GT(std::ranges::count(polar.regular->cell_of_ball, -1), 50);
  expect_sides_of_nearest_balls(*triangulation, polar, sides_of_power_crust(*triangulation, polar, graph.progress));
}

TEST(Sides_3, AreSoundForPointsOnSpheresAndLattices) {
  for (const Cloud& cloud : {cube_surface(5), cube_surface(2), sphere_cloud({0, 0, 1}, 2, 200, 1), lattice(3)}) {
    Sides_graph graph(cloud);
    expect_sound(graph);
  }
}

TEST(Sides_3, CellsWithOneSphereAgreeWhateverRoundingMakesOfTheirCenters) {
  // All on the sphere around (1/3, 1/3, 1/3), which is on the surface of the solid, to rounding.
  const Cloud cloud{{3, 0, 0},   {0, 3, 0},   {0, 0, 3},   {-2, -1, 0}, {-2, 0, -1}, {-1, -2, 0},
                    {-1, 0, -2}, {0, -2, -1}, {0, -1, -2}, {2, 2, -1},  {2, -1, 2},  {-1, 2, 2}};
  Progress progress;
  const Delaunay_3 triangulation = delaunay(cloud, progress);
  std::set<double> centers;
  for (const Point_3& center : triangulation.circumcenters) centers.insert(center.x);
  ASSERT_GT(centers.size(), 1u);
  for (const double face : centers) {
    const Solid_3 solid = solid_of(box_mesh({face, -5, -5}, {5, 5, 5}));
    const Voronoi_sides_3 sides = sides_of_solid(triangulation, solid, progress);
    EXPECT_THAT(sides.vertex_of_cell, testing::Each(0));
    EXPECT_THAT(sides.is_inner, testing::Each(sides.is_inner[0]));
  }
}

TEST(Sides_3, VoronoiVerticesAreOnceInOneOfTheLayers) {
  Sides_graph graph(cube_surface(5));
  const auto triangulation = graph.get(delaunay_3_key);
  const auto sides = graph.get(voronoi_sides_3_key);
  std::vector<std::int64_t> cells;
  for (const char* id : {"inner-voronoi-vertices", "outer-voronoi-vertices"}) {
    const Primitive_set set = graph.layer(id);
    const Values* radius = set.find_values("radius");
    ASSERT_NE(radius, nullptr);
    for (std::size_t i = 0; i < set.points.size(); ++i) {
      cells.push_back(set.id(i));
      const Point_3& p = set.vertices[set.points[i]];
      double nearest = std::numeric_limits<double>::infinity();
      for (const Point_3& sample : triangulation->points) nearest = std::min(nearest, distance(p, sample));
      EXPECT_NEAR(radius->data[i], nearest, 1e-9 * nearest);
      EXPECT_EQ(set.radii[set.points[i]], radius->data[i]);
    }
  }
  std::ranges::sort(cells);
  std::vector<std::int64_t> expected(sides->vertex_of_cell.begin(), sides->vertex_of_cell.end());
  std::ranges::sort(expected);
  expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
  EXPECT_EQ(cells, expected);
}

TEST(Sides_3, InnerVoronoiFacesHaveTheAnglesOfTheirSamples) {
  Sides_graph graph(ellipsoid_cloud(600, 4));
  const Primitive_set set = graph.layer("inner-voronoi");
  const auto triangulation = graph.get(delaunay_3_key);
  const auto sides = graph.get(voronoi_sides_3_key);
  std::size_t expected = 0;
  const Voronoi_faces_3 all = bounded_voronoi_faces(*triangulation, graph.progress);
  for (std::size_t f = 0; f < all.size(); ++f)
    expected += std::ranges::all_of(all.face(f), [&](int v) { return sides->is_inner[v] != 0; }) ? 1 : 0;
  ASSERT_EQ(set.polygon_count(), expected);
  ASSERT_GT(expected, 100u);
  const Values* angle = set.find_values("angle");
  const Values* lambda = set.find_values("lambda");
  ASSERT_TRUE(angle != nullptr && lambda != nullptr);
  ASSERT_EQ(set.radii.size(), set.vertices.size());
  for (std::size_t f = 0; f < set.polygon_count(); ++f) {
    const auto corners = set.polygon(f);
    Point_3 middle;
    for (const int v : corners) middle = middle + (1.0 / static_cast<double>(corners.size())) * set.vertices[v];
    std::vector<std::pair<double, int>> nearest;
    for (int s = 0; s < 600; ++s) nearest.emplace_back(distance(triangulation->points[s], middle), s);
    std::ranges::sort(nearest);
    const Point_3& p = triangulation->points[nearest[0].second];
    const Point_3& q = triangulation->points[nearest[1].second];
    EXPECT_NEAR(lambda->data[f], distance(p, q) / 2, 1e-12);
    const auto angle_at = [&](const Point_3& x) {
      const double cosine = dot(p - x, q - x) / (distance(p, x) * distance(q, x));
      return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
    };
    double largest = 0;
    constexpr int steps = 40;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point_3& a = set.vertices[corners[i]];
      const Point_3& b = set.vertices[corners[(i + 1) % corners.size()]];
      for (int k = 0; k <= steps; ++k)
        for (int out = 0; out <= steps; ++out) {
          const Point_3 rim = a + (static_cast<double>(k) / steps) * (b - a);
          largest = std::max(largest, angle_at(middle + (static_cast<double>(out) / steps) * (rim - middle)));
        }
    }
    EXPECT_LE(largest, angle->data[f] + 1e-4);
    EXPECT_NEAR(largest, angle->data[f], 3);
  }
}

TEST(Sides_3, HaveAReasonWhereThereIsNothing) {
  Graph graph(make_registry_3());
  Progress progress;
  const std::vector<Ball_3> balls{{{0, 0, 0}, 1}};
  for (const Inputs& inputs : {Inputs(), Inputs().with(balls_input, balls),
                               Inputs().with(cloud_input, Cloud{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})}) {
    graph.set_inputs(inputs);
    for (const char* id : {"inner-voronoi-vertices", "outer-voronoi-vertices", "inner-delaunay", "inner-voronoi"}) {
      const auto layer = graph.layer(id, progress);
      EXPECT_FALSE(layer) << id;
      EXPECT_THAT(layer.reason,
                  testing::AnyOf(testing::HasSubstr("there are neither"), testing::HasSubstr("one plane")));
    }
  }
}

}  // namespace
}  // namespace mesecina::test
