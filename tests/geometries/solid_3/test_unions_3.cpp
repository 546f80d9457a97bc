// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

/// Points in general position lie in the solid iff they lie in one of the parts.
void expect_union(const std::vector<Triangle_mesh_3>& parts, const Topology& topology) {
  const Triangle_mesh_3 mesh = joined(parts);
  const Solid_3 solid = solid_of(mesh);
  EXPECT_TRUE(is_closed(solid.surface));
  EXPECT_EQ(solid.treatment, "united");
  ASSERT_TRUE(solid.topology);
  EXPECT_EQ(*solid.topology, topology);
  const std::vector<Point_3> points = points_around(mesh, 400, 11);
  const std::vector<std::uint8_t> inside = inside_of(solid, points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool expected = std::ranges::any_of(
        parts, [&](const Triangle_mesh_3& part) { return place_of(part, points[i]) != Place::outside; });
    ASSERT_EQ(inside[i] != 0, expected) << points[i].x << ' ' << points[i].y << ' ' << points[i].z;
  }
}

TEST(Unions_3, TwoSpheres) { expect_union({sphere_mesh({0, 0, 0}, 1), sphere_mesh({1, 0.1, 0.2}, 1)}, {1, {1, 0, 0}}); }

TEST(Unions_3, ATurnedSphereIsNotSubtracted) {
  const Triangle_mesh_3 mesh = joined({sphere_mesh({0, 0, 0}, 1), turned(sphere_mesh({1, 0.1, 0.2}, 1))});
  const Solid_3 solid = solid_of(mesh);
  EXPECT_EQ(inside_of(solid, {{0.5, 0, 0}, {1.5, 0, 0}, {-0.5, 0, 0}}), (std::vector<std::uint8_t>{1, 1, 1}));
}

TEST(Unions_3, BoxesThatOverlap) {
  expect_union({box_mesh({0, 0, 0}, {2, 2, 2}), box_mesh({1, 1, 1}, {3, 3, 3})}, {1, {1, 0, 0}});
}

TEST(Unions_3, BoxesWithCommonPlanes) {
  expect_union({box_mesh({0, 0, 0}, {2, 2, 2}), box_mesh({1, 0, 0}, {3, 2, 2})}, {1, {1, 0, 0}});
  const Solid_3 solid = solid_of(joined({box_mesh({0, 0, 0}, {2, 2, 2}), box_mesh({1, 0, 0}, {3, 2, 2})}));
  EXPECT_DOUBLE_EQ(volume(solid.surface), 12);
}

TEST(Unions_3, BoxOnPartOfAnother) {
  expect_union({box_mesh({0, 0, 0}, {4, 4, 1}), box_mesh({1, 1, 1}, {2, 2, 3})}, {1, {1, 0, 0}});
  const Solid_3 solid = solid_of(joined({box_mesh({0, 0, 0}, {4, 4, 1}), box_mesh({1, 1, 1}, {2, 2, 3})}));
  EXPECT_DOUBLE_EQ(volume(solid.surface), 18);
}

TEST(Unions_3, TwoToriThroughEachOther) {
  Triangle_mesh_3 other = torus_mesh(3, 1);
  for (Point_3& p : other.vertices) p = {p.x + 1.3, p.z + 0.1, -p.y};
  expect_union({torus_mesh(3, 1), other}, {-2, {1, 3, 0}});
}

TEST(Unions_3, ManyBoxesThroughEachOther) {
  std::vector<Triangle_mesh_3> parts;
  for (int i = 0; i < 3; ++i) {
    const double at = 2 * i;
    parts.push_back(box_mesh({at, -1, -1}, {at + 1, 6, 6}));
    parts.push_back(box_mesh({-1, at, -2}, {6, at + 1, 7}));
  }
  // A grid of 3 x 3 crossing plates has four shafts.
  expect_union(parts, {-3, {1, 4, 0}});
}

TEST(Unions_3, ACavityBetweenParts) {
  // Six plates around a room.
  expect_union({box_mesh({0, 0, 0}, {6, 6, 1}), box_mesh({0, 0, 5}, {6, 6, 6}), box_mesh({0, 0, 0.5}, {6, 1, 5.5}),
                box_mesh({0, 5, 0.5}, {6, 6, 5.5}), box_mesh({0, 0.5, 0.5}, {1, 5.5, 5.5}),
                box_mesh({5, 0.5, 0.5}, {6, 5.5, 5.5})},
               {2, {1, 0, 1}});
}

TEST(Unions_3, ComponentInsideOfTwoThatCrossIsACavity) {
  const Triangle_mesh_3 mesh = joined({box_mesh({0, 0, 0}, {4, 4, 4}), box_mesh({2, 0.5, 0.5}, {7, 3.5, 3.5}),
                                       box_mesh({2.5, 1, 1}, {3, 2, 2}), box_mesh({5, 1, 1}, {6, 2, 2})});
  const Solid_3 solid = solid_of(mesh);
  ASSERT_TRUE(solid.topology);
  EXPECT_EQ(*solid.topology, (Topology{3, {1, 0, 2}}));
  EXPECT_EQ(inside_of(solid, {{2.75, 1.5, 1.5}, {5.5, 1.5, 1.5}, {3.5, 1.5, 1.5}}),
            (std::vector<std::uint8_t>{0, 0, 1}));
}

TEST(Unions_3, SurfaceThatCrossesItself) {
  // A bar bent until its ends are in each other.
  Triangle_mesh_3 bar;
  const int steps = 40;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 6.6 * i / steps;
    for (const auto& [out, up] : {std::pair{2.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {2.0, 1.0}})
      bar.vertices.push_back({out * std::cos(angle), out * std::sin(angle), up + 0.01 * i});
  }
  for (int i = 0; i < steps; ++i) {
    for (int k = 0; k < 4; ++k) {
      const int p = 4 * i + k;
      const int q = 4 * i + (k + 1) % 4;
      bar.triangles.push_back({p, p + 4, q});
      bar.triangles.push_back({q, p + 4, q + 4});
    }
  }
  const int last = 4 * steps;
  for (const std::array<int, 3>& t : {std::array{0, 1, 2}, {0, 2, 3}}) bar.triangles.push_back(t);
  for (const std::array<int, 3>& t : {std::array{0, 2, 1}, {0, 3, 2}})
    bar.triangles.push_back({last + t[0], last + t[1], last + t[2]});
  ASSERT_TRUE(is_closed(bar));
  const Solid_3 solid = solid_of(bar);
  EXPECT_EQ(solid.treatment, "united");
  EXPECT_TRUE(is_closed(solid.surface));
  ASSERT_TRUE(solid.topology);
  EXPECT_EQ(*solid.topology, (Topology{0, {1, 1, 0}}));
  EXPECT_EQ(inside_of(solid, {{2.5, 0.2, 0.6}, {-2.5, 0, 0.6}, {0, 0, 0.5}, {2.5, 0.2, 0.1}, {2.5, 0.2, 1.35}}),
            (std::vector<std::uint8_t>{1, 1, 0, 1, 1}));
}

TEST(Unions_3, WhatIsWoundAroundBothWaysIsOutside) {
  // A torus whose tube is thicker than its hole: around the middle it winds once in each direction.
  const Solid_3 solid = solid_of(torus_mesh(1, 1.5, 9, 10));
  EXPECT_EQ(solid.treatment, "united");
  EXPECT_TRUE(is_closed(solid.surface));
  EXPECT_EQ(inside_of(solid, {{0, 0, 0}, {1, 0, 0}, {0, 0, 1.4}}), (std::vector<std::uint8_t>{0, 1, 0}));
}

TEST(Unions_3, WhatCrossesItselfTooOftenIsWrapped) {
  EXPECT_EQ(solid_of(torus_mesh(1, 1.5, 60, 30)).treatment, "wrapped");
}

TEST(Unions_3, BoxesThatShareAWall) {
  const Solid_3 solid = solid_of(joined({box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 0, 0}, {2, 1, 1})}));
  EXPECT_DOUBLE_EQ(volume(solid.surface), 2);
  EXPECT_EQ(solid.components, 1);
  ASSERT_TRUE(solid.topology);
  EXPECT_EQ(*solid.topology, (Topology{1, {1, 0, 0}}));
  EXPECT_EQ(solid.surface.triangles.size(), 20u);
}

TEST(Unions_3, BoxesThatTouchAlongAnEdge) {
  const Solid_3 solid = solid_of(joined({box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 0}, {2, 2, 1})}));
  EXPECT_DOUBLE_EQ(volume(solid.surface), 2);
  EXPECT_FALSE(solid.topology);
  EXPECT_EQ(inside_of(solid, {{0.5, 0.5, 0.5}, {1.5, 1.5, 0.5}, {1, 1, 0.5}, {0.5, 1.5, 0.5}}),
            (std::vector<std::uint8_t>{1, 1, 1, 0}));
}

TEST(Unions_3, BoxesThatTouchInACorner) {
  const Solid_3 solid = solid_of(joined({box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 1}, {2, 2, 2})}));
  EXPECT_EQ(solid.treatment, "none");
  EXPECT_DOUBLE_EQ(volume(solid.surface), 2);
  ASSERT_TRUE(solid.topology);
  EXPECT_EQ(*solid.topology, (Topology{2, {2, 0, 0}}));
}

TEST(Unions_3, SameForEveryNumberOfThreads) {
  const Triangle_mesh_3 mesh = joined({torus_mesh(3, 1, 60, 40), sphere_mesh({3, 0, 0}, 1.5, 30)});
  EXPECT_EQ(solid_of(mesh, Repair::automatic, 1).surface, solid_of(mesh, Repair::automatic, 4).surface);
}

}  // namespace
}  // namespace mesecina::test
