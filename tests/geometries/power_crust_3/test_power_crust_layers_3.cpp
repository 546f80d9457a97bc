// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/graph.h"
#include "geometries/modules_3.h"
#include "geometries/power_crust_3/module.h"
#include "geometries/samples_3/module.h"
#include "tests/geometries/power_crust_3/delaunay_oracle_3.h"

namespace mesecina::test {
namespace {

class Cloud_graph {
 public:
  explicit Cloud_graph(const Cloud& cloud) : graph(make_registry_3()) {
    graph.set_inputs(Inputs().with(cloud_input, cloud));
  }
  Outcome<Primitive_set> layer(const char* id) { return graph.layer(id, progress); }

  Graph graph;
  Progress progress;
};

TEST(Power_crust_layers_3, DelaunayTrianglesKnowTheirSmallestEmptyBall) {
  const Cloud cloud = random_cloud(25, 4);
  Cloud_graph graph(cloud);
  const auto layer = graph.layer("delaunay");
  ASSERT_TRUE(layer) << layer.reason;
  EXPECT_EQ(topology(*layer.value), (Topology{1, {1, 0, 0}}));
  const Values* radius = layer.value->find_values("radius");
  ASSERT_NE(radius, nullptr);
  ASSERT_EQ(layer.value->vertices, cloud);
  const auto spheres = empty_spheres(cloud);
  int gabriel = 0;
  std::set<std::array<int, 3>> found;
  for (std::size_t t = 0; t < layer.value->triangles.size(); ++t) {
    auto corners = layer.value->triangles[t];
    std::ranges::sort(corners);
    EXPECT_TRUE(found.insert(corners).second);
    double least = std::numeric_limits<double>::infinity();
    for (const Contacts& sphere : spheres)
      if (std::ranges::includes(sphere, corners)) least = std::min(least, radius_of(cloud, sphere));
    ASSERT_LT(least, std::numeric_limits<double>::infinity());
    const Point_3 a = cloud[corners[1]] - cloud[corners[0]];
    const Point_3 b = cloud[corners[2]] - cloud[corners[0]];
    const Point_3 n = cross(a, b);
    const Point_3 center = cloud[corners[0]] + (1 / (2 * dot(n, n))) * cross(dot(a, a) * b - dot(b, b) * a, n);
    const double own = distance(center, cloud[corners[0]]);
    const bool is_empty =
        std::ranges::none_of(cloud, [&](const Point_3& p) { return distance(p, center) < own - 1e-9; });
    gabriel += is_empty ? 1 : 0;
    EXPECT_NEAR(radius->data[t], is_empty ? own : least, 1e-9);
  }
  EXPECT_GT(gabriel, 10);
  EXPECT_GT(static_cast<int>(found.size()), gabriel + 10);
  std::set<std::array<int, 3>> expected;
  for (const Contacts& sphere : spheres)
    for (int i = 0; i < 4; ++i) {
      Contacts rest = sphere;
      rest.erase(rest.begin() + i);
      expected.insert({rest[0], rest[1], rest[2]});
    }
  EXPECT_EQ(found, expected);
}

TEST(Power_crust_layers_3, VoronoiFacesAreEquallyFarFromTwoSamples) {
  const Cloud cloud = random_cloud(100, 6);
  Cloud_graph graph(cloud);
  const auto layer = graph.layer("voronoi");
  ASSERT_TRUE(layer) << layer.reason;
  const Values* distances = layer.value->find_values("distance");
  ASSERT_NE(distances, nullptr);
  ASSERT_GT(layer.value->polygon_count(), 100u);
  for (std::size_t f = 0; f < layer.value->polygon_count(); ++f) {
    Point_3 middle;
    const auto corners = layer.value->polygon(f);
    for (const int v : corners)
      middle = middle + (1.0 / static_cast<double>(corners.size())) * layer.value->vertices[v];
    std::vector<std::pair<double, int>> nearest;
    for (int s = 0; s < 100; ++s) nearest.emplace_back(distance(cloud[s], middle), s);
    std::ranges::sort(nearest);
    EXPECT_NEAR(nearest[0].first, nearest[1].first, 1e-9 * nearest[0].first);
    EXPECT_NEAR(distances->data[f], distance(cloud[nearest[0].second], cloud[nearest[1].second]), 1e-12);
  }
}

TEST(Power_crust_layers_3, PolesTouchTheirSample) {
  const Cloud cloud = torus_cloud(1, 0.4, 800, 3);
  Cloud_graph graph(cloud);
  std::size_t count = 0;
  for (const char* id : {"inner-poles", "outer-poles"}) {
    const auto layer = graph.layer(id);
    ASSERT_TRUE(layer) << layer.reason;
    const Values* sample = layer.value->find_values("sample");
    ASSERT_NE(sample, nullptr);
    ASSERT_NE(layer.value->find_values("confidence"), nullptr);
    ASSERT_NE(layer.value->find_values("radius"), nullptr);
    count += layer.value->balls.size();
    for (std::size_t b = 0; b < layer.value->balls.size(); ++b) {
      const auto& [center, radius] = layer.value->balls[b];
      const Point_3& c = layer.value->vertices[center];
      EXPECT_NEAR(distance(c, cloud[static_cast<std::size_t>(sample->data[b])]), radius, 1e-9 * radius);
      EXPECT_EQ(std::hypot(std::hypot(c.x, c.y) - 1, c.z) < 0.4, std::string(id) == "inner-poles");
    }
  }
  const auto polar = graph.graph.structure(polar_balls_3_key, graph.progress);
  ASSERT_TRUE(polar);
  EXPECT_EQ(count, polar.value->poles->finite_count);
}

TEST(Power_crust_layers_3, ACloudGoesThroughAllStages) {
  Cloud_graph graph(torus_cloud(1, 0.4, 2500, 8));
  const std::array<std::int64_t, 3> of_solid{1, 1, 0};
  for (const char* id : {"power-shape", "dual", "medial-axis", "scale-axis"}) {
    const auto layer = graph.layer(id);
    ASSERT_TRUE(layer) << id << ": " << layer.reason;
    const auto found = topology(*layer.value);
    ASSERT_TRUE(found) << id;
    EXPECT_EQ(found->betti, of_solid) << id;
  }
  const auto crust = graph.layer("power-crust");
  ASSERT_TRUE(crust) << crust.reason;
  EXPECT_EQ(topology(*crust.value), (Topology{0, {1, 2, 1}}));
  const auto balls = graph.layer("balls");
  ASSERT_TRUE(balls) << balls.reason;
  EXPECT_EQ(balls.value->balls.size(), graph.layer("inner-poles").value->balls.size());
}

TEST(Power_crust_layers_3, PerturbationMovesBallsAlone) {
  Cloud_graph graph(ellipsoid_cloud(400, 2));
  ASSERT_TRUE(graph.layer("balls"));
  graph.graph.set_settings(Settings().with("perturbation", 1e-3));
  ASSERT_TRUE(graph.layer("balls"));
  EXPECT_EQ(graph.graph.computations("polar-balls-3"), 1u);
  EXPECT_EQ(graph.graph.computations("balls-3"), 2u);
}

TEST(Power_crust_layers_3, AMeshComesBeforePoints) {
  Triangle_mesh_3 mesh;
  mesh.vertices = lattice(2);
  mesh.triangles = {{0, 1, 2}, {1, 3, 2}, {4, 6, 5}, {5, 6, 7}, {0, 4, 1}, {1, 4, 5},
                    {2, 3, 6}, {3, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}};
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(mesh_input, mesh).with(cloud_input, random_cloud(50, 1)));
  graph.set_settings(Settings().with("delta", 0.05));
  Progress progress;
  const auto samples = graph.structure(surface_samples_3_key, progress);
  ASSERT_TRUE(samples) << samples.reason;
  const auto polar = graph.structure(polar_balls_3_key, progress);
  ASSERT_TRUE(polar) << polar.reason;
  EXPECT_EQ(polar.value->poles->sample_count, samples.value->points.size());
  const auto crust = graph.layer("power-crust", progress);
  ASSERT_TRUE(crust) << crust.reason;
  EXPECT_EQ(topology(*crust.value), (Topology{2, {1, 0, 1}}));
}

TEST(Power_crust_layers_3, EachHasAReasonForTooFewPoints) {
  struct Case {
    Cloud cloud;
    std::string reason;
  };
  const std::vector<Case> cases{{{{0, 0, 0}}, "there is 1"},
                                {{{0, 0, 0}, {1, 0, 0}}, "there are 2"},
                                {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "there are 3"},
                                {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, "one plane"},
                                {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, "one line"}};
  for (const auto& [cloud, reason] : cases) {
    Cloud_graph graph(cloud);
    for (const char* id :
         {"delaunay", "voronoi", "inner-poles", "outer-poles", "power-crust", "power-shape", "balls"}) {
      const auto layer = graph.layer(id);
      EXPECT_FALSE(layer) << id;
      EXPECT_THAT(layer.reason, testing::HasSubstr(reason)) << id;
    }
  }
}

TEST(Power_crust_layers_3, WarnsOfEqualPoints) {
  Cloud_graph graph(joined(ellipsoid_cloud(300, 2), ellipsoid_cloud(300, 2)));
  for (const char* id : {"delaunay", "power-crust"}) {
    ASSERT_TRUE(graph.layer(id));
    EXPECT_THAT(graph.graph.warnings(id), testing::Contains(testing::HasSubstr("300 of 600 samples equal another one")))
        << id;
  }
}

}  // namespace
}  // namespace mesecina::test
