// SPDX-License-Identifier: GPL-3.0-or-later
// What the modules of space promise: ids, labels and help for all they declare, and layers that compute without a
// window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/evolution.h"
#include "geometries/modules_2.h"
#include "geometries/modules_3.h"

namespace mesecina {
namespace {

/// A closed torus, slightly bent so that nothing is symmetric.
Triangle_mesh_3 torus() {
  constexpr int around = 24;
  constexpr int across = 12;
  Triangle_mesh_3 mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around;
      const double v = 2 * std::numbers::pi * j / across;
      const double r = 1 + 0.4 * std::cos(v) + 0.03 * std::sin(3 * u + v);
      mesh.vertices.push_back({r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v) + 0.05 * std::cos(2 * u)});
    }
  }
  const auto vertex = [](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

/// A tetrahedron of balls, a chain, a triangle, and one alone.
std::vector<Ball_3> balls_of_all_kinds() {
  return {{{0, 0, 0}, 1},   {{1.1, 0, 0}, 1}, {{0.5, 1, 0}, 1},   {{0.5, 0.3, 0.9}, 1}, {{2.9, 0, 0}, 1},
          {{4.5, 0, 0}, 1}, {{6, 0, 0}, 1},   {{5.4, 1, 0}, 0.9}, {{20, 0, 0}, 1}};
}

const std::set<std::string> promised_layers_3 = {"mesh",
                                                 "samples",
                                                 "delaunay",
                                                 "voronoi",
                                                 "convex-hull",
                                                 "gabriel-complex",
                                                 "inner-poles",
                                                 "outer-poles",
                                                 "power-crust",
                                                 "power-shape",
                                                 "polar-pairs",
                                                 "label-conflicts",
                                                 "polar-triangulation",
                                                 "inner-voronoi-vertices",
                                                 "outer-voronoi-vertices",
                                                 "inner-delaunay",
                                                 "inner-voronoi",
                                                 "balls",
                                                 "regular-triangulation",
                                                 "power-diagram",
                                                 "dual-faces",
                                                 "dual-triangles",
                                                 "dual-edges",
                                                 "dual-singular-triangles",
                                                 "dual-singular-edges",
                                                 "dual-singular-vertices",
                                                 "union-vertices",
                                                 "union-vertices-origin",
                                                 "union-vertices-delaunay",
                                                 "union-voronoi-interior",
                                                 "medial-axis",
                                                 "medial-contacts",
                                                 "lambda-medial-axis",
                                                 "angle-medial-axis",
                                                 "scale-medial-axis",
                                                 "sheets",
                                                 "seams",
                                                 "rims",
                                                 "junctions",
                                                 "scale-axis-seams",
                                                 "scale-axis-rims",
                                                 "scale-axis-junctions",
                                                 "scale-axis",
                                                 "scale-axis-balls"};

TEST(Registry_3, EveryEntryHasALabelAndItsOwnHelp) {
  const auto registry = make_registry_3();
  std::set<std::string> helps;
  std::set<std::string> ids;
  const auto check = [&](const std::string& id, const std::string& label, const std::string& help) {
    EXPECT_THAT(id, testing::MatchesRegex("[a-z0-9]+(-[a-z0-9]+)*"));
    EXPECT_FALSE(label.empty()) << id;
    EXPECT_GE(help.size(), 20u) << id;
    EXPECT_TRUE(helps.insert(help).second) << id << " has the help of another entry";
    EXPECT_NE(registry->module_of(id), nullptr) << id;
    ids.insert(id);
  };
  for (const Layer_spec& layer : registry->layers()) check(layer.id, layer.label, layer.help);
  for (const Setting_spec& setting : registry->settings()) check(setting.id, setting.label, setting.help);
  for (const Evolution_spec& evolution : registry->evolutions()) {
    check(evolution.id, evolution.label, evolution.help);
    for (const std::string& id : evolution.settings) EXPECT_NE(registry->find_setting(id), nullptr) << evolution.id;
  }
  for (const std::string& id : promised_layers_3) EXPECT_TRUE(ids.contains(id)) << id;
  EXPECT_EQ(registry->dimension(), 3);
}

void expect_layers(const Inputs& inputs, const std::set<std::string>& without_value) {
  const auto registry = make_registry_3();
  Graph graph(registry);
  graph.set_inputs(inputs);
  graph.set_settings(Settings().with("delta", 0.05));
  Progress progress;
  for (const Layer_spec& layer : registry->layers()) {
    const auto outcome = graph.layer(layer.id, progress);
    if (without_value.contains(layer.id)) {
      EXPECT_FALSE(outcome) << layer.id;
      EXPECT_FALSE(outcome.reason.empty()) << layer.id;
      continue;
    }
    ASSERT_TRUE(outcome) << layer.id << ": " << outcome.reason;
    EXPECT_EQ(outcome.value->dimension, 3) << layer.id;
    for (const Values& values : outcome.value->values)
      EXPECT_EQ(values.data.size(), outcome.value->element_count()) << layer.id << " " << values.name;
    if (const auto cut = registry->cut(layer, {})) {
      EXPECT_NE(outcome.value->find_values(cut->value), nullptr) << layer.id;
    }
    if (!outcome.value->radii.empty()) {
      EXPECT_EQ(outcome.value->radii.size(), outcome.value->vertices.size()) << layer.id;
    }
  }
}

TEST(Registry_3, EveryLayerIsComputedOfAMesh) {
  expect_layers(Inputs().with(mesh_input, torus()), {"points", "given-balls"});
}

TEST(Registry_3, EveryLayerIsComputedOfBalls) {
  expect_layers(Inputs().with(balls_input, balls_of_all_kinds()), {"mesh",
                                                                   "points",
                                                                   "solid",
                                                                   "samples",
                                                                   "delaunay",
                                                                   "voronoi",
                                                                   "convex-hull",
                                                                   "gabriel-complex",
                                                                   "inner-poles",
                                                                   "outer-poles",
                                                                   "power-crust",
                                                                   "power-shape",
                                                                   "polar-pairs",
                                                                   "label-conflicts",
                                                                   "polar-triangulation",
                                                                   "power-diagram",
                                                                   "outer-voronoi-vertices",
                                                                   "inner-voronoi-vertices",
                                                                   "inner-delaunay",
                                                                   "inner-voronoi"});
}

TEST(Registry_3, EveryLayerIsComputedOfPoints) {
  expect_layers(Inputs().with(cloud_input, torus().vertices), {"mesh", "given-balls", "solid", "samples"});
}

TEST(Registry_3, EveryLayerHasAReasonWhereThereIsNothing) {
  const auto registry = make_registry_3();
  Graph graph(registry);
  Progress progress;
  for (const Layer_spec& layer : registry->layers()) {
    const auto outcome = graph.layer(layer.id, progress);
    EXPECT_FALSE(outcome) << layer.id;
    EXPECT_THAT(outcome.reason,
                testing::AllOf(testing::SizeIs(testing::Gt(10)), testing::Not(testing::HasSubstr("internal error"))))
        << layer.id;
  }
}

TEST(Registry_3, DegenerateInputsGiveAValueOrAReasonButNoInternalError) {
  std::vector<Point_3> lattice;
  for (int i = 0; i < 27; ++i)
    lattice.push_back({static_cast<double>(i % 3), static_cast<double>(i / 3 % 3), static_cast<double>(i / 9)});
  const std::vector<std::vector<Point_3>> clouds{{{0, 0, 0}},
                                                 {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                                                 {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}},
                                                 {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                                                 {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                                 {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                                                 lattice};
  std::vector<Inputs> inputs;
  for (const auto& cloud : clouds) inputs.push_back(Inputs().with(cloud_input, cloud));
  for (const auto& cloud : clouds) {
    for (const double radius : {0.5, 0.75, 2.0}) {
      std::vector<Ball_3> balls;
      for (const Point_3& p : cloud) balls.push_back({p, radius});
      inputs.push_back(Inputs().with(balls_input, balls));
    }
  }
  const auto registry = make_registry_3();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    Graph graph(registry);
    graph.set_inputs(inputs[i]);
    Progress progress;
    for (const Layer_spec& layer : registry->layers()) {
      const auto outcome = graph.layer(layer.id, progress);
      EXPECT_TRUE(outcome || !outcome.reason.empty()) << layer.id;
      EXPECT_THAT(outcome.reason, testing::Not(testing::HasSubstr("internal error"))) << layer.id << " of input " << i;
    }
  }
}

TEST(Registry_3, EveryPromisedEvolutionGoesSteps) {
  const auto registry = make_registry_3();
  for (const char* id : {"laplacian-smoothing", "noise", "grow-balls", "shrink-balls", "stepped-growing"})
    EXPECT_NE(registry->find_evolution(id), nullptr) << id;
  const std::vector<Inputs> inputs = {Inputs().with(mesh_input, torus()),
                                      Inputs().with(balls_input, balls_of_all_kinds()),
                                      Inputs().with(cloud_input, torus().vertices)};
  for (const Evolution_spec& evolution : registry->evolutions()) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      Graph graph(registry);
      graph.set_settings(Settings().with("delta", 0.05));
      graph.set_inputs(inputs[i]);
      Progress progress;
      const Evolution_result result = evolve(graph, evolution.id, 3, progress);
      const bool needs_a_mesh = evolution.id == "laplacian-smoothing" && i > 0;
      EXPECT_EQ(result.steps_done, needs_a_mesh ? 0u : 3u) << evolution.id << " " << i << ": " << result.end_reason;
      const auto layer = graph.layer("medial-axis", progress);
      EXPECT_TRUE(layer) << evolution.id << " " << i << ": " << layer.reason;
    }
  }
}

TEST(Registry_3, EvolutionsOfDegenerateInputsGoOnOrSayWhyNot) {
  const std::vector<Point_3> triangle = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Inputs> inputs = {Inputs(),
                                      Inputs().with(mesh_input, Triangle_mesh_3{triangle, {{0, 1, 2}}}),
                                      Inputs().with(mesh_input, Triangle_mesh_3{triangle, {{0, 0, 2}, {1, 1, 1}}}),
                                      Inputs().with(mesh_input, Triangle_mesh_3{triangle, {{0, 1, 2}, {0, 2, 1}}}),
                                      Inputs().with(mesh_input, Triangle_mesh_3{}),
                                      Inputs().with(cloud_input, std::vector<Point_3>{{1, 2, 3}}),
                                      Inputs().with(cloud_input, std::vector<Point_3>{{1, 2, 3}, {1, 2, 3}}),
                                      Inputs().with(balls_input, std::vector<Ball_3>{{{1, 2, 3}, 0}}),
                                      Inputs().with(balls_input, std::vector<Ball_3>{{{1, 2, 3}, 1}, {{1, 2, 3}, 1}})};
  const auto registry = make_registry_3();
  for (const Evolution_spec& evolution : registry->evolutions()) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      Graph graph(registry);
      graph.set_inputs(inputs[i]);
      graph.set_settings(Settings().with("delta", 0.2));
      Progress progress;
      const Evolution_result result = evolve(graph, evolution.id, 3, progress);
      EXPECT_TRUE(result.steps_done == 3 || !result.end_reason.empty());
      EXPECT_THAT(result.end_reason, testing::Not(testing::HasSubstr("internal error"))) << evolution.id << " " << i;
    }
  }
}

TEST(Registry_3, OnlyWhatDependsOnTheScaleIsComputedAgain) {
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(mesh_input, torus()));
  graph.set_settings(Settings().with("delta", 0.05));
  Progress progress;
  ASSERT_TRUE(graph.layer("scale-axis", progress));
  graph.set_settings(Settings().with("delta", 0.05).with("scale", 1.3));
  ASSERT_TRUE(graph.layer("scale-axis", progress));
  for (const char* id : {"solid-3", "ball-approximation-3", "balls-3"}) EXPECT_EQ(graph.computations(id), 1u) << id;
  EXPECT_EQ(graph.computations("scale-axis-3"), 2u);
}

TEST(Registry_3, LimitsOfTheMedialAxisAreThoseOfThePlane) {
  const auto plane = make_registry_2();
  const auto space = make_registry_3();
  for (const char* name : {"lambda", "angle", "scale"}) {
    const std::string limit = std::string(name) + "-limit";
    const Setting_spec* here = space->find_setting(limit);
    ASSERT_NE(here, nullptr) << limit;
    EXPECT_EQ(here->unit, plane->find_setting(limit)->unit);
    EXPECT_EQ(here->default_value, plane->find_setting(limit)->default_value);
    const Layer_spec* layer = space->find_layer(std::string(name) + "-medial-axis");
    ASSERT_NE(layer, nullptr) << name;
    EXPECT_EQ(space->cut(*layer, Settings().with(limit, 1.5)), (Cut{name, 1.5}));
  }
}

TEST(Registry_3, TheTopologyOfATorusGoesThroughAllStages) {
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(mesh_input, torus()));
  graph.set_settings(Settings().with("delta", 0.04).with("scale", 1.1));
  Progress progress;
  const std::array<std::int64_t, 3> of_solid{1, 1, 0};
  for (const char* id : {"dual", "medial-axis", "grown-medial-axis", "scale-axis"}) {
    const auto outcome = graph.layer(id, progress);
    ASSERT_TRUE(outcome) << id << ": " << outcome.reason;
    const auto found = topology(*outcome.value);
    ASSERT_TRUE(found) << id;
    EXPECT_EQ(found->betti, of_solid) << id;
    EXPECT_EQ(found->euler, 0) << id;
  }
  EXPECT_EQ(graph.notes().at("repair"), "none");
}

}  // namespace
}  // namespace mesecina
