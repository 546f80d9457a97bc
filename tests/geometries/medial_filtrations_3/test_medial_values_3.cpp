// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "core/formats/spatial_readers.h"
#include "core/graph.h"
#include "geometries/medial_filtrations_3/medial_scale_3.h"
#include "geometries/modules_3.h"
#include "geometries/scale_axis_3/scale_axis_3.h"
#include "geometries/union_3/module.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"
#include "tests/geometries/union_3/axis_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

std::array<int, 2> side_of(std::span<const int> face, std::size_t i) {
  const auto [a, b] = std::minmax(face[i], face[(i + 1) % face.size()]);
  return {a, b};
}

/// Values by the definitions, from those of faces and those that edges and vertices would have if they bounded nothing.
template <class Of_edge, class Of_vertex>
Medial_values_3 with_bounds(const Medial_complex_3& complex, const std::vector<double>& faces, const Of_edge& of_edge,
                            const Of_vertex& of_vertex) {
  std::map<std::array<int, 2>, double> edges;
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    const auto face = complex.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const auto place = edges.try_emplace(side_of(face, i), -infinity).first;
      place->second = std::max(place->second, faces[f]);
    }
  }
  std::map<int, double> vertices;
  Medial_values_3 result;
  result.faces = faces;
  for (const auto& edge : complex.edges) {
    result.edges.push_back(edges.contains(edge) ? edges[edge] : of_edge(edge));
    for (const int v : edge) {
      const auto place = vertices.try_emplace(v, -infinity).first;
      place->second = std::max(place->second, result.edges.back());
    }
  }
  for (int v = 0; v < static_cast<int>(complex.centers.size()); ++v)
    result.vertices.push_back(vertices.contains(v) ? vertices[v] : of_vertex(v));
  return result;
}

testing::AssertionResult are_near(const std::vector<double>& found, const std::vector<double>& expected,
                                  double tolerance, const char* what) {
  if (found.size() != expected.size()) return testing::AssertionFailure() << found.size() << " " << what;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i] != expected[i] && !(std::abs(found[i] - expected[i]) <= tolerance))
      return testing::AssertionFailure() << what << " " << i << ": " << found[i] << " instead of " << expected[i];
  return testing::AssertionSuccess();
}
testing::AssertionResult are_near(const Medial_values_3& found, const Medial_values_3& expected, double tolerance) {
  auto result = are_near(found.faces, expected.faces, tolerance, "faces");
  if (result) result = are_near(found.edges, expected.edges, tolerance, "edges");
  if (result) result = are_near(found.vertices, expected.vertices, tolerance, "vertices");
  return result;
}

/// Below it two ends are one ball.
constexpr double rounding = 1e-12;

/// Twice the area of the triangle of the centers and a contact, divided by the length of the edge.
double height_of_contact(const Medial_complex_3& complex, const std::array<int, 2>& edge) {
  const double a = complex.radii[edge[0]];
  const double b = complex.radii[edge[1]];
  const double c = distance(complex.centers[edge[0]], complex.centers[edge[1]]);
  if (c <= rounding * a) return a;
  const double square = (a + b + c) * (b + c - a) * (a + c - b) * (a + b - c);
  return std::sqrt(std::max(square, 0.0)) / (2 * c);
}

/// 180 where no angle of the triangle of the centers and a contact is obtuse at a center: then the edge passes through
/// the middle of the circle. Else by trying points of the edge.
double largest_angle_on(const Medial_complex_3& complex, const std::array<int, 2>& edge) {
  const double a = complex.radii[edge[0]];
  const double b = complex.radii[edge[1]];
  const double c = distance(complex.centers[edge[0]], complex.centers[edge[1]]);
  if (c <= rounding * a) return 180;
  if (c * c + a * a >= b * b && c * c + b * b >= a * a) return 180;
  double largest = 0;
  constexpr int steps = 1000;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double to_contact = std::sqrt((1 - t) * a * a + t * b * b - t * (1 - t) * c * c);
    largest = std::max(largest, 2 * std::asin(std::min(1.0, height_of_contact(complex, edge) / to_contact)));
  }
  return largest * 180 / std::numbers::pi;
}

std::vector<double> scale_by_double_loop(const Medial_complex_3& complex, const std::vector<double>& slopes) {
  std::vector<double> result(complex.radii.size(), infinity);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < result.size(); ++j) {
      if (!(complex.radii[j] > complex.radii[i])) continue;
      const double d = distance(complex.centers[i], complex.centers[j]);
      const double least = std::max(1.0, 1 / (slopes[i] + d / (2 * complex.radii[i])));
      result[i] = std::min(result[i], std::max(least, d / (complex.radii[j] - complex.radii[i])));
    }
  }
  return result;
}

testing::AssertionResult have_values_by_definition(const Medial_complex_3& complex) {
  Progress progress;
  std::vector<double> lambda;
  for (const auto& [p, q] : complex.contacts) lambda.push_back(distance(p, q) / 2);
  const auto found_lambda = lambda_values(complex);
  auto result = are_near(found_lambda,
                         with_bounds(
                             complex, lambda, [&](const auto& edge) { return height_of_contact(complex, edge); },
                             [&](int v) { return complex.radii[v]; }),
                         1e-6);
  if (!result) return result << " (lambda)";
  result = are_near(angle_values(complex, progress),
                    with_bounds(
                        complex, angle_of_faces(complex, progress),
                        [&](const auto& edge) { return largest_angle_on(complex, edge); }, [](int) { return 180; }),
                    1);
  if (!result) return result << " (angle)";
  const std::vector<double> scale = scale_by_double_loop(complex, slope_of_vertices(complex, progress));
  std::vector<double> of_faces;
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    of_faces.push_back(infinity);
    for (const int v : complex.face(f)) of_faces.back() = std::min(of_faces.back(), scale[v]);
  }
  Medial_values_3 expected = with_bounds(
      complex, of_faces, [&](const auto& edge) { return std::min(scale[edge[0]], scale[edge[1]]); },
      [&](int v) { return scale[v]; });
  Medial_values_3 found = scale_values(complex, progress);
  // Compared on a logarithmic scale: between nearly equal balls quotients are large, and at last nothing but rounding.
  constexpr double all_rounding = 1e8;
  for (Medial_values_3* values : {&expected, &found})
    for (auto* part : {&values->faces, &values->edges, &values->vertices})
      for (double& value : *part) value = std::log(std::min(value, all_rounding));
  result = are_near(found, expected, 1e-7);
  if (!result) return result << " (scale)";
  return result;
}

TEST(Medial_values_3, AreByDefinitionOnAllKindsOfBalls) {
  expect_of_clear_balls(repetitions(10), [](const std::vector<Ball_3>& balls) {
    return have_values_by_definition(axis_of(balls).complex);
  });
}

TEST(Medial_values_3, AreByDefinitionOnManyBallsAndSolids) {
  for (const double neighbors : {0.5, 2.0, 10.0})
    EXPECT_TRUE(have_values_by_definition(axis_of(many_balls(500, neighbors, 5)).complex));
  for (const Smooth_solid& solid : smooth_solids())
    EXPECT_TRUE(have_values_by_definition(axis_of(inner_voronoi_balls(solid, 300, 1e-4, 2)).complex)) << solid.name;
}

TEST(Medial_values_3, AreByDefinitionOnARealShape) {
  MESECINA_NEED_DATA();
  const auto file = *data_folder() / "3d" / "elephant.off";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
  Graph graph(make_registry_3());
  graph.set_inputs(read_off(file).inputs);
  graph.set_settings(Settings().with("delta", 0.02));
  Progress progress;
  const auto complex = graph.structure(medial_axis_3_key, progress).value;
  ASSERT_TRUE(complex);
  EXPECT_GT(complex->face_count(), 1000u);
  EXPECT_TRUE(have_values_by_definition(*complex));
}

TEST(Medial_values_3, OfOneAndTwoBalls) {
  Progress progress;
  const Medial_complex_3 one = axis_of({{{1, 2, 3}, 4}}).complex;
  EXPECT_EQ(lambda_values(one).vertices, (std::vector<double>{4}));
  EXPECT_EQ(angle_values(one, progress).vertices, (std::vector<double>{180}));
  EXPECT_EQ(scale_values(one, progress).vertices, (std::vector<double>{infinity}));

  const Medial_complex_3 two = axis_of({{{0, 0, 0}, 5}, {{0, 0, 8}, 5}}).complex;
  EXPECT_EQ(lambda_values(two).edges, (std::vector<double>{3}));
  EXPECT_EQ(lambda_values(two).vertices, (std::vector<double>{3, 3}));
  EXPECT_EQ(angle_values(two, progress).edges, (std::vector<double>{180}));
  EXPECT_EQ(scale_values(two, progress).edges, (std::vector<double>{infinity}));

  const Medial_complex_3 unequal = axis_of({{{0, 0, 0}, 2}, {{3, 0, 0}, 1.25}}).complex;
  EXPECT_EQ(scale_values(unequal, progress).edges, (std::vector<double>{4}));
  EXPECT_EQ(scale_values(unequal, progress).vertices, (std::vector<double>{4, 4}));
  EXPECT_EQ(scale_of_vertices(unequal, progress), (std::vector<double>{infinity, 4}));

  const Medial_complex_3 touching = axis_of({{{0, 0, 0}, 1}, {{2, 0, 0}, 1}}).complex;
  EXPECT_EQ(lambda_values(touching).edges, (std::vector<double>{0}));
  EXPECT_EQ(angle_values(touching, progress).edges, (std::vector<double>{180}));
}

/// Contacts of an edge without faces are on the circle where the spheres of its ends meet, so that its middle is as far
/// from them as the boundary is.
TEST(Medial_values_3, EdgesWithoutFacesHaveCirclesOfContact) {
  int edges = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::vector<Ball_3> balls = many_balls(15, 1, seed);
    const Medial_complex_3 complex = axis_of(balls).complex;
    const Boundary_oracle_3 boundary(balls);
    for (const auto& [a, b] : loose_parts(complex).edges) {
      ++edges;
      const double d = distance(complex.centers[a], complex.centers[b]);
      const double square = (std::pow(complex.radii[a], 2) + std::pow(complex.radii[b], 2)) / 2 - d * d / 4;
      EXPECT_NEAR(boundary.distance_to_boundary(midpoint(complex.centers[a], complex.centers[b])), std::sqrt(square),
                  1e-6 * boundary.scale());
    }
  }
  EXPECT_GT(edges, 30);
}

TEST(Medial_values_3, SlopesBoundHowFastRadiiGrow) {
  Progress progress;
  Random random(4);
  for (const Smooth_solid& solid : smooth_solids()) {
    SCOPED_TRACE(solid.name);
    const Medial_complex_3 complex = axis_of(inner_voronoi_balls(solid, 300, 1e-4, 6)).complex;
    const std::vector<double> slopes = slope_of_vertices(complex, progress);
    // Along edges, and between vertices at random.
    std::vector<std::array<int, 2>> pairs = complex.edges;
    for (int i = 0; i < 20000; ++i) {
      const int a = random.index(static_cast<int>(slopes.size()));
      pairs.push_back({a, random.index(static_cast<int>(slopes.size()))});
    }
    for (auto [a, b] : pairs) {
      if (complex.radii[a] > complex.radii[b]) std::swap(a, b);
      const double d = distance(complex.centers[a], complex.centers[b]);
      ASSERT_LE(complex.radii[b] - complex.radii[a], d * (slopes[a] + d / (2 * complex.radii[a])) + 1e-9);
    }
    // And no lesser slope would do: some direction is as far from all contacts.
    std::vector<double> fastest(slopes.size(), 0);
    for (int trial = 0; trial < 300; ++trial) {
      Point_3 e{random.uniform(-1, 1), 0, 0};
      e.y = random.uniform(-1, 1);
      e.z = random.uniform(-1, 1);
      e = (1 / std::sqrt(dot(e, e))) * e;
      std::vector<double> growth(slopes.size(), 1);
      for (std::size_t f = 0; f < complex.face_count(); ++f)
        for (const int v : complex.face(f))
          for (const Point_3& k : complex.contacts[f])
            growth[v] = std::min(growth[v], dot(e, complex.centers[v] - k) / distance(complex.centers[v], k));
      for (std::size_t v = 0; v < growth.size(); ++v) fastest[v] = std::max(fastest[v], growth[v]);
    }
    int near = 0;
    for (std::size_t v = 0; v < slopes.size(); ++v) {
      ASSERT_GE(slopes[v], fastest[v] - 1e-9) << v;
      if (slopes[v] <= fastest[v] + 0.15) ++near;
    }
    EXPECT_GT(near, 0.95 * static_cast<double>(slopes.size()));
  }
}

TEST(Medial_values_3, SheetsOfEdgesAndVertices) {
  const Medial_complex_3 complex = axis_of(many_balls(400, 10, 9)).complex;
  const Medial_values_3 found = sheet_values(complex);
  const std::vector<int> sheet_of_face = sheets(complex).sheet_of_face;
  std::vector<std::set<int>> of_vertices(complex.centers.size());
  std::map<std::array<int, 2>, std::set<int>> of_edges;
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    const auto face = complex.face(f);
    EXPECT_EQ(found.faces[f], sheet_of_face[f]);
    for (std::size_t i = 0; i < face.size(); ++i) {
      of_vertices[face[i]].insert(sheet_of_face[f]);
      of_edges[side_of(face, i)].insert(sheet_of_face[f]);
    }
  }
  const auto only = [](const std::set<int>& some) { return some.size() == 1 ? *some.begin() : -1; };
  for (std::size_t v = 0; v < of_vertices.size(); ++v) ASSERT_EQ(found.vertices[v], only(of_vertices[v]));
  for (std::size_t e = 0; e < complex.edges.size(); ++e) ASSERT_EQ(found.edges[e], only(of_edges[complex.edges[e]]));
}

}  // namespace
}  // namespace mesecina::test
