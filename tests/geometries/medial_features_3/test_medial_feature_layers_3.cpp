// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/graph.h"
#include "geometries/medial_features_3/module.h"
#include "geometries/modules_3.h"
#include "geometries/scale_axis_3/module.h"
#include "geometries/union_3/module.h"
#include "tests/geometries/solid_3/meshes_3.h"

namespace mesecina::test {
namespace {

class Box_graph {
 public:
  explicit Box_graph(const Settings& settings = Settings()) : graph(make_registry_3()) {
    graph.set_inputs(Inputs().with(mesh_input, box_mesh({0, 0, 0}, {3, 2, 1})));
    graph.set_settings(settings.with("delta", 0.06));
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

  Graph graph;
  Progress progress;
};

const std::vector<double>& values_of(const Primitive_set& set, const char* name) {
  const Values* values = set.find_values(name);
  EXPECT_NE(values, nullptr) << name;
  static const std::vector<double> none;
  return values != nullptr ? values->data : none;
}

TEST(Medial_feature_layers_3, EdgesHaveTheNumbersOfTheMedialAxis) {
  Box_graph graph;
  const Primitive_set axis = graph.layer("medial-axis");
  for (const char* id : {"seams", "rims"}) {
    const Primitive_set curves = graph.layer(id);
    ASSERT_GT(curves.segments.size(), 10u);
    ASSERT_EQ(curves.radii.size(), curves.vertices.size());
    for (std::size_t i = 0; i < curves.segments.size(); ++i) {
      const auto& there = axis.segments[static_cast<std::size_t>(curves.id(i)) - axis.points.size()];
      for (int end = 0; end < 2; ++end) {
        EXPECT_EQ(curves.vertices[curves.segments[i][end]], axis.vertices[there[end]]);
        EXPECT_EQ(curves.radii[curves.segments[i][end]], axis.radii[there[end]]);
      }
    }
  }
  const Primitive_set junctions = graph.layer("junctions");
  ASSERT_GT(junctions.points.size(), 2u);
  for (std::size_t i = 0; i < junctions.points.size(); ++i) {
    EXPECT_EQ(junctions.vertices[junctions.points[i]], axis.vertices[junctions.id(i)]);
    EXPECT_EQ(values_of(junctions, "radius")[i], axis.radii[junctions.id(i)]);
  }
}

TEST(Medial_feature_layers_3, ValuesOfACurveAreThoseOfAllItsEdges) {
  Box_graph graph;
  const Primitive_set seams = graph.layer("seams");
  std::map<double, double> lengths;
  for (std::size_t i = 0; i < seams.segments.size(); ++i) {
    const auto& [a, b] = seams.segments[i];
    lengths[values_of(seams, "seam")[i]] += distance(seams.vertices[a], seams.vertices[b]);
    EXPECT_GE(values_of(seams, "faces")[i], 3);
  }
  for (std::size_t i = 0; i < seams.segments.size(); ++i)
    EXPECT_NEAR(values_of(seams, "length")[i], lengths[values_of(seams, "seam")[i]], 1e-12);
  const Primitive_set rims = graph.layer("rims");
  const Primitive_set axis = graph.layer("medial-axis");
  for (std::size_t i = 0; i < rims.segments.size(); ++i)
    EXPECT_EQ(values_of(rims, "sheet")[i], values_of(axis, "sheet")[static_cast<std::size_t>(rims.id(i))]);
}

TEST(Medial_feature_layers_3, SheetsHaveAreaAndTheLargestAngle) {
  Box_graph graph;
  const Primitive_set sheets = graph.layer("sheets");
  const auto axis = graph.get(medial_axis_3_key);
  Progress progress;
  const std::vector<double> angles = angle_of_faces(*axis, progress);
  const std::size_t first = sheets.points.size() + sheets.segments.size();
  std::map<double, double> areas;
  std::map<double, double> largest;
  for (std::size_t f = 0; f < axis->face_count(); ++f) {
    const double sheet = values_of(sheets, "sheet")[first + f];
    const auto corners = axis->face(f);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const Point_3 n = cross(axis->centers[corners[i]] - axis->centers[corners[0]],
                              axis->centers[corners[i + 1]] - axis->centers[corners[0]]);
      areas[sheet] += std::sqrt(dot(n, n)) / 2;
    }
    largest[sheet] = std::max(largest[sheet], angles[f]);
  }
  ASSERT_GT(areas.size(), 3u);
  for (std::size_t f = 0; f < axis->face_count(); ++f) {
    const double sheet = values_of(sheets, "sheet")[first + f];
    EXPECT_NEAR(values_of(sheets, "area")[first + f], areas[sheet], 1e-9);
    EXPECT_EQ(values_of(sheets, "sheet-angle")[first + f], largest[sheet]);
  }
}

TEST(Medial_feature_layers_3, TheScaleAxisIsThatBeforeSamplingWithShrunkenBalls) {
  constexpr double scale = 1.2;
  Box_graph graph(Settings().with("scale", scale));
  const auto pruned = graph.get(pruned_axis_3_key);
  std::size_t count = 0;
  for (const char* id : {"scale-axis-seams", "scale-axis-rims", "scale-axis-junctions"}) {
    const Primitive_set set = graph.layer(id);
    count += set.element_count();
    for (std::size_t v = 0; v < set.vertices.size(); ++v) {
      const auto at = std::ranges::find(pruned->complex.centers, set.vertices[v]) - pruned->complex.centers.begin();
      ASSERT_LT(at, static_cast<std::ptrdiff_t>(pruned->complex.centers.size()));
      EXPECT_EQ(set.radii[v], pruned->complex.radii[at] / scale);
    }
  }
  EXPECT_GT(count, 20u);
  // What was pruned had most of the seams.
  EXPECT_LT(graph.layer("scale-axis-seams").segments.size(), graph.layer("seams").segments.size());
}

TEST(Medial_feature_layers_3, OfOneBallThereIsNothing) {
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(balls_input, std::vector<Ball_3>{{{0, 0, 0}, 1}}));
  Progress progress;
  for (const char* id : {"seams", "rims", "junctions", "scale-axis-seams", "scale-axis-rims", "scale-axis-junctions"}) {
    const auto layer = graph.layer(id, progress);
    ASSERT_TRUE(layer) << layer.reason;
    EXPECT_TRUE(layer.value->is_empty());
  }
  const auto sheets = graph.layer("sheets", progress);
  ASSERT_TRUE(sheets) << sheets.reason;
  EXPECT_EQ(values_of(*sheets.value, "area"), std::vector<double>{0});
  EXPECT_EQ(values_of(*sheets.value, "sheet-angle"), std::vector<double>{180});
}

}  // namespace
}  // namespace mesecina::test
