// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_geometry_2.h"

#include <gtest/gtest.h>

#include <cmath>

#include "example_scenes.h"

namespace mesecina {
namespace {

TEST(Gl_geometry, EveryPartHasItsElements) {
  const auto set = every_kind();
  std::vector<std::size_t> seen(set->element_count());
  for (Part part :
       {Part::points, Part::segments, Part::rays, Part::arcs, Part::triangles, Part::polygon_edges, Part::balls}) {
    ASSERT_TRUE(has_part(*set, part));
    const Instances instances = whole_part(*set, part, {50, 40});
    EXPECT_EQ(instances.data.size(), instances.elements.size() * static_cast<std::size_t>(floats_per_instance(part)));
    for (std::uint32_t element : instances.elements) ++seen.at(element);
  }
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_GE(seen[i], 1U) << i;
}

TEST(Gl_geometry, AWindowAroundEverythingCutsNothing) {
  const auto set = every_kind();
  for (Part part : {Part::points, Part::segments, Part::arcs, Part::triangles, Part::triangle_edges, Part::polygons,
                    Part::polygon_edges, Part::balls}) {
    const Instances whole = whole_part(*set, part, {50, 40});
    const Cut_out cut = cut_out_part(*set, part, {{50, 40}, 100, 1});
    EXPECT_EQ(cut.near.data, whole.data);
    EXPECT_EQ(cut.near.elements, whole.elements);
    EXPECT_TRUE(cut.far.elements.empty());
  }
}

TEST(Gl_geometry, WhatMissesTheWindowIsLeftOut) {
  const auto set = every_kind();
  for (Part part :
       {Part::points, Part::segments, Part::rays, Part::arcs, Part::triangles, Part::polygons, Part::balls}) {
    const Cut_out cut = cut_out_part(*set, part, {{-1000, -1000}, 10, 1});
    EXPECT_TRUE(cut.near.elements.empty() && cut.far.elements.empty());
  }
}

TEST(Gl_geometry, LinesAreCutAtTheWindow) {
  Primitive_set set;
  set.segments.push_back({add_vertex(set, -1e9, 2), add_vertex(set, 1e9, 2)});
  const Cut_out cut = cut_out_part(set, Part::segments, {{1, 1}, 4, 1});
  EXPECT_EQ(cut.near.data, (std::vector<float>{-4, 1, 4, 1}));
  set.rays.push_back({0, {1, 0, 0}});
  EXPECT_EQ(cut_out_part(set, Part::rays, {{1, 1}, 4, 1}).near.data, (std::vector<float>{-4, 1, 4, 1}));
}

TEST(Gl_geometry, AreasAreCutAtTheWindow) {
  Primitive_set set;
  add_polygon(set, {{-1e9, -1e9}, {1e9, -1e9}, {1e9, 3}, {-1e9, 3}});
  const Instances near = cut_out_part(set, Part::polygons, {{0, 0}, 5, 1}).near;
  double area = 0;
  for (std::size_t i = 0; i < near.data.size(); i += 6) {
    const float* p = near.data.data() + i;
    area += ((p[2] - p[0]) * (p[5] - p[1]) - (p[3] - p[1]) * (p[4] - p[0])) / 2;
  }
  EXPECT_NEAR(area, 10 * 8, 1e-6);
}

TEST(Gl_geometry, LargeCirclesAreKnownByDistanceAndDirection) {
  Primitive_set set;
  set.balls.push_back({add_vertex(set, 1e12 + 3, 0), 1e12});
  const Cut_out cut = cut_out_part(set, Part::balls, {{1, 0}, 10, 1});
  EXPECT_TRUE(cut.near.elements.empty());
  ASSERT_EQ(cut.far.data.size(), static_cast<std::size_t>(floats_of_far_circle));
  EXPECT_NEAR(cut.far.data[0], 1, 1e-6);
  EXPECT_NEAR(cut.far.data[1], 0, 1e-6);
  EXPECT_NEAR(cut.far.data[2], 2, 1e-3);
  EXPECT_EQ(cut.far.data[12], 1);
}

TEST(Gl_geometry, ReachCountsRadii) {
  Primitive_set set;
  set.balls.push_back({add_vertex(set, 10, -20), 5});
  EXPECT_EQ(farthest_reach(set, Part::balls, {0, 0}), 25);
  set.segments.push_back({0, add_vertex(set, 400, 0)});
  EXPECT_EQ(farthest_reach(set, Part::segments, {0, 0}), 400);
  set.vertices[1].x = INFINITY;
  EXPECT_TRUE(std::isinf(farthest_reach(set, Part::segments, {0, 0})));
}

}  // namespace
}  // namespace mesecina
