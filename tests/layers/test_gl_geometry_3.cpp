// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layers/gl_geometry_3.h"

namespace mesecina {
namespace {

using testing::ElementsAre;

/// A pentagon, a triangle at one of its edges, and what hangs on them.
Primitive_set mixed_complex() {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 2, 0}, {-1, 1, 0}, {1, -1, 1}, {9, 9, 9}, {8, 8, 8}};
  set.points = {0, 6};
  set.segments = {{1, 0}, {5, 7}};
  set.rays = {{7, {0, 0, 1}}};
  set.triangles = {{0, 5, 1}};
  set.polygon_vertices = {0, 1, 2, 3, 4};
  set.polygon_offsets = {0, 5};
  set.balls = {{6, 0.5}};
  return set;
}

TEST(Gl_geometry_3, EveryElementIsInOnePart) {
  const Primitive_set set = mixed_complex();
  EXPECT_THAT(pieces_3(set, Part_3::points), ElementsAre(6, 0, 0, 1));
  EXPECT_THAT(pieces_3(set, Part_3::bounding_points), ElementsAre(0, 0, 0, 0));
  // The ray ends at a place of its own behind those of the vertices.
  EXPECT_THAT(pieces_3(set, Part_3::segments), ElementsAre(5, 7, 0, 3, 7, 8, 0, 4));
  EXPECT_THAT(pieces_3(set, Part_3::bounding_segments), ElementsAre(1, 0, 0, 2));
  EXPECT_THAT(pieces_3(set, Part_3::faces), ElementsAre(0, 5, 1, 5, 0, 1, 2, 6, 0, 2, 3, 6, 0, 3, 4, 6));
  EXPECT_EQ(pieces_3(set, Part_3::face_edges).size(), 4U * (3 + 5));
  EXPECT_EQ(first_ball_3(set), 7U);
}

TEST(Gl_geometry_3, PlacesAreRelativeToTheOrigin) {
  const Primitive_set set = mixed_complex();
  const std::vector<float> places = places_3(set, {1, 0, -1});
  ASSERT_EQ(places.size(), 4U * (set.vertices.size() + 1));
  EXPECT_THAT(std::vector<float>(places.begin() + 4, places.begin() + 8), ElementsAre(1, 0, 1, 1));
  EXPECT_GT(places.end()[-2], 100);
  EXPECT_THAT(balls_3(set, {1, 0, -1}), ElementsAre(8, 9, 10, 0.5F));
}

TEST(Gl_geometry_3, NormalsOfFacesAreOfLengthOneAndOfAllPieces) {
  const std::vector<float> normals = face_normals_3(mixed_complex());
  ASSERT_EQ(normals.size(), 4U * 4);
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_THAT(std::vector<float>(normals.begin() + 4 * static_cast<std::ptrdiff_t>(i),
                                   normals.begin() + 4 * static_cast<std::ptrdiff_t>(i) + 4),
                ElementsAre(0, 0, 1, 0));
}

TEST(Gl_geometry_3, NormalsOfVerticesDoNotDependOnTheOrientationOfFaces) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {5, 5, 5}};
  set.triangles = {{0, 1, 2}, {1, 2, 3}};
  const std::vector<float> normals = vertex_normals_3(set);
  for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(std::abs(normals[4 * v + 2]), 1) << v;
  EXPECT_EQ(normals[4 * 4 + 2], 0);
}

TEST(Gl_geometry_3, ClosedMeansEveryEdgeIsPassedBothWays) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_FALSE(is_closed_3(set));
  set.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  EXPECT_TRUE(is_closed_3(set));
  std::swap(set.triangles[2][0], set.triangles[2][1]);
  EXPECT_FALSE(is_closed_3(set));
  set.triangles.pop_back();
  EXPECT_FALSE(is_closed_3(set));
}

}  // namespace
}  // namespace mesecina
