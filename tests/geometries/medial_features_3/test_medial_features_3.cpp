// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_features_3/medial_features_3.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "geometries/scale_axis_3/scale_axis_3.h"
#include "tests/geometries/union_3/axis_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

/// Of polygons over points.
Medial_complex_3 complex_of(const std::vector<Point_3>& points, const std::vector<std::vector<int>>& faces,
                            const std::vector<std::array<int, 2>>& loose_edges = {}) {
  Medial_complex_3 complex;
  complex.centers = points;
  complex.radii.assign(points.size(), 1);
  complex.balls.assign(points.size(), -1);
  complex.face_offsets = {0};
  std::set<std::array<int, 2>> edges(loose_edges.begin(), loose_edges.end());
  for (const auto& face : faces) {
    complex.face_vertices.insert(complex.face_vertices.end(), face.begin(), face.end());
    complex.face_offsets.push_back(static_cast<int>(complex.face_vertices.size()));
    complex.contacts.push_back({});
    for (std::size_t i = 0; i < face.size(); ++i) {
      const int next = face[(i + 1) % face.size()];
      edges.insert({std::min(face[i], next), std::max(face[i], next)});
    }
  }
  complex.edges.assign(edges.begin(), edges.end());
  return complex;
}

Medial_features_3 features_of(const Medial_complex_3& complex) {
  return medial_features(complex, sheets(complex).sheet_of_face);
}

TEST(Medial_features_3, AFinOnAPlateHasASeamThatEndsTwice) {
  const Medial_complex_3 plate =
      complex_of({{0, 0, 0}, {0, 2, 0}, {-1, 0, 0}, {-1, 2, 0}, {1, 0, 0}, {1, 2, 0}, {0, 0, 1}, {0, 2, 1}, {5, 0, 0}},
                 {{0, 1, 3, 2}, {0, 4, 5, 1}, {0, 1, 7, 6}}, {{4, 8}});
  const Medial_features_3 features = features_of(plate);
  EXPECT_EQ(features.seams.edges, std::vector<int>{0});
  EXPECT_EQ(features.seams.lengths, std::vector<double>{2});
  EXPECT_EQ(features.faces_of_edges[0], 3);
  EXPECT_EQ(features.junctions, (std::vector<int>{0, 1}));
  EXPECT_EQ(features.seams_of_junctions, (std::vector<int>{1, 1}));
  EXPECT_EQ(features.sheets_of_junctions, (std::vector<int>{3, 3}));
  // Three around the sheets, from junction to junction; at the ends of the seam three edges of rims meet. The edge
  // without a face is none.
  EXPECT_EQ(features.rims.count(), 3u);
  EXPECT_THAT(features.rims.lengths, testing::Each(4));
  EXPECT_EQ(features.rims.edges.size(), 9u);
  for (std::size_t i = 0; i < features.rims.edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_EQ(features.rims.curves[i] == features.rims.curves[j],
                features.sheets_of_rims[i] == features.sheets_of_rims[j]);
}

TEST(Medial_features_3, ThreePlanesMeetInOnePoint) {
  const std::vector<Point_3> points{{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<std::vector<int>> faces;
  for (int a = 1; a <= 6; ++a)
    for (int b = a + 1; b <= 6; ++b)
      if ((a - 1) / 2 != (b - 1) / 2) faces.push_back({0, a, b});
  const Medial_features_3 features = features_of(complex_of(points, faces));
  EXPECT_EQ(features.seams.count(), 6u);
  EXPECT_THAT(features.seams.lengths, testing::Each(1));
  EXPECT_THAT(features.junctions, testing::SizeIs(7));
  EXPECT_EQ(features.seams_of_junctions, (std::vector<int>{6, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(features.sheets_of_junctions, (std::vector<int>{12, 4, 4, 4, 4, 4, 4}));
  EXPECT_EQ(features.rims.edges.size(), 12u);
}

TEST(Medial_features_3, AClosedSeamHasNoJunctions) {
  // A tube with a wall across.
  constexpr int around = 12;
  std::vector<Point_3> points;
  std::vector<std::vector<int>> faces;
  for (int level = 0; level < 3; ++level)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(level)});
    }
  std::vector<int> wall;
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around;
    faces.push_back({i, j, around + j, around + i});
    faces.push_back({around + i, around + j, 2 * around + j, 2 * around + i});
    wall.push_back(around + i);
  }
  faces.push_back(wall);
  const Medial_features_3 features = features_of(complex_of(points, faces));
  const double length = 2 * around * std::sin(std::numbers::pi / around);
  ASSERT_EQ(features.seams.count(), 1u);
  EXPECT_NEAR(features.seams.lengths[0], length, 1e-12);
  EXPECT_TRUE(features.junctions.empty());
  ASSERT_EQ(features.rims.count(), 2u);
  EXPECT_NEAR(features.rims.lengths[0], length, 1e-12);
  EXPECT_NEAR(features.rims.lengths[1], length, 1e-12);
}

TEST(Medial_features_3, AreasAreThoseOfPolygons) {
  EXPECT_THAT(areas_of_faces(complex_of({{0, 0, 5}, {3, 0, 5}, {3, 2, 5}, {0, 2, 5}, {0, 0, 9}},
                                        {{0, 1, 2, 3}, {3, 2, 1, 0}, {0, 4, 1}})),
              testing::ElementsAre(6, 6, 6));
}

/// Everything by its definition, from faces as lists of vertices.
testing::AssertionResult are_by_definition(const Medial_complex_3& complex) {
  const Medial_features_3 features = features_of(complex);
  const std::vector<int> sheet_of_face = sheets(complex).sheet_of_face;
  std::map<std::array<int, 2>, std::vector<int>> faces_of;
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    const auto corners = complex.face(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto [a, b] = std::minmax(corners[i], corners[(i + 1) % corners.size()]);
      faces_of[{a, b}].push_back(static_cast<int>(f));
    }
  }
  const auto face_count = [&](int e) {
    return faces_of.contains(complex.edges[e]) ? faces_of[complex.edges[e]].size() : 0;
  };
  const auto are_curves = [&](const Medial_curves_3& curves, const auto& wants) {
    std::vector<int> expected;
    for (int e = 0; e < static_cast<int>(complex.edges.size()); ++e)
      if (wants(face_count(e))) expected.push_back(e);
    if (curves.edges != expected) return false;
    std::map<int, std::vector<int>> at;  // places in `edges`
    for (int i = 0; i < static_cast<int>(curves.edges.size()); ++i)
      for (const int v : complex.edges[curves.edges[i]]) at[v].push_back(i);
    std::vector<double> lengths(curves.count(), 0);
    int most = -1;
    for (int i = 0; i < static_cast<int>(curves.edges.size()); ++i) {
      if (curves.curves[i] > most + 1) return false;
      most = std::max(most, curves.curves[i]);
      const auto& [a, b] = complex.edges[curves.edges[i]];
      lengths[curves.curves[i]] += distance(complex.centers[a], complex.centers[b]);
      // All that can be reached from here, and nothing else.
      std::set<int> reached{i};
      std::vector<int> open{i};
      while (!open.empty()) {
        const int here = open.back();
        open.pop_back();
        for (const int v : complex.edges[curves.edges[here]])
          if (at[v].size() == 2)
            for (const int next : at[v])
              if (reached.insert(next).second) open.push_back(next);
      }
      for (int j = 0; j < static_cast<int>(curves.edges.size()); ++j)
        if (reached.contains(j) != (curves.curves[j] == curves.curves[i])) return false;
    }
    for (std::size_t c = 0; c < lengths.size(); ++c)
      if (std::abs(lengths[c] - curves.lengths[c]) > 1e-9 * (1 + lengths[c])) return false;
    return true;
  };
  if (!are_curves(features.seams, [](std::size_t faces) { return faces >= 3; }))
    return testing::AssertionFailure() << "other seams";
  if (!are_curves(features.rims, [](std::size_t faces) { return faces == 1; }))
    return testing::AssertionFailure() << "other rims";
  for (std::size_t i = 0; i < features.rims.edges.size(); ++i)
    if (features.sheets_of_rims[i] != sheet_of_face[faces_of[complex.edges[features.rims.edges[i]]].front()])
      return testing::AssertionFailure() << "a rim of another sheet";
  std::vector<int> junctions;
  for (int v = 0; v < static_cast<int>(complex.centers.size()); ++v) {
    int seams = 0;
    for (int e = 0; e < static_cast<int>(complex.edges.size()); ++e)
      seams += std::ranges::count(complex.edges[e], v) > 0 && face_count(e) >= 3 ? 1 : 0;
    if (seams == 0 || seams == 2) continue;
    std::set<int> around;
    for (std::size_t f = 0; f < complex.face_count(); ++f)
      if (std::ranges::count(complex.face(f), v) > 0) around.insert(sheet_of_face[f]);
    const std::size_t place = junctions.size();
    junctions.push_back(v);
    if (place >= features.junctions.size() || features.seams_of_junctions[place] != seams ||
        features.sheets_of_junctions[place] != static_cast<int>(around.size()))
      return testing::AssertionFailure() << "another junction at " << v;
  }
  if (features.junctions != junctions) return testing::AssertionFailure() << "other junctions";
  return testing::AssertionSuccess();
}

TEST(Medial_features_3, AreThoseOfTheDefinitionForUnionsOfBalls) {
  expect_of_balls(2, [](const std::vector<Ball_3>& balls) { return are_by_definition(axis_of(balls).complex); });
}

TEST(Medial_features_3, AreThoseOfTheDefinitionForManyBalls) {
  const Medial_complex_3 complex = axis_of(many_balls(100, 14, 3)).complex;
  EXPECT_TRUE(are_by_definition(complex));
  const Medial_features_3 features = features_of(complex);
  EXPECT_GT(features.seams.count(), 20u);
  EXPECT_GT(features.rims.count(), 5u);
  EXPECT_GT(features.junctions.size(), 20u);
}

}  // namespace
}  // namespace mesecina::test
