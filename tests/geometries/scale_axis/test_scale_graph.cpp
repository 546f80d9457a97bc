// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/graph.h"
#include "geometries/balls_2/module.h"
#include "geometries/dual_2/module.h"
#include "geometries/modules_2.h"
#include "geometries/scale_axis_2/module.h"
#include "geometries/union_2/module.h"
#include "tests/geometries/scale_axis/scale_stages.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

const std::vector<std::string> scale_axis_layers{"grown-union",      "scale-axis-shape", "grown-disks",
                                                 "scale-axis-disks", "scale-axis",       "grown-medial-axis"};
const std::vector<std::string> all_layers = [] {
  std::vector<std::string> result = scale_axis_layers;
  for (const char* id : {"balls", "dual", "union-boundary", "union-medial-axis", "power-diagram", "medial-axis",
                         "scale-medial-axis-disks", "scale-medial-axis-shape", "lambda-medial-axis-shape"})
    result.emplace_back(id);
  return result;
}();

class Scale_graph : public testing::Test {
 protected:
  std::shared_ptr<const Primitive_set> layer(const std::string& id) {
    const auto outcome = graph_.layer(id, progress_);
    EXPECT_TRUE(outcome.value) << id << ": " << outcome.reason;
    return outcome.value ? outcome.value : std::make_shared<const Primitive_set>();
  }
  std::string reason(const std::string& id) {
    const auto outcome = graph_.layer(id, progress_);
    EXPECT_FALSE(outcome.value) << id;
    return outcome.reason;
  }
  void set(std::string_view id, Setting_value value) {
    graph_.set_settings(graph_.settings().with(id, std::move(value)));
  }
  void compute_all() {
    for (const std::string& id : all_layers) layer(id);
  }
  /// What is computed again once a setting has changed, sorted.
  std::vector<std::string> computed_after(std::string_view id, Setting_value value) {
    compute_all();
    graph_.clear_stages();
    set(id, std::move(value));
    compute_all();
    std::vector<std::string> result;
    for (const Graph::Stage& stage : graph_.stages())
      result.push_back(stage.id.starts_with("layer:") ? stage.id.substr(6) : stage.id);
    std::ranges::sort(result);
    return result;
  }
  std::size_t ball_count() { return layer("balls")->balls.size(); }

  Graph graph_{make_registry_2()};
  Progress progress_;
};

using Names = std::vector<std::string>;

/// A square taken twice: by the even-odd rule nothing is inside.
std::vector<Point_2> ring() {
  std::vector<Point_2> points = ellipse(1, 1, 60, 0.5, 3);
  for (const Point_2& p : ellipse(0.5, 0.5, 40, 0.5, 4)) points.push_back(p);
  return points;
}

TEST_F(Scale_graph, ScaleChangesOnlyWhatDependsOnIt) {
  graph_.set_inputs(Inputs().with(points_input, ring()));
  EXPECT_EQ(computed_after(scale_setting.id, 1.3),
            (Names{"grown-boundary-2", "grown-disks", "grown-medial-axis", "grown-medial-axis-2", "grown-union",
                   "grown-voronoi-2", "scale-axis", "scale-axis-2", "scale-axis-disks", "scale-axis-shape",
                   "scale-axis-shape-2"}));
  for (int i = 0; i < 5; ++i) {
    set(scale_setting.id, 1.4 + 0.1 * i);
    compute_all();
  }
  for (const char* id : {"delaunay-triangulation-2", "medial-axis-2", "union-boundary-2", "union-medial-axis-2",
                         "union-voronoi-2", "regular-triangulation-2", "dual-2", "balls-2", "inner-voronoi-balls-2",
                         "scale-importance-2", "scale-shape-2", "union-boundary", "scale-medial-axis-disks"})
    EXPECT_EQ(graph_.computations(id), 1U) << id;
  EXPECT_EQ(graph_.computations("scale-axis-2"), 7U);
}

TEST_F(Scale_graph, AnglesChangeOnlyTheScaleAxis) {
  graph_.set_inputs(Inputs().with(points_input, ring()));
  const Names of_scale_axis{"scale-axis", "scale-axis-2", "scale-axis-disks", "scale-axis-shape", "scale-axis-shape-2"};
  EXPECT_EQ(computed_after(scale_axis_min_angle_setting.id, 50.0), of_scale_axis);
  EXPECT_EQ(computed_after(sampling_min_angle_setting.id, 120.0), of_scale_axis);
  EXPECT_EQ(computed_after("complete-faces-only", true), (Names{"grown-medial-axis", "union-medial-axis"}));
}

TEST_F(Scale_graph, LimitsChangeOnlyTheirShape) {
  graph_.set_inputs(Inputs().with(points_input, ring()));
  EXPECT_EQ(computed_after("scale-limit", 1.3), (Names{"scale-medial-axis-shape", "scale-shape-2"}));
  EXPECT_EQ(computed_after("lambda-limit", 0.1), (Names{"lambda-medial-axis-shape", "lambda-shape-2"}));
  EXPECT_EQ(computed_after("angle-limit", 90.0), Names{});
  const Names after_switch = computed_after("topology-preserving", false);
  EXPECT_EQ(std::ranges::count(after_switch, "scale-shape-2"), 1);
  EXPECT_EQ(std::ranges::count(after_switch, "lambda-shape-2"), 1);
  for (const char* id : {"scale-medial-axis-disks", "medial-axis-2", "scale-importance-2", "union-boundary-2"})
    EXPECT_EQ(std::ranges::count(after_switch, id), 0) << id;
}

TEST_F(Scale_graph, AlphaChangesTheUnionAndWhatFollows) {
  graph_.set_inputs(Inputs().with(disks_input, std::vector<Disk_2>{{{0, 0}, 5}, {{10, 0}, 3}, {{5, 6}, 2}}));
  const auto betti_of_dual = [&] { return topology(*layer("dual"))->betti; };
  EXPECT_EQ(betti_of_dual(), (std::array<std::int64_t, 3>{3, 0, 0}));
  for (const char* id : {"balls", "union-boundary", "power-diagram", "scale-axis", "union-medial-axis"}) layer(id);
  // Radii of 6, sqrt 20 and sqrt 15: all meet, around their power vertex (5.8, 2), whose power is 1.64.
  set(alpha_setting.id, 11.0);
  EXPECT_EQ(betti_of_dual(), (std::array<std::int64_t, 3>{1, 1, 0}));
  set(alpha_setting.id, 12.65);
  EXPECT_EQ(betti_of_dual(), (std::array<std::int64_t, 3>{1, 0, 0}));
  set(alpha_setting.id, 11.0);
  const auto boundary = layer("union-boundary");
  std::vector<double> radii;
  for (const Arc& arc : boundary->arcs) radii.push_back(arc.radius);
  std::ranges::sort(radii);
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  ASSERT_EQ(radii.size(), 3U);
  EXPECT_DOUBLE_EQ(radii[0], std::sqrt(15));
  EXPECT_DOUBLE_EQ(radii[1], std::sqrt(20));
  EXPECT_DOUBLE_EQ(radii[2], 6);
  // The scale axis is that of the changed disks.
  set(scale_setting.id, 1.0);
  set(scale_axis_min_angle_setting.id, 0.0);
  double largest = 0;
  for (const Ball& ball : layer("scale-axis-disks")->balls) largest = std::max(largest, ball.radius);
  EXPECT_DOUBLE_EQ(largest, 6);
  for (const char* id : {"balls", "dual", "power-diagram", "union-medial-axis"}) layer(id);
  for (const char* id : {"balls-2", "balls", "regular-triangulation-2", "power-diagram"})
    EXPECT_EQ(graph_.computations(id), 1U) << id;
  EXPECT_EQ(graph_.computations("dual-2"), 4U);
  for (const char* id : {"union-boundary-2", "union-voronoi-2", "union-medial-axis-2"})
    EXPECT_EQ(graph_.computations(id), 2U) << id;
  // Below the least radius all vanish; nothing is left, and nothing fails.
  set(alpha_setting.id, -100.0);
  for (const std::string& id : scale_axis_layers) EXPECT_EQ(layer(id)->element_count(), 0U) << id;
  EXPECT_EQ(layer("union-boundary")->element_count(), 0U);
}

TEST_F(Scale_graph, BallSourceSaysWhichDisks) {
  const std::vector<Disk_2> disks{{{0, 0}, 1}, {{1, 0}, 1}};
  graph_.set_inputs(Inputs().with(points_input, ring()).with(disks_input, disks));
  EXPECT_EQ(ball_count(), 2U);
  set(ball_source_setting.id, std::string(ball_source_inner_voronoi));
  const std::size_t voronoi = ball_count();
  EXPECT_GT(voronoi, 50U);
  EXPECT_EQ(topology(*layer("scale-axis"))->betti, (std::array<std::int64_t, 3>{1, 1, 0}));
  set(ball_source_setting.id, std::string(ball_source_inner_poles));
  const auto poles = layer("balls");
  EXPECT_GT(poles->balls.size(), 10U);
  EXPECT_LT(poles->balls.size(), voronoi);
  EXPECT_EQ(poles->balls.size(), layer("inner-poles")->points.size());
  set(ball_source_setting.id, std::string(ball_source_drawn));
  EXPECT_EQ(ball_count(), 2U);
  graph_.set_inputs(Inputs().with(points_input, ring()));
  for (const std::string& id : scale_axis_layers)
    EXPECT_NE(reason(id).find("there are no disks: draw"), std::string::npos) << id;
  set(ball_source_setting.id, std::string(ball_source_automatic));
  EXPECT_EQ(ball_count(), voronoi);
  graph_.set_inputs(Inputs().with(points_input, ring()).with(disks_input, std::vector<Disk_2>{}));
  EXPECT_EQ(ball_count(), voronoi);
}

TEST_F(Scale_graph, DrawnDisksDoNotDependOnPoints) {
  graph_.set_inputs(Inputs().with(points_input, ring()).with(disks_input, std::vector<Disk_2>{{{0, 0}, 1}}));
  layer("scale-axis");
  graph_.set_inputs(graph_.inputs().with(points_input, flower(60)));
  layer("scale-axis");
  EXPECT_EQ(graph_.computations("balls-2"), 1U);
  EXPECT_EQ(graph_.computations("scale-axis-2"), 1U);
  EXPECT_EQ(graph_.computations("delaunay-triangulation-2"), 0U);
}

TEST_F(Scale_graph, LayersSayWhyThereIsNothing) {
  for (const std::string& id : scale_axis_layers)
    EXPECT_NE(reason(id).find("there are no disks, and no points or outline"), std::string::npos) << id;
  // Samples that enclose nothing.
  graph_.set_inputs(Inputs().with(outline_input, double_square()));
  for (const std::string& id : scale_axis_layers)
    EXPECT_NE(reason(id).find("enclose nothing"), std::string::npos) << id;
  graph_.set_inputs(Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {1, 1}, {3, 3}}));
  for (const std::string_view source : {ball_source_inner_poles, ball_source_inner_voronoi}) {
    set(ball_source_setting.id, std::string(source));
    for (const std::string& id : scale_axis_layers)
      EXPECT_NE(reason(id).find("not on one line"), std::string::npos) << id;
  }
  graph_.set_inputs(Inputs().with(disks_input, std::vector<Disk_2>{{{0, 0}, -1}}));
  set(ball_source_setting.id, std::string(ball_source_automatic));
  for (const std::string& id : scale_axis_layers) EXPECT_NE(reason(id).find("not negative"), std::string::npos) << id;
}

TEST_F(Scale_graph, OneDiskIsItsOwnScaleAxis) {
  graph_.set_inputs(Inputs().with(disks_input, std::vector<Disk_2>{{{3, -1}, 2}}));
  for (const double scale : {1.0, 1.5, 4.0}) {
    set(scale_setting.id, scale);
    const auto axis = layer("scale-axis");
    EXPECT_EQ(axis->points.size(), 1U);
    EXPECT_TRUE(axis->segments.empty());
    const auto shape = layer("scale-axis-shape");
    ASSERT_EQ(shape->arcs.size(), 1U);
    EXPECT_EQ(shape->arcs[0].center, (Point_2{3, -1}));
    EXPECT_DOUBLE_EQ(shape->arcs[0].radius, 2);
    ASSERT_EQ(layer("grown-union")->arcs.size(), 1U);
    EXPECT_DOUBLE_EQ(layer("grown-union")->arcs[0].radius, 2 * scale);
    ASSERT_EQ(layer("grown-disks")->balls.size(), 1U);
    EXPECT_DOUBLE_EQ(layer("grown-disks")->balls[0].radius, 2 * scale);
  }
}

TEST_F(Scale_graph, LayersShowTheStructures) {
  graph_.set_inputs(Inputs().with(points_input, ring()));
  const auto axis = graph_.structure(scale_axis_2_key, progress_).value;
  ASSERT_TRUE(axis);
  const auto lines = layer("scale-axis");
  EXPECT_EQ(lines->segments.size(), axis->edges.size());
  ASSERT_TRUE(lines->find_values("angle") && lines->find_values("angle-monotone"));
  EXPECT_EQ(lines->find_values("angle")->data, axis->angles);
  EXPECT_EQ(lines->find_values("angle-monotone")->data, axis->monotone_angles);
  const auto disks = layer("scale-axis-disks");
  ASSERT_EQ(disks->balls.size(), axis->centers.size());
  for (std::size_t b = 0; b < disks->balls.size(); ++b) {
    EXPECT_EQ(disks->vertices[disks->balls[b].center].x, axis->centers[b].x);
    EXPECT_EQ(disks->balls[b].radius, axis->radii[b]);
  }
  for (const std::string& id : scale_axis_layers) {
    SCOPED_TRACE(id);
    const auto set = layer(id);
    ASSERT_GT(set->element_count(), 0U);
    for (const Values& values : set->values) EXPECT_EQ(values.data.size(), set->element_count());
    if (id == "grown-union" || id == "scale-axis-shape") continue;
    for (const std::size_t element : {std::size_t{0}, set->element_count() - 1})
      EXPECT_FALSE(graph_.describe(id, element, progress_).facts.empty());
    EXPECT_TRUE(graph_.describe(id, set->element_count(), progress_).facts.empty());
  }
  EXPECT_EQ(topology(*lines)->betti, topology(*layer("grown-medial-axis"))->betti);
}

TEST_F(Scale_graph, WithoutGrowingTheGrownUnionIsTheUnion) {
  graph_.set_inputs(Inputs().with(points_input, ring()));
  set(scale_setting.id, 1.0);
  const auto grown = layer("grown-union");
  const auto whole = layer("union-boundary");
  ASSERT_EQ(grown->arcs.size(), whole->arcs.size());
  for (std::size_t i = 0; i < whole->arcs.size(); ++i) {
    EXPECT_EQ(grown->arcs[i].center, whole->arcs[i].center);
    EXPECT_EQ(grown->arcs[i].radius, whole->arcs[i].radius);
  }
  set(scale_axis_min_angle_setting.id, 0.0);
  set("complete-faces-only", true);
  set(sampling_min_angle_setting.id, 0.0);
  EXPECT_EQ(layer("scale-axis")->segments.size(), layer("union-medial-axis")->segments.size());
}

}  // namespace
}  // namespace mesecina::test
