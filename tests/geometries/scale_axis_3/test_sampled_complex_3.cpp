// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "geometries/scale_axis_3/scale_axis_3.h"

namespace mesecina {
namespace {

/// Two triangles with an edge in common, an edge that hangs on them, and a vertex alone; all balls touch (0, 0, 3).
Medial_complex_3 example() {
  Medial_complex_3 complex;
  complex.centers = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {8, 0, 0}, {30, 0, 0}};
  for (const Point_3& c : complex.centers) complex.radii.push_back(distance(c, {0, 0, 3}));
  complex.balls.assign(6, -1);
  complex.face_offsets = {0, 3, 6};
  complex.face_vertices = {0, 1, 2, 0, 2, 3};
  complex.contacts.assign(2, {Point_3{0, 0, 3}, Point_3{0, 0, -3}});
  complex.edges = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 4}, {2, 3}};
  return complex;
}

double intersection_angle(const Ball_complex_3& complex, int a, int b) {
  const double d = distance(complex.centers[a], complex.centers[b]);
  const double r = complex.radii[a];
  const double q = complex.radii[b];
  if (d <= std::abs(r - q)) return 180;
  return std::acos(std::clamp((d * d - r * r - q * q) / (2 * r * q), -1.0, 1.0)) * 180 / std::numbers::pi;
}

TEST(Sampled_complex_3, NeighboursMeetAtTheAngleAndEdgesFitTogether) {
  for (const double scale : {1.0, 1.5, 4.0}) {
    for (const double angle : {0.0, 90.0, 150.0, 170.0}) {
      Progress progress;
      const Ball_complex_3 result = sampled(example(), scale, angle, progress);
      std::map<std::array<int, 2>, int> faces_of_edges;
      double area = 0;
      for (const auto& t : result.triangles) {
        for (int i = 0; i < 3; ++i) {
          const int a = t[i];
          const int b = t[(i + 1) % 3];
          EXPECT_GE(intersection_angle(result, a, b), angle - 1e-9);
          ++faces_of_edges[{std::min(a, b), std::max(a, b)}];
        }
        const Point_3 n =
            cross(result.centers[t[1]] - result.centers[t[0]], result.centers[t[2]] - result.centers[t[0]]);
        EXPECT_GT(n.z, 0);
        area += n.z / 2;
      }
      EXPECT_NEAR(area, 12, 1e-9);
      for (const auto& [a, b] : result.edges) EXPECT_GE(intersection_angle(result, a, b), angle - 1e-9);
      // The rectangle's boundary has edges with one face, the rest two; a crack would leave more with one.
      double rim = 0;
      for (const auto& [ends, count] : faces_of_edges) {
        EXPECT_LE(count, 2);
        if (count == 1) rim += distance(result.centers[ends[0]], result.centers[ends[1]]);
      }
      EXPECT_NEAR(rim, 14, 1e-9);
      for (std::size_t v = 0; v < result.centers.size(); ++v)
        EXPECT_NEAR(result.radii[v] * scale, distance(result.centers[v], {0, 0, 3}), 1e-9);
      EXPECT_EQ(result.points, std::vector<int>{5});
      EXPECT_EQ(result.face_of_triangle.size(), result.triangles.size());
    }
  }
}

TEST(Sampled_complex_3, NothingIsSplitWhereBallsOverlapEnough) {
  Progress progress;
  const Ball_complex_3 result = sampled(example(), 1, 0, progress);
  EXPECT_EQ(result.centers.size(), 6u);
  EXPECT_EQ(result.triangles.size(), 2u);
  EXPECT_EQ(result.edges, (std::vector<std::array<int, 2>>{{1, 4}}));
}

TEST(Sampled_complex_3, HalvingEndsWhereBallsOnlyTouch) {
  Medial_complex_3 complex;
  complex.centers = {{0, 0, 0}, {2, 0, 0}};
  complex.radii = {1, 1};
  complex.balls = {0, 1};
  complex.face_offsets = {0};
  complex.edges = {{0, 1}};
  Progress progress;
  const Ball_complex_3 result = sampled(complex, 1, 150, progress);
  // The ball in the middle is a point on both spheres.
  ASSERT_EQ(result.centers.size(), 3u);
  EXPECT_EQ(result.centers[2], (Point_3{1, 0, 0}));
  EXPECT_EQ(result.radii[2], 0);
}

}  // namespace
}  // namespace mesecina
