// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing, noise, growing and shrinking in space.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../shapes.h"
#include "evolving.h"
#include "geometries/evolution_settings.h"
#include "geometries/evolutions_3/mesh_vertices_3.h"
#include "geometries/modules_3.h"
#include "geometries/samples_3/module.h"
#include "geometries/union_3/module.h"

namespace mesecina::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Balls = std::vector<Ball_3>;
using Cloud = std::vector<Point_3>;

Evolved evolved_3(Inputs inputs, const std::string& id, std::uint64_t steps, Settings settings = {}) {
  return run_steps(make_registry_3(), std::move(inputs), id, steps, std::move(settings));
}

Inputs with_mesh(Triangle_mesh_3 mesh) { return Inputs().with(mesh_input, std::move(mesh)); }
Inputs with_balls(Balls balls) { return Inputs().with(balls_input, std::move(balls)); }
double norm(const Point_3& p) { return std::sqrt(dot(p, p)); }

/// Of radius 1.
Triangle_mesh_3 icosahedron() {
  const double g = std::numbers::phi;
  Triangle_mesh_3 mesh;
  mesh.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                   {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Point_3& p : mesh.vertices) p = (1 / norm(p)) * p;
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

/// Each triangle with vertices of its own.
Triangle_mesh_3 torn(const Triangle_mesh_3& mesh) {
  Triangle_mesh_3 result;
  for (const auto& t : mesh.triangles) {
    const int first = static_cast<int>(result.vertices.size());
    for (const int v : t) result.vertices.push_back(mesh.vertices[v]);
    result.triangles.push_back({first, first + 1, first + 2});
  }
  return result;
}

/// Four triangles for one, on the sphere; `times` times.
Triangle_mesh_3 sphere(int times) {
  Triangle_mesh_3 mesh = icosahedron();
  for (int i = 0; i < times; ++i) {
    Triangle_mesh_3 finer;
    finer.vertices = mesh.vertices;
    for (const auto& t : mesh.triangles) {
      const int first = static_cast<int>(finer.vertices.size());
      for (int k = 0; k < 3; ++k) {
        const Point_3 middle = midpoint(mesh.vertices[t[k]], mesh.vertices[t[(k + 1) % 3]]);
        finer.vertices.push_back((1 / norm(middle)) * middle);
      }
      finer.triangles.push_back({t[0], first, first + 2});
      finer.triangles.push_back({t[1], first + 1, first});
      finer.triangles.push_back({t[2], first + 2, first + 1});
      finer.triangles.push_back({first, first + 1, first + 2});
    }
    mesh = std::move(finer);
  }
  return mesh;
}

/// Of 2 n^2 triangles in the unit square, bulged upwards.
Triangle_mesh_3 sheet(int n, double bulge) {
  Triangle_mesh_3 mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double x = double(i) / n;
      const double y = double(j) / n;
      mesh.vertices.push_back({x, y, bulge * x * (1 - x) * y * (1 - y)});
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int v = i * (n + 1) + j;
      mesh.triangles.push_back({v, v + n + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + 1});
    }
  return mesh;
}

TEST(Laplacian_smoothing_3, AnIcosahedronShrinksByTheCosineOfItsEdges) {
  // The five neighbours of a vertex have their mean at 1 / sqrt(5) of it.
  for (const double factor : {0.5, 0.2, 1.0}) {
    const double radius = std::pow(1 - factor * (1 - 1 / std::sqrt(5.0)), 3);
    const Settings settings = Settings().with("smoothing-factor", factor);
    for (const Triangle_mesh_3& mesh : {icosahedron(), torn(icosahedron())}) {
      const Evolved result = evolved_3(with_mesh(mesh), "laplacian-smoothing", 3, settings);
      ASSERT_EQ(result[mesh_input].triangles, mesh.triangles);
      for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        EXPECT_LT(distance(result[mesh_input].vertices[v], radius * mesh.vertices[v]), 1e-14);
    }
  }
}

TEST(Laplacian_smoothing_3, WithKeptSizeASphereStaysAndNoiseGoes) {
  const Triangle_mesh_3 rough =
      evolved_3(with_mesh(sphere(3)), "noise", 1, Settings().with("noise-amplitude", 0.3))[mesh_input];
  const auto unevenness = [](const Triangle_mesh_3& mesh) {
    double most = 0;
    double least = 9;
    for (const Point_3& p : mesh.vertices) {
      most = std::max(most, norm(p));
      least = std::min(least, norm(p));
    }
    return most - least;
  };
  const auto mean = [](const Triangle_mesh_3& mesh) {
    double sum = 0;
    for (const Point_3& p : mesh.vertices) sum += norm(p);
    return sum / static_cast<double>(mesh.vertices.size());
  };
  const Evolved kept =
      evolved_3(with_mesh(rough), "laplacian-smoothing", 40, Settings().with("smoothing-keeps-size", true));
  EXPECT_NEAR(mean(kept[mesh_input]), mean(rough), 0.02);
  EXPECT_LT(unevenness(kept[mesh_input]), unevenness(rough) / 2);
  const Evolved shrunk = evolved_3(with_mesh(rough), "laplacian-smoothing", 40);
  EXPECT_LT(mean(shrunk[mesh_input]), 0.8);
}

TEST(Laplacian_smoothing_3, ASheetKeepsItsCornersCurveAndIsDrawnFlat) {
  const Triangle_mesh_3 mesh = sheet(8, 3);
  const Evolved result = evolved_3(with_mesh(mesh), "laplacian-smoothing", 3);
  double highest = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Point_3& before = mesh.vertices[v];
    const Point_3& after = result[mesh_input].vertices[v];
    const bool is_at_end = before.x == 0 || before.x == 1 || before.y == 0 || before.y == 1;
    if (is_at_end) {
      EXPECT_EQ(after.z, 0);
      // Sides stay on their line except near corners.
      if (before.x == 0 && std::abs(before.y - 0.5) < 0.1) {
        EXPECT_EQ(after, before);
      }
    }
    highest = std::max(highest, after.z);
  }
  EXPECT_LT(highest, 0.95 * 3 / 16);
  EXPECT_GT(highest, 0.3 * 3 / 16);
}

TEST(Laplacian_smoothing_3, LooseVerticesAndEndlessTrianglesDoNotMatter) {
  Triangle_mesh_3 mesh = icosahedron();
  mesh.vertices.push_back({5, 5, 5});
  mesh.vertices.push_back({std::numeric_limits<double>::infinity(), 0, 0});
  mesh.triangles.push_back({0, 1, 13});
  mesh.triangles.push_back({3, 3, 3});
  const Evolved result = evolved_3(with_mesh(mesh), "laplacian-smoothing", 2);
  EXPECT_EQ(result[mesh_input].vertices[12], (Point_3{5, 5, 5}));
  EXPECT_TRUE(std::isinf(result[mesh_input].vertices[13].x));
  const Evolved plain = evolved_3(with_mesh(icosahedron()), "laplacian-smoothing", 2);
  for (int v = 0; v < 12; ++v) EXPECT_EQ(result[mesh_input].vertices[v], plain[mesh_input].vertices[v]);
}

TEST(Noise_3, MovesVerticesAlongNormalsWithinTheAmplitude) {
  const Triangle_mesh_3 before = icosahedron();
  const double edge = distance(before.vertices[0], before.vertices[1]);
  for (const Triangle_mesh_3& mesh : {before, torn(before)}) {
    const Evolved result = evolved_3(with_mesh(mesh), "noise", 1, Settings().with("noise-amplitude", 0.2));
    const Cloud& after = result[mesh_input].vertices;
    double farthest = 0;
    for (std::size_t v = 0; v < after.size(); ++v) {
      const double moved = norm(after[v]) - 1;
      EXPECT_LT(distance(after[v], (1 + moved) * mesh.vertices[v]), 1e-12);
      EXPECT_LE(std::abs(moved), 0.2 * edge);
      farthest = std::max(farthest, std::abs(moved));
      for (std::size_t w = 0; w < v; ++w)
        if (mesh.vertices[v] == mesh.vertices[w]) {
          EXPECT_EQ(after[v], after[w]);
        }
    }
    EXPECT_GT(farthest, 0.1 * edge);
  }
}

TEST(Noise_3, MovesPointsWithinTheirDistanceAndBallsWithinTheirRadius) {
  const Cloud cloud = {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {9, 9, 9}, {9, 9, 9}};
  const Balls balls = {{{1, 1, 1}, 2}, {{4, 4, 4}, 0}};
  const Evolved result = evolved_3(Inputs().with(cloud_input, cloud).with(balls_input, balls), "noise", 1);
  const Cloud& after = result[cloud_input];
  const std::vector<double> reaches = {0.1, 0.1, 0.4, 0, 0};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    EXPECT_LE(std::abs(after[i].x - cloud[i].x), reaches[i]);
    EXPECT_LE(std::abs(after[i].y - cloud[i].y), reaches[i]);
    EXPECT_LE(std::abs(after[i].z - cloud[i].z), reaches[i]);
    EXPECT_EQ(after[i] == cloud[i], reaches[i] == 0);
  }
  EXPECT_NE(result[balls_input][0].center, balls[0].center);
  EXPECT_LE(distance(result[balls_input][0].center, balls[0].center), 0.2 * std::sqrt(3.0));
  EXPECT_EQ(result[balls_input][0].radius, 2);
  EXPECT_EQ(result[balls_input][1], balls[1]);
}

TEST(Noise_3, IsTheSameForTheSameSeed) {
  const Inputs inputs =
      with_mesh(sphere(1)).with(cloud_input, sphere(1).vertices).with(balls_input, Balls{{{0, 0, 0}, 1}});
  const Settings five = Settings().with("evolution-seed", std::int64_t{5});
  const Evolved once = evolved_3(inputs, "noise", 3, five);
  const Evolved again = evolved_3(inputs, "noise", 3, five);
  EXPECT_EQ(once[mesh_input], again[mesh_input]);
  EXPECT_EQ(once[cloud_input], again[cloud_input]);
  EXPECT_EQ(once[balls_input], again[balls_input]);
  EXPECT_NE(once[mesh_input], evolved_3(inputs, "noise", 3)[mesh_input]);
}

const Balls three_balls = {{{0, 0, 0}, 1}, {{1.5, 0, 0}, 0.7}, {{0.5, 1, 0.2}, 0.5}};

TEST(Growing_3, StepsAddUpToPercentsOfTheFirstRadius) {
  // What moves balls for those who look at them is not made part of them.
  const Settings settings = Settings().with("growing-step", 4.0).with("given-perturbation", 1e-3);
  const Evolved grown = evolved_3(with_balls(three_balls), "grow-balls", 50, settings);
  const Evolved shrunk = evolved_3(with_balls(three_balls), "shrink-balls", 1000, settings.with("growing-step", 10.0));
  EXPECT_EQ(shrunk.result.steps_done, 9u);
  EXPECT_THAT(shrunk.result.end_reason, HasSubstr("shrunk to nothing"));
  for (std::size_t i = 0; i < three_balls.size(); ++i) {
    EXPECT_EQ(grown[balls_input][i].center, three_balls[i].center);
    EXPECT_NEAR(grown[balls_input][i].radius, 3 * three_balls[i].radius, 1e-13);
    EXPECT_NEAR(shrunk[balls_input][i].radius, 0.1 * three_balls[i].radius, 1e-13);
  }
}

TEST(Growing_3, OfAMeshGrowsTheBallsThatStandForIt) {
  Graph graph(make_registry_3());
  graph.set_settings(Settings().with("delta", 0.05));
  graph.set_inputs(with_mesh(sphere(2)));
  Progress progress;
  const auto balls = graph.structure(balls_3_key, progress);
  ASSERT_TRUE(balls) << balls.reason;
  const Evolved result = evolved_3(graph.inputs(), "grow-balls", 2, graph.settings());
  ASSERT_EQ(result[balls_input].size(), balls.value->size());
  for (std::size_t i = 0; i < balls.value->size(); ++i) {
    EXPECT_EQ(result[balls_input][i].center, (*balls.value)[i].center);
    EXPECT_NEAR(result[balls_input][i].radius, 1.06 * (*balls.value)[i].radius, 1e-12);
  }
  graph.set_inputs(result.inputs);
  graph.set_settings(result.settings);
  EXPECT_EQ(*graph.structure(balls_3_key, progress).value, result[balls_input]);
}

TEST(Stepped_growing_3, AStepGrowsTheMedialBallsAndStepsGrowMore) {
  Graph graph(make_registry_3());
  graph.set_inputs(with_balls(three_balls));
  Progress progress;
  const auto axis = graph.structure(medial_axis_3_key, progress);
  ASSERT_TRUE(axis);
  const Settings exact =
      Settings().with("growing-step", 10.0).with("scale-axis-min-angle", 0.0).with("perturbation", 0.0);
  const Evolved once = evolved_3(with_balls(three_balls), "stepped-growing", 1, exact);
  ASSERT_EQ(once[balls_input].size(), axis.value->centers.size());
  for (std::size_t i = 0; i < axis.value->centers.size(); ++i) {
    EXPECT_EQ(once[balls_input][i].center, axis.value->centers[i]);
    EXPECT_NEAR(once[balls_input][i].radius, 1.1 * axis.value->radii[i], 1e-13);
  }
  const Evolved more = evolved_3(with_balls(three_balls), "stepped-growing", 6);
  EXPECT_EQ(more.result.steps_done, 6u) << more.result.end_reason;
  double largest = 0;
  for (const Ball_3& ball : more[balls_input]) largest = std::max(largest, ball.radius);
  EXPECT_NEAR(largest, std::pow(1.03, 6), 1e-9);
}

TEST(Stepped_growing_3, KeepsTheTopologyOfAMeshAndDoesNotExplode) {
  Triangle_mesh_3 potato = sphere(3);
  for (Point_3& p : potato.vertices) p = {p.x * (1.5 + 0.3 * p.y), p.y, p.z * (0.6 + 0.2 * p.x)};
  Graph graph(make_registry_3());
  graph.set_inputs(with_mesh(potato));
  graph.set_settings(Settings().with("delta", 0.05));
  Progress progress;
  ASSERT_EQ(evolve(graph, "stepped-growing", 1, progress).steps_done, 1u);
  const std::size_t after_one = graph.inputs().get(balls_input)->size();
  EXPECT_EQ(std::get<std::string>(*graph.settings().find("ball-source")), "given");
  ASSERT_EQ(evolve(graph, "stepped-growing", 4, progress).steps_done, 4u);
  EXPECT_LT(graph.inputs().get(balls_input)->size(), 10 * after_one);
  const auto axis = graph.layer("medial-axis", progress);
  ASSERT_TRUE(axis);
  EXPECT_TRUE(graph.warnings("medial-axis").empty());
  EXPECT_EQ(topology(*axis.value)->betti, (std::array<std::int64_t, 3>{1, 0, 0}));
}

TEST(Evolutions_3, SayWhyThereIsNothingToChange) {
  EXPECT_THAT(evolved_3({}, "laplacian-smoothing", 1).result.end_reason, HasSubstr("no mesh"));
  EXPECT_THAT(evolved_3({}, "noise", 1).result.end_reason, HasSubstr("nothing to move"));
  for (const char* id : {"grow-balls", "shrink-balls", "stepped-growing"}) {
    const Evolved nothing = evolved_3({}, id, 1);
    EXPECT_NE(nothing.result.end_reason, "") << id;
    EXPECT_THAT(nothing.result.end_reason, testing::Not(HasSubstr("internal"))) << id;
    EXPECT_EQ(evolved_3(with_balls(three_balls), id, 2, Settings().with("growing-step", 0.0)).result.end_reason,
              "nothing changes any more");
    const Evolved point = evolved_3(with_balls({{{1, 2, 3}, 0}}), id, 2);
    EXPECT_THAT(point.result.end_reason, testing::Not(HasSubstr("internal"))) << id;
  }
}

}  // namespace
}  // namespace mesecina::test
