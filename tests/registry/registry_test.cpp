// SPDX-License-Identifier: GPL-3.0-or-later
// What every module promises: ids, labels and help for all it declares, and layers that compute without a window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/evolution.h"
#include "geometries/landmark_disks_2/module.h"
#include "geometries/modules_2.h"
#include "geometries/witness_2/module.h"

namespace mesecina {
namespace {

/// Without symmetry, so that no four samples are cocircular and the Delaunay triangulation is unique.
std::vector<Point_2> wavy_curve(std::size_t count) {
  std::vector<Point_2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const double r = 1 + 0.25 * std::cos(4 * t + 0.3) + 0.1 * std::sin(3 * t + 1.1) + 0.03 * std::cos(7 * t + 2);
    points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return points;
}

/// A union with triangles that share an edge, singular edges, an isolated disk and a hidden one.
std::vector<Disk_2> disks_of_all_kinds() {
  return {{{0, 0}, 1},     {{1.2, 0}, 1}, {{0, 1.2}, 1},      {{1.2, 1.3}, 1}, {{3, 0}, 1},
          {{4.5, 0.5}, 1}, {{10, 10}, 1}, {{0.6, 0.6}, 0.01}, {{4.5, -1}, 0.7}};
}

Inputs example() {
  Image image;
  image.width = image.height = 1;
  image.rgba = {0, 0, 0, 255};
  return Inputs()
      .with(points_input, wavy_curve(200))
      .with(disks_input, disks_of_all_kinds())
      .with(landmarks_input, wavy_curve(40))
      .with(landmark_disks_input, std::vector<Disk_2>{{{0, 0}, 1}, {{3, 0}, 1}})
      .with(image_input, image);
}

/// The layers that an issue of the project names; others may come, none may go.
const std::set<std::string> promised_layers = {"points",
                                               "disks",
                                               "outline",
                                               "image",
                                               "delaunay",
                                               "voronoi",
                                               "voronoi-disks",
                                               "inner-voronoi-disks",
                                               "outer-voronoi-disks",
                                               "inner-voronoi-vertices",
                                               "outer-voronoi-vertices",
                                               "one-step-crust",
                                               "curve-normals",
                                               "label-conflicts",
                                               "full-medial-axis",
                                               "medial-axis",
                                               "lambda-medial-axis",
                                               "angle-medial-axis",
                                               "scale-medial-axis",
                                               "lambda-medial-axis-disks",
                                               "angle-medial-axis-disks",
                                               "scale-medial-axis-disks",
                                               "balls",
                                               "ball-centers",
                                               "regular-triangulation",
                                               "power-diagram",
                                               "hidden-balls",
                                               "dual",
                                               "dual-faces",
                                               "dual-regular-edges",
                                               "dual-interior-edges",
                                               "dual-singular-edges",
                                               "dual-singular-vertices",
                                               "union-boundary",
                                               "union-vertices",
                                               "union-vertices-origin",
                                               "union-vertices-delaunay",
                                               "union-vertices-voronoi",
                                               "union-voronoi-interior",
                                               "union-voronoi-exterior",
                                               "union-crossing-edges",
                                               "union-alpha-edges",
                                               "union-medial-axis",
                                               "union-medial-disks",
                                               "inner-poles",
                                               "outer-poles",
                                               "inner-polar-disks",
                                               "outer-polar-disks",
                                               "polar-triangulation",
                                               "polar-power-diagram",
                                               "power-crust",
                                               "power-shape",
                                               "grown-disks",
                                               "grown-union",
                                               "grown-medial-axis",
                                               "scale-axis",
                                               "scale-axis-disks",
                                               "scale-axis-shape",
                                               "lambda-medial-axis-shape",
                                               "angle-medial-axis-shape",
                                               "scale-medial-axis-shape"};

TEST(Registry_2, EveryPromisedLayerIsThere) {
  const auto registry = make_registry_2();
  std::set<std::string> ids;
  for (const Layer_spec& layer : registry->layers()) ids.insert(layer.id);
  for (const std::string& id : promised_layers) EXPECT_TRUE(ids.contains(id)) << id;
}

/// Words of small letters and digits, joined by single hyphens.
bool is_kebab_case(const std::string& id) {
  const bool has_only_allowed =
      std::ranges::all_of(id, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
  return has_only_allowed && !id.empty() && id.front() != '-' && id.back() != '-' && id.find("--") == std::string::npos;
}

TEST(Registry_2, EveryEntryHasAKebabCaseIdALabelAndItsOwnHelp) {
  const auto registry = make_registry_2();
  std::set<std::string> helps;
  const auto check = [&](const std::string& id, const std::string& label, const std::string& help) {
    EXPECT_TRUE(is_kebab_case(id)) << id;
    EXPECT_FALSE(label.empty()) << id;
    EXPECT_GE(help.size(), 20u) << id;
    EXPECT_TRUE(helps.insert(help).second) << id << " has the help of another entry";
    EXPECT_NE(registry->module_of(id), nullptr) << id;
  };
  for (const Layer_spec& layer : registry->layers()) {
    check(layer.id, layer.label, layer.help);
    EXPECT_FALSE(layer.stage.empty()) << layer.id;
    EXPECT_TRUE(layer.build) << layer.id;
  }
  for (const Setting_spec& setting : registry->settings()) check(setting.id, setting.label, setting.help);
  for (const Evolution_spec& evolution : registry->evolutions()) {
    check(evolution.id, evolution.label, evolution.help);
    for (const std::string& id : evolution.settings) EXPECT_NE(registry->find_setting(id), nullptr) << evolution.id;
  }
}

TEST(Registry_2, EveryDefaultIsValidAndReadsBackFromItsText) {
  const auto registry = make_registry_2();
  for (const Setting_spec& setting : registry->settings()) {
    EXPECT_NO_THROW(check_setting(setting, setting.default_value)) << setting.id;
    EXPECT_EQ(parse_setting(setting, to_text(setting.default_value)), setting.default_value) << setting.id;
  }
}

TEST(Registry_2, EveryLayerIsComputedOnAnExampleAndItsValuesFitItsElements) {
  const auto registry = make_registry_2();
  Graph graph(registry);
  graph.set_inputs(example());
  Progress progress;
  for (const Layer_spec& layer : registry->layers()) {
    const auto outcome = graph.layer(layer.id, progress);
    if (layer.id == "outline") {
      EXPECT_THAT(outcome.reason, testing::HasSubstr("outline"));
      continue;
    }
    ASSERT_TRUE(outcome) << layer.id << ": " << outcome.reason;
    if (layer.id != "label-conflicts") {
      EXPECT_FALSE(outcome.value->is_empty()) << layer.id;
    }
    for (const Values& values : outcome.value->values)
      EXPECT_EQ(values.data.size(), outcome.value->element_count()) << layer.id << " " << values.name;
    if (!outcome.value->ids.empty()) {
      EXPECT_EQ(outcome.value->ids.size(), outcome.value->element_count()) << layer.id;
    }
    if (const auto cut = registry->cut(layer, {})) {
      EXPECT_NE(outcome.value->find_values(cut->value), nullptr) << layer.id;
    }
    if (layer.describe && outcome.value->element_count() > 0) {
      EXPECT_FALSE(graph.describe(layer.id, 0, progress).facts.empty()) << layer.id;
    }
  }
}

TEST(Registry_2, VoronoiEdgesOfAUnionTellTheDisksTheyComeFrom) {
  Graph graph(make_registry_2());
  graph.set_inputs(Inputs().with(disks_input, std::vector<Disk_2>{{{0, 0}, 5}, {{6, 0}, 5}, {{12, 1}, 5}}));
  Progress progress;
  const auto told = [&](const char* layer) {
    std::set<std::string> facts;
    const auto outcome = graph.layer(layer, progress);
    for (std::size_t e = 0; outcome && e < outcome.value->element_count(); ++e)
      for (const Fact& fact : graph.describe(layer, e, progress).facts)
        if (fact.name.find("disk") != std::string::npos) facts.insert(fact.name + " " + fact.text);
    return facts;
  };
  EXPECT_THAT(told("union-alpha-edges"),
              testing::ElementsAre("both on the circles of disks 0 and 1", "both on the circles of disks 1 and 2"));
  EXPECT_THAT(told("union-crossing-edges"), testing::ElementsAre("both on the circle of disk 1"));
}

TEST(Registry_2, EveryLayerHasAReasonWhereThereIsNothing) {
  const auto registry = make_registry_2();
  Graph graph(registry);
  Progress progress;
  for (const Layer_spec& layer : registry->layers()) {
    const auto outcome = graph.layer(layer.id, progress);
    EXPECT_FALSE(outcome) << layer.id;
    EXPECT_FALSE(outcome.reason.empty()) << layer.id;
    EXPECT_THAT(outcome.reason, testing::Not(testing::HasSubstr("internal error"))) << layer.id;
  }
}

TEST(Registry_2, DegenerateInputsGiveAValueOrAReasonButNoInternalError) {
  const auto registry = make_registry_2();
  std::vector<Point_2> grid;
  for (int i = 0; i < 64; ++i) grid.push_back({static_cast<double>(i % 8), static_cast<double>(i / 8)});
  const std::vector<std::vector<Point_2>> cases = {{{1, 2}},
                                                   {{1, 2}, {1, 2}},
                                                   {{0, 0}, {1, 1}},
                                                   {{0, 0}, {1, 1}, {2, 2}, {3, 3}},
                                                   {{0, 0}, {1, 0}, {0, 1}},
                                                   {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
                                                   grid};
  for (const auto& points : cases) {
    Graph graph(registry);
    graph.set_inputs(Inputs().with(points_input, points));
    Progress progress;
    for (const Layer_spec& layer : registry->layers()) {
      const auto outcome = graph.layer(layer.id, progress);
      EXPECT_TRUE(outcome || !outcome.reason.empty());
      EXPECT_THAT(outcome.reason, testing::Not(testing::HasSubstr("internal error"))) << layer.id << points.size();
    }
  }
}

TEST(Registry_2, EveryPromisedEvolutionGoesStepsOnAnExample) {
  const auto registry = make_registry_2();
  for (const char* id : {"laplacian-smoothing", "subdivision", "noise", "lloyd", "grow-balls", "shrink-balls",
                         "stepped-growing", "max-min-landmarks", "landmark-disks"})
    EXPECT_NE(registry->find_evolution(id), nullptr) << id;
  for (const Evolution_spec& evolution : registry->evolutions()) {
    Graph graph(registry);
    graph.set_inputs(example());
    Progress progress;
    const Evolution_result result = evolve(graph, evolution.id, 3, progress);
    EXPECT_EQ(result.steps_done, 3u) << evolution.id << ": " << result.end_reason;
    for (const char* layer : {"union-medial-axis", "one-step-crust", "witness-complex"})
      EXPECT_TRUE(graph.layer(layer, progress)) << evolution.id << " " << layer;
  }
}

TEST(Registry_2, EvolutionsOfDegenerateInputsGoOnOrSayWhyNot) {
  const auto registry = make_registry_2();
  std::vector<Inputs> cases = {{}, Inputs().with(disks_input, std::vector<Disk_2>{{{0, 0}, 0}, {{0, 0}, 0}})};
  const std::vector<std::vector<Point_2>> point_sets = {{},
                                                        {{1, 2}},
                                                        {{1, 2}, {1, 2}},
                                                        {{0, 0}, {1, 1}},
                                                        {{0, 0}, {1, 1}, {2, 2}, {3, 3}},
                                                        {{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (const auto& points : point_sets) {
    cases.push_back(Inputs().with(points_input, points));
    cases.push_back(Inputs().with(outline_input, Outline_2{{points, points}}));
    cases.push_back(Inputs().with(points_input, points).with(outline_input, Outline_2{{points}}));
  }
  for (const Evolution_spec& evolution : registry->evolutions()) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      Graph graph(registry);
      graph.set_inputs(cases[i]);
      Progress progress;
      const Evolution_result result = evolve(graph, evolution.id, 4, progress);
      EXPECT_TRUE(result.steps_done == 4 || !result.end_reason.empty());
      EXPECT_THAT(result.end_reason, testing::Not(testing::HasSubstr("internal error"))) << evolution.id << " " << i;
    }
  }
}

TEST(Registry_2, MovingALimitOrTheTopologySwitchComputesNothing) {
  const auto registry = make_registry_2();
  Graph graph(registry);
  graph.set_inputs(example());
  Progress progress;
  ASSERT_TRUE(graph.layer("scale-medial-axis", progress));
  graph.clear_stages();
  graph.set_settings(Settings().with("scale-limit", 1.7).with("topology-preserving", false));
  ASSERT_TRUE(graph.layer("scale-medial-axis", progress));
  EXPECT_TRUE(graph.stages().empty());
  EXPECT_EQ(registry->cut(*registry->find_layer("scale-medial-axis"), graph.settings()), (Cut{"scale", 1.7}));
  EXPECT_EQ(registry->cut(*registry->find_layer("scale-medial-axis"), {}), (Cut{"scale-monotone", 1.1}));
}

TEST(Registry_2, DraggingASampleGivesWhatAFreshGraphGives) {
  const auto registry = make_registry_2();
  std::vector<Point_2> points = wavy_curve(400);
  Graph dragged(registry);
  Progress progress;
  for (int step = 0; step < 30; ++step) {
    points[100] = {points[100].x + 0.01 * std::sin(step), points[100].y + 0.012 * std::cos(3 * step)};
    dragged.set_inputs(Inputs().with(points_input, points));
    const auto moved = dragged.layer("scale-medial-axis", progress);
    Graph fresh(registry);
    fresh.set_inputs(Inputs().with(points_input, points));
    const auto expected = fresh.layer("scale-medial-axis", progress);
    ASSERT_TRUE(moved && expected);
    for (const char* name : {"scale", "scale-monotone"}) {
      std::vector<double> a = moved.value->find_values(name)->data;
      std::vector<double> b = expected.value->find_values(name)->data;
      std::ranges::sort(a);
      std::ranges::sort(b);
      ASSERT_EQ(a.size(), b.size()) << step;
      for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::isinf(b[i])) {
          EXPECT_EQ(a[i], b[i]) << name << " at step " << step;
        } else {
          EXPECT_NEAR(a[i], b[i], 1e-9 * b[i]) << name << " at step " << step;
        }
      }
    }
  }
  bool updated = false;
  for (const Graph::Stage& stage : dragged.stages()) updated = updated || (stage.id == "ball-scale-2" && stage.updated);
  EXPECT_TRUE(updated);
}

}  // namespace
}  // namespace mesecina
