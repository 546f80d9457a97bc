// SPDX-License-Identifier: GPL-3.0-or-later
// The filtered layers of the medial axis in space, through the graph.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "core/formats/spatial_readers.h"
#include "core/graph.h"
#include "geometries/medial_filtrations_3/module.h"
#include "geometries/modules_3.h"
#include "geometries/union_3/module.h"
#include "tests/geometries/shapes.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

constexpr const char* measures[] = {"lambda", "angle", "scale"};

Primitive_set layer_of(Graph& graph, const std::string& id) {
  Progress progress;
  const auto outcome = graph.layer(id, progress);
  EXPECT_TRUE(outcome) << id << ": " << outcome.reason;
  return outcome ? *outcome.value : Primitive_set();
}

/// The layer under its cut.
Primitive_set cut_layer(Graph& graph, const std::string& id) {
  const auto cut = graph.registry().cut(*graph.registry().find_layer(id), graph.settings());
  EXPECT_TRUE(cut.has_value());
  return apply_cut(layer_of(graph, id), *cut);
}

using Vertices = std::set<int>;

/// Elements by the numbers of vertices in the whole complex: ids of points are such.
struct Named_elements {
  std::set<Vertices> faces;
  std::set<Vertices> edges;
  Vertices vertices;
  bool operator==(const Named_elements&) const = default;
};

Named_elements named(const Primitive_set& set) {
  std::vector<int> names(set.vertices.size(), -1);
  for (std::size_t i = 0; i < set.points.size(); ++i) names[set.points[i]] = static_cast<int>(set.id(i));
  Named_elements result;
  result.vertices.insert(names.begin(), names.end());
  for (const auto& [v, w] : set.segments) result.edges.insert({names[v], names[w]});
  for (std::size_t f = 0; f < set.polygon_count(); ++f) {
    Vertices face;
    for (const int v : set.polygon(f)) face.insert(names[v]);
    result.faces.insert(face);
  }
  return result;
}

/// Faces that reach the limit and what bounds them; and what bounds nothing by its own value.
Named_elements kept_by_definition(const Medial_complex_3& complex, const Medial_values_3& values, double limit) {
  Named_elements result;
  const auto add_edge = [&](int v, int w) {
    result.edges.insert({v, w});
    result.vertices.insert({v, w});
  };
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (!(values.faces[f] >= limit)) continue;
    const auto face = complex.face(f);
    result.faces.insert(Vertices(face.begin(), face.end()));
    for (std::size_t i = 0; i < face.size(); ++i) add_edge(face[i], face[(i + 1) % face.size()]);
  }
  const Loose_parts_3 loose = loose_parts(complex);
  for (std::size_t e = 0; e < complex.edges.size(); ++e)
    if (values.edges[e] >= limit && std::ranges::binary_search(loose.edges, complex.edges[e]))
      add_edge(complex.edges[e][0], complex.edges[e][1]);
  for (const int v : loose.vertices)
    if (values.vertices[v] >= limit) result.vertices.insert(v);
  return result;
}

/// Under many limits each layer is what the definition says, and a complex.
void expect_filtrations(const Inputs& inputs, const Settings& settings) {
  Graph graph(make_registry_3());
  graph.set_inputs(inputs);
  Progress progress;
  for (const char* name : measures) {
    SCOPED_TRACE(name);
    const std::string id = std::string(name) + "-medial-axis";
    const std::string limit_id = std::string(name) + "-limit";
    graph.set_settings(settings);
    const auto complex = graph.structure(medial_axis_3_key, progress).value;
    const auto values = graph.structure(Key<Medial_values_3>{std::string(name) + "-importance-3"}, progress).value;
    ASSERT_TRUE(complex && values);
    std::vector<double> limits = values->faces;
    limits.insert(limits.end(), values->edges.begin(), values->edges.end());
    std::erase_if(limits, [](double limit) { return !std::isfinite(limit); });
    std::ranges::sort(limits);
    for (const double part : {0.0, 0.1, 0.5, 0.9, 0.999}) {
      const double limit = limits[static_cast<std::size_t>(part * static_cast<double>(limits.size() - 1))];
      graph.set_settings(settings.with(limit_id, limit));
      const Primitive_set kept = cut_layer(graph, id);
      EXPECT_EQ(kept.points.size(), kept.vertices.size());
      EXPECT_EQ(kept.radii.size(), kept.vertices.size());
      EXPECT_TRUE(named(kept) == kept_by_definition(*complex, *values, limit)) << limit;
      const auto found = topology(kept);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->euler, static_cast<std::int64_t>(kept.points.size()) -
                                  static_cast<std::int64_t>(kept.segments.size()) +
                                  static_cast<std::int64_t>(kept.polygon_count()));
    }
  }
}

TEST(Medial_filtrations_3, KeepWhatTheDefinitionSays) {
  for (const double neighbors : {1.0, 4.0, 12.0}) {
    SCOPED_TRACE(neighbors);
    expect_filtrations(Inputs().with(balls_input, many_balls(300, neighbors, 11)), {});
  }
}

TEST(Medial_filtrations_3, KeepWhatTheDefinitionSaysOnRealShapes) {
  MESECINA_NEED_DATA();
  const auto file = *data_folder() / "3d" / "elephant.off";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  expect_filtrations(read_off(file).inputs, Settings().with("delta", 0.03));
}

TEST(Medial_filtrations_3, OfNoLimitAreTheAxis) {
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(balls_input, many_balls(400, 6, 12)));
  graph.set_settings(Settings().with("lambda-limit", 0.0).with("angle-limit", 0.0).with("scale-limit", 1.0));
  const Primitive_set axis = layer_of(graph, "medial-axis");
  const auto of_axis = topology(axis);
  ASSERT_TRUE(of_axis);
  EXPECT_EQ(of_axis, topology(layer_of(graph, "dual")));
  for (const char* name : measures) {
    const Primitive_set kept = cut_layer(graph, std::string(name) + "-medial-axis");
    EXPECT_EQ(kept.element_count(), axis.element_count()) << name;
    EXPECT_EQ(topology(kept), of_axis) << name;
    ASSERT_NE(axis.find_values(name), nullptr);
    EXPECT_EQ(kept.find_values(name)->data, axis.find_values(name)->data);
  }
}

TEST(Medial_filtrations_3, MovingALimitComputesNothing) {
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(balls_input, many_balls(200, 6, 13)));
  for (const char* name : measures) layer_of(graph, std::string(name) + "-medial-axis");
  graph.clear_stages();
  graph.set_settings(Settings().with("lambda-limit", 0.3).with("angle-limit", 100.0).with("scale-limit", 1.5));
  for (const char* name : measures) layer_of(graph, std::string(name) + "-medial-axis");
  EXPECT_TRUE(graph.stages().empty());
}

TEST(Medial_filtrations_3, ContactsBelongToTheFacesOfTheAxis) {
  Graph graph(make_registry_3());
  const std::vector<Ball_3> balls = many_balls(200, 8, 14);
  graph.set_inputs(Inputs().with(balls_input, balls));
  const Primitive_set axis = layer_of(graph, "medial-axis");
  const Primitive_set contacts = layer_of(graph, "medial-contacts");
  ASSERT_GT(axis.polygon_count(), 100u);
  ASSERT_EQ(contacts.segments.size(), axis.polygon_count());
  const std::size_t first = axis.points.size() + axis.segments.size();
  for (std::size_t i = 0; i < contacts.segments.size(); ++i) {
    ASSERT_EQ(contacts.id(i), static_cast<std::int64_t>(first + i));
    const auto corners = axis.polygon(i);
    const auto [from, to] = contacts.segments[i];
    for (const int v : corners) {
      ASSERT_NEAR(distance(axis.vertices[v], contacts.vertices[from]), axis.radii[v], 1e-7);
      ASSERT_NEAR(distance(axis.vertices[v], contacts.vertices[to]), axis.radii[v], 1e-7);
    }
    for (const char* name : {"from-ball-0", "from-ball-1", "from-ball-2", "to-ball-0", "to-ball-1", "to-ball-2"}) {
      const Ball_3& ball = balls.at(static_cast<std::size_t>(contacts.find_values(name)->data[i]));
      const Point_3& contact = contacts.vertices[name[0] == 'f' ? from : to];
      ASSERT_NEAR(distance(ball.center, contact), ball.radius, 1e-7) << name;
    }
  }
}

}  // namespace
}  // namespace mesecina::test
