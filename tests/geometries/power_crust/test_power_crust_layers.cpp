// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/graph.h"
#include "geometries/modules_2.h"
#include "geometries/power_crust_2/module.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

const std::vector<std::string> layers = {"inner-poles",       "outer-poles",         "inner-polar-disks",
                                         "outer-polar-disks", "polar-triangulation", "polar-power-diagram",
                                         "power-crust",       "power-shape"};

class Power_crust_layers : public testing::Test {
 protected:
  void set_points(std::vector<Point_2> points) { graph_.set_inputs(Inputs().with(points_input, std::move(points))); }
  std::shared_ptr<const Primitive_set> layer(const std::string& id) {
    const auto outcome = graph_.layer(id, progress_);
    EXPECT_TRUE(outcome.value) << id << ": " << outcome.reason;
    return outcome.value;
  }
  std::string reason(const std::string& id) { return graph_.layer(id, progress_).reason; }

  Graph graph_{make_registry_2()};
  Progress progress_;
};

std::vector<Point_2> annulus() { return smooth_shapes().back().samples(); }

TEST_F(Power_crust_layers, HaveTheTopologyOfAnAnnulus) {
  set_points(annulus());
  const auto shape = topology(*layer("power-shape"));
  ASSERT_TRUE(shape);
  EXPECT_EQ(shape->betti, (std::array<std::int64_t, 3>{1, 1, 0}));
  const auto crust = topology(*layer("power-crust"));
  ASSERT_TRUE(crust);
  EXPECT_EQ(crust->betti, (std::array<std::int64_t, 3>{2, 2, 0}));
  EXPECT_TRUE(graph_.warnings("power-crust").empty());
}

TEST_F(Power_crust_layers, PointsAndDisksAreTheFinitePoles) {
  set_points(annulus());
  const auto polar = graph_.structure(polar_balls_2_key, progress_).value;
  ASSERT_TRUE(polar);
  std::size_t shown = 0;
  for (const std::string side : {"inner", "outer"}) {
    const auto points = layer(side + "-poles");
    const auto disks = layer(side + "-polar-disks");
    ASSERT_EQ(points->points.size(), disks->balls.size());
    ASSERT_FALSE(points->points.empty());
    shown += points->points.size();
    const Values* radius = points->find_values("radius");
    const Values* confidence = points->find_values("confidence");
    ASSERT_TRUE(radius && confidence);
    for (std::size_t i = 0; i < points->points.size(); ++i) {
      EXPECT_EQ(disks->balls[i].radius, radius->data[i]);
      const double from_center = std::hypot(points->vertices[i].x, points->vertices[i].y);
      EXPECT_EQ(side == "inner", from_center > 0.65 && from_center < 0.99);
      const auto pole = std::ranges::find(polar->poles->triangles, points->id(i));
      ASSERT_NE(pole, polar->poles->triangles.end());
      const auto p = pole - polar->poles->triangles.begin();
      EXPECT_EQ(polar->confidence[p], confidence->data[i]);
      EXPECT_EQ(polar->poles->balls->radii[p], radius->data[i]);
    }
  }
  EXPECT_EQ(shown, polar->poles->finite_count());
}

TEST_F(Power_crust_layers, EveryElementIsDescribedAndHasItsValues) {
  set_points(annulus());
  for (const std::string& id : layers) {
    SCOPED_TRACE(id);
    const auto set = layer(id);
    ASSERT_GT(set->element_count(), 0u);
    EXPECT_TRUE(set->ids.empty() || set->ids.size() == set->element_count());
    for (const Values& values : set->values) EXPECT_EQ(values.data.size(), set->element_count());
    for (const Ray& ray : set->rays) EXPECT_NEAR(std::hypot(ray.direction.x, ray.direction.y), 1, 1e-12);
    if (id == "power-shape") continue;
    for (const std::size_t element : {std::size_t{0}, set->element_count() - 1}) {
      const Element_description description = graph_.describe(id, element, progress_);
      EXPECT_FALSE(description.facts.empty());
      EXPECT_FALSE(description.dual.is_empty());
    }
    EXPECT_TRUE(graph_.describe(id, set->element_count(), progress_).facts.empty());
  }
}

TEST_F(Power_crust_layers, AreOnTheScaleOfTheSamples) {
  // The disks at infinity are no part of any layer.
  set_points(annulus());
  for (const std::string id : {"power-crust", "power-shape", "inner-poles", "inner-polar-disks"})
    EXPECT_LT(layer(id)->bounding_box().diagonal(), 3) << id;
  EXPECT_FALSE(layer("polar-triangulation")->rays.empty());
}

TEST_F(Power_crust_layers, TriangulationHasARayForEveryEdgeToInfinity) {
  const std::vector<Point_2> samples = annulus();
  set_points(samples);
  const auto polar = graph_.structure(polar_balls_2_key, progress_).value;
  ASSERT_TRUE(polar);
  std::size_t segments = 0;
  std::size_t rays = 0;
  for (int t = 0; t < static_cast<int>(polar->regular->triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!polar->regular->edge_is_listed(t, i)) continue;
      const auto [a, b] = polar->regular->edge(t, i);
      const int infinite = (polar->poles->is_infinite(a) ? 1 : 0) + (polar->poles->is_infinite(b) ? 1 : 0);
      if (infinite == 0) ++segments;
      if (infinite == 1) ++rays;
    }
  }
  const auto set = layer("polar-triangulation");
  EXPECT_EQ(set->segments.size(), segments);
  EXPECT_EQ(set->rays.size(), rays);
  // The hull of the annulus is the circle around the origin: its outward directions are those of the samples.
  for (std::size_t r = 0; r < set->rays.size(); ++r) {
    const std::int64_t id = set->id(set->segments.size() + r);
    const auto [a, b] = polar->regular->edge(static_cast<int>(id / 3), static_cast<int>(id % 3));
    const Point_2& s = samples[polar->poles->samples_of(std::max(a, b)).front()];
    EXPECT_NEAR(set->rays[r].direction.x, s.x, 0.03);
    EXPECT_NEAR(set->rays[r].direction.y, s.y, 0.03);
  }
}

TEST_F(Power_crust_layers, SayWhyThereIsNothing) {
  set_points({{0, 0}, {1, 1}, {2, 2}});
  for (const std::string& id : layers) EXPECT_NE(reason(id).find("not on one line"), std::string::npos) << id;
  set_points({{3, 3}});
  for (const std::string& id : layers) EXPECT_NE(reason(id).find("at least 3 samples"), std::string::npos) << id;
}

TEST_F(Power_crust_layers, WarnOfContradictions) {
  set_points(noisy_curve(300, 0.08, 5));
  layer("power-crust");
  const auto warnings = graph_.warnings("power-crust");
  ASSERT_EQ(warnings.size(), 1u);
  const auto polar = graph_.structure(polar_balls_2_key, progress_).value;
  EXPECT_NE(warnings.front().find(" " + std::to_string(polar->contradictions.size()) + " samples"), std::string::npos);
}

}  // namespace
}  // namespace mesecina::test
