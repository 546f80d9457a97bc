// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/graph.h"
#include "geometries/balls_2/module.h"
#include "geometries/medial_axis_2/module.h"
#include "geometries/medial_filtrations_2/module.h"
#include "geometries/modules_2.h"
#include "geometries/union_2/module.h"
#include "tests/geometries/scale_axis/scale_stages.h"
#include "tests/geometries/shapes.h"

/// What the kept disks of a filtration reconstruct.
namespace mesecina::test {
namespace {

struct Measure_of_test {
  std::string name;
  std::vector<double> limits;
};
const std::vector<Measure_of_test> measures{
    {"lambda", {0.02, 0.1, 0.3, 0.45}}, {"angle", {20, 60, 120, 170}}, {"scale", {1.02, 1.1, 1.3, 2}}};

/// Center, radius and ends of an arc or a whole circle.
using Described_arc = std::array<double, 7>;
std::multiset<Described_arc> arcs_of(const Primitive_set& set) {
  std::multiset<Described_arc> result;
  for (const Arc& arc : set.arcs) {
    const Point_3& from = set.vertices[arc.from];
    const Point_3& to = set.vertices[arc.to];
    result.insert({arc.center.x, arc.center.y, arc.radius, from.x, from.y, to.x, to.y});
  }
  return result;
}

double direction(const Point_2& center, const Point_3& point) {
  return std::atan2(point.y - center.y, point.x - center.x);
}

/// True when the angle is on the arc, by more than `margin`.
bool is_on(const Primitive_set& set, const Arc& arc, double angle, double margin) {
  if (arc.from == arc.to) return true;
  const double start = direction(arc.center, set.vertices[arc.from]);
  const auto turned = [start](double to) {
    const double result = std::remainder(to - start, 2 * std::numbers::pi);
    return result < 0 ? result + 2 * std::numbers::pi : result;
  };
  const double end = turned(direction(arc.center, set.vertices[arc.to]));
  return turned(angle) >= margin && turned(angle) <= end - margin;
}

/// Every point of the disks' circles is on an arc of the set or in another disk, and never both.
void expect_boundary_of_union(const Primitive_set& set, const std::vector<Disk_2>& disks) {
  constexpr double margin = 1e-6;
  std::map<std::array<double, 3>, std::vector<Arc>> arcs;
  for (const Arc& arc : set.arcs) arcs[{arc.center.x, arc.center.y, arc.radius}].push_back(arc);
  std::set<std::array<double, 3>> tried;
  std::size_t known = 0;
  std::size_t wrong = 0;
  for (const Disk_2& disk : disks) {
    const std::array<double, 3> key{disk.center.x, disk.center.y, disk.radius};
    const auto own = arcs.find(key);
    // Disks of different samples may be equal but for rounding.
    if (own != arcs.end() && tried.insert(key).second) known += own->second.size();
    for (int i = 0; i < 24; ++i) {
      const double angle = 0.01 + i * std::numbers::pi / 12;
      const Point_2 point{disk.center.x + disk.radius * std::cos(angle), disk.center.y + disk.radius * std::sin(angle)};
      bool is_covered = false;
      bool is_certain = true;
      for (const Disk_2& other : disks) {
        if (other == disk) continue;
        const double depth = other.radius - distance(point, other.center);
        if (depth > margin) is_covered = true;
        if (std::abs(depth) <= margin) is_certain = false;
      }
      if (!is_covered && !is_certain) continue;
      const auto is_at_angle = [&](const Arc& arc) { return is_on(set, arc, angle, is_covered ? margin : -margin); };
      const bool is_on_arc = own != arcs.end() && std::ranges::any_of(own->second, is_at_angle);
      if (is_on_arc == is_covered) ++wrong;
    }
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(known, set.arcs.size()) << "arcs of other disks";
}

/// A square taken twice: by the even-odd rule nothing is inside.
class Filtration_shapes : public testing::Test {
 protected:
  std::shared_ptr<const Primitive_set> layer(const std::string& id) {
    const auto outcome = graph_.layer(id, progress_);
    EXPECT_TRUE(outcome.value) << id << ": " << outcome.reason;
    return outcome.value ? outcome.value : std::make_shared<const Primitive_set>();
  }
  void set(std::string_view id, Setting_value value) {
    graph_.set_settings(graph_.settings().with(id, std::move(value)));
  }

  /// The disks that the layer of disks keeps, each once.
  std::vector<Disk_2> kept_disks(const std::string& measure) {
    const std::string id = measure + "-medial-axis-disks";
    const auto cut = graph_.registry().cut(*graph_.registry().find_layer(id), graph_.settings());
    EXPECT_TRUE(cut);
    const Primitive_set kept = apply_cut(*layer(id), *cut);
    const auto all = graph_.structure(inner_voronoi_balls_2_key, progress_).value;
    const auto axis = graph_.structure(medial_axis_2_key, progress_).value;
    std::set<int> found;
    const auto values = layer(id)->find_values(cut->value)->data;
    for (std::size_t b = 0; b < values.size(); ++b)
      if (values[b] >= cut->minimum) found.insert(all->ball_of_triangle[axis->triangles[b]]);
    EXPECT_LE(found.size(), kept.balls.size());
    for (const Ball& ball : kept.balls) {
      const Point_2 center{kept.vertices[ball.center].x, kept.vertices[ball.center].y};
      EXPECT_TRUE(std::ranges::any_of(found, [&](int b) {
        return distance(all->balls.centers[b], center) <= 1e-9 && std::abs(all->balls.radii[b] - ball.radius) <= 1e-9;
      }));
    }
    std::vector<Disk_2> result;
    for (const int b : found) result.push_back({all->balls.centers[b], all->balls.radii[b]});
    kept_ = {found.begin(), found.end()};
    return result;
  }

  /// The boundary of the union of the disks that kept_disks found last.
  std::multiset<Described_arc> arcs_of_kept() {
    const auto all = graph_.structure(inner_voronoi_balls_2_key, progress_).value;
    const Union_boundary_2 boundary =
        union_boundary(std::make_shared<const Balls_2>(subset(all->balls, kept_)), 0, progress_);
    for (const int sample : boundary.samples) all_are_samples_ = all_are_samples_ && sample >= 0;
    return arcs_of(boundary_primitives(boundary));
  }

  void expect_shapes() {
    const auto all = graph_.structure(inner_voronoi_balls_2_key, progress_).value;
    ASSERT_TRUE(all);
    for (const auto& [name, limits] : measures) {
      for (const bool preserves : {false, true}) {
        set(topology_preserving_setting.id, preserves);
        std::size_t count = all->balls.size();
        for (const double limit : limits) {
          SCOPED_TRACE(name + (preserves ? ", preserving, " : ", plain, ") + std::to_string(limit));
          set(name + "-limit", limit);
          const std::vector<Disk_2> disks = kept_disks(name);
          EXPECT_LE(disks.size(), count);
          count = disks.size();
          const auto shape = layer(name + "-medial-axis-shape");
          expect_boundary_of_union(*shape, disks);
          EXPECT_EQ(arcs_of(*shape), arcs_of_kept());
        }
        least_kept_ = std::min(least_kept_, count);
        // A disk of exactly the limit is kept.
        const std::string cut_value = preserves ? name + "-monotone" : name;
        std::vector<double> values = layer(name + "-medial-axis-disks")->find_values(cut_value)->data;
        std::ranges::sort(values);
        set(name + "-limit", values[values.size() / 3]);
        kept_disks(name);
        EXPECT_EQ(arcs_of(*layer(name + "-medial-axis-shape")), arcs_of_kept());
      }
    }
  }

  /// The least limits leave the union of all disks.
  void expect_whole_union() {
    set(ball_source_setting.id, std::string(ball_source_inner_voronoi));
    const auto whole = arcs_of(*layer("union-boundary"));
    ASSERT_FALSE(whole.empty());
    for (const bool preserves : {false, true}) {
      set(topology_preserving_setting.id, preserves);
      for (const auto& [name, limits] : measures) {
        SCOPED_TRACE(name);
        set(name + "-limit", name == "scale" ? 1.0 : 0.0);
        EXPECT_EQ(arcs_of(*layer(name + "-medial-axis-shape")), whole);
      }
    }
  }

  Graph graph_{make_registry_2()};
  Progress progress_;
  std::vector<int> kept_;
  std::size_t least_kept_ = 1000000;
  bool all_are_samples_ = true;
};

TEST_F(Filtration_shapes, AreTheUnionOfTheKeptDisks) {
  std::vector<Point_2> ring = ellipse(1, 1, 60, 0.5, 3);
  for (const Point_2& p : ellipse(0.5, 0.5, 40, 0.5, 4)) ring.push_back(p);
  for (const auto& points : {ellipse(2, 1, 70, 0.5, 8), flower(90, 0.4, 5, 0.4, 2), ring, noisy_curve(80, 0.05, 7)}) {
    graph_.set_inputs(Inputs().with(points_input, points));
    expect_shapes();
  }
  EXPECT_LT(least_kept_, 10U);
  EXPECT_FALSE(all_are_samples_) << "no branch was cut off where disks meet beside a sample";
}

TEST_F(Filtration_shapes, OfOutlinesWithManyDisksThroughOnePoint) {
  graph_.set_inputs(
      Inputs().with(outline_input, Outline_2{{{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 3}, {0, 3}},
                                              {{3, 0.25}, {3.5, 0.25}, {3.5, 0.75}, {3, 0.75}}}}));
  for (const double step : {0.02, 0.05}) {
    set("sampling-step", step);
    expect_shapes();
  }
}

TEST_F(Filtration_shapes, OfTheLeastLimitsAreTheUnionOfAllDisks) {
  for (const auto& points : {ellipse(2, 1, 70, 0.5, 8), flower(90, 0.4, 5), noisy_curve(80, 0.05, 7)}) {
    graph_.set_inputs(Inputs().with(points_input, points));
    expect_whole_union();
  }
  graph_.set_inputs(
      Inputs().with(outline_input, Outline_2{{{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 3}, {0, 3}}}}));
  expect_whole_union();
}

/// [B. Miklos 2010, section 6.2] The reconstruction is part of the shape, whatever is drawn.
TEST_F(Filtration_shapes, AreMadeOfVoronoiDisksWhateverTheBallSource) {
  const std::vector<Point_2> points = flower(90, 0.4, 5, 0.4, 2);
  graph_.set_inputs(Inputs().with(points_input, points));
  const auto expected = arcs_of(*layer("scale-medial-axis-shape"));
  ASSERT_FALSE(expected.empty());
  graph_.set_inputs(graph_.inputs().with(disks_input, std::vector<Disk_2>{{{0, 0}, 3}}));
  EXPECT_EQ(arcs_of(*layer("scale-medial-axis-shape")), expected);
}

TEST_F(Filtration_shapes, SayWhyThereIsNothing) {
  for (const auto& [name, limits] : measures) {
    EXPECT_NE(graph_.layer(name + "-medial-axis-shape", progress_).reason.find("there is nothing to sample"),
              std::string::npos);
  }
  graph_.set_inputs(Inputs().with(outline_input, double_square()));
  for (const auto& [name, limits] : measures) {
    EXPECT_NE(graph_.layer(name + "-medial-axis-shape", progress_).reason.find("enclose nothing"), std::string::npos);
  }
}

}  // namespace
}  // namespace mesecina::test
