// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Repair_3, CleanMeshesStayAsTheyAre) {
  for (const Triangle_mesh_3& mesh : {sphere_mesh({1, 2, 3}, 2), torus_mesh(3, 1), box_mesh({0, 0, 0}, {1, 2, 3})}) {
    for (const Repair repair : {Repair::automatic, Repair::off}) {
      const Solid_3 solid = solid_of(mesh, repair);
      EXPECT_EQ(solid.surface, mesh);
      EXPECT_EQ(solid.treatment, "none");
      EXPECT_THAT(solid.remarks, IsEmpty());
      EXPECT_EQ(solid.components, 1);
    }
  }
}

TEST(Repair_3, Topology) {
  EXPECT_EQ(*solid_of(sphere_mesh({0, 0, 0}, 1)).topology, (Topology{1, {1, 0, 0}}));
  EXPECT_EQ(*solid_of(torus_mesh(3, 1)).topology, (Topology{0, {1, 1, 0}}));
  EXPECT_EQ(*solid_of(joined({sphere_mesh({0, 0, 0}, 2), torus_mesh(1, 0.3)})).topology, (Topology{1, {1, 1, 1}}));
  EXPECT_EQ(*solid_of(joined({sphere_mesh({9, 0, 0}, 1), torus_mesh(3, 1)})).topology, (Topology{1, {2, 1, 0}}));
}

TEST(Repair_3, NestedComponentsAlternateWhateverTheirOrientation) {
  for (int turns = 0; turns < 8; ++turns) {
    std::vector<Triangle_mesh_3> spheres;
    for (int i = 0; i < 3; ++i) {
      const Triangle_mesh_3 sphere = sphere_mesh({0.1, 0.2, 0.3}, 3 - i);
      spheres.push_back((turns >> i & 1) != 0 ? turned(sphere) : sphere);
    }
    const Solid_3 solid = solid_of(shuffled(joined(spheres), 3));
    EXPECT_EQ(inside_of(solid, {{0.1, 0.2, 2.8}, {0.1, 0.2, 1.8}, {0.1, 0.2, 0.8}}),
              (std::vector<std::uint8_t>{1, 0, 1}));
    EXPECT_EQ(solid.components, 3);
    EXPECT_EQ(*solid.topology, (Topology{3, {2, 0, 1}}));
    EXPECT_NEAR(volume(solid.surface), volume(spheres[0]) * ((turns & 1) != 0 ? -1 : 1) * (27 - 8 + 1) / 27, 1e-9);
    EXPECT_EQ(solid.treatment, turns == 2 ? "none" : "oriented");
  }
}

TEST(Repair_3, FlippedTrianglesAreTurned) {
  const Triangle_mesh_3 mesh = torus_mesh(3, 1);
  Triangle_mesh_3 flipped = mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 7)
    std::swap(flipped.triangles[t][0], flipped.triangles[t][2]);
  const Solid_3 solid = solid_of(flipped);
  EXPECT_EQ(solid.treatment, "oriented");
  EXPECT_TRUE(is_closed(solid.surface));
  EXPECT_DOUBLE_EQ(volume(solid.surface), volume(mesh));
  EXPECT_THAT(solid.remarks, ElementsAre(HasSubstr("147 triangles turned around")));
}

TEST(Repair_3, VerticesAtTheSamePlaceAreJoined) {
  const Solid_3 solid = solid_of(unwelded(torus_mesh(3, 1)));
  EXPECT_EQ(solid.surface.vertices.size(), 512u);
  EXPECT_EQ(*solid.topology, (Topology{0, {1, 1, 0}}));
  EXPECT_THAT(solid.remarks, ElementsAre(HasSubstr("2560 vertices were joined")));
}

TEST(Repair_3, BothZerosAreOnePlace) {
  Triangle_mesh_3 mesh = unwelded(box_mesh({0, 0, 0}, {1, 1, 1}));
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 2)
    if (mesh.vertices[i].x == 0) mesh.vertices[i].x = -0.0;
  EXPECT_EQ(solid_of(mesh).surface.vertices.size(), 8u);
}

TEST(Repair_3, FlatAndRepeatedTrianglesAreLeftOut) {
  const Triangle_mesh_3 clean = torus_mesh(3, 1);
  Triangle_mesh_3 mesh = clean;
  mesh.triangles.push_back({0, 1, 1});
  mesh.triangles.push_back({4, 4, 4});
  mesh.triangles.push_back(mesh.triangles[10]);
  mesh.triangles.push_back({mesh.triangles[20][1], mesh.triangles[20][0], mesh.triangles[20][2]});
  const Solid_3 solid = solid_of(mesh);
  EXPECT_EQ(solid.surface, clean);
  EXPECT_THAT(solid.remarks,
              ElementsAre(HasSubstr("2 triangles without area"), HasSubstr("2 triangles with the corners")));
}

TEST(Repair_3, AMeshThatIsThereTwice) {
  const Triangle_mesh_3 clean = torus_mesh(3, 1);
  const Solid_3 solid = solid_of(joined({clean, clean}));
  EXPECT_EQ(solid.surface, clean);
}

TEST(Repair_3, TrianglesThatAreNotFiniteLeaveAHoleThatIsFilled) {
  Triangle_mesh_3 mesh = torus_mesh(3, 1);
  const double volume_before = volume(mesh);
  mesh.vertices.push_back({std::numeric_limits<double>::quiet_NaN(), 0, 0});
  mesh.triangles[5][1] = static_cast<int>(mesh.vertices.size()) - 1;
  const Solid_3 solid = solid_of(mesh);
  EXPECT_THAT(solid.remarks.front(), HasSubstr("1 triangle was left out"));
  EXPECT_DOUBLE_EQ(volume(solid.surface), volume_before);
}

TEST(Repair_3, AMissingTriangleIsFilled) {
  Triangle_mesh_3 mesh = torus_mesh(3, 1);
  const Triangle_mesh_3 whole = mesh;
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  const Solid_3 solid = solid_of(mesh);
  EXPECT_EQ(solid.treatment, "filled");
  EXPECT_TRUE(is_closed(solid.surface));
  EXPECT_DOUBLE_EQ(volume(solid.surface), volume(whole));
  EXPECT_THAT(solid.remarks, ElementsAre(HasSubstr("1 hole filled by 1 triangle ")));
  EXPECT_EQ(*solid.topology, (Topology{0, {1, 1, 0}}));
}

TEST(Repair_3, SeveralHolesAmongFlippedTriangles) {
  Triangle_mesh_3 mesh = sphere_mesh({0, 0, 0}, 1, 24);
  const double volume_before = volume(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 5) std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
  mesh.triangles.erase(mesh.triangles.begin() + 300, mesh.triangles.begin() + 308);
  mesh.triangles.erase(mesh.triangles.begin() + 30, mesh.triangles.begin() + 32);
  const Solid_3 solid = solid_of(mesh);
  EXPECT_EQ(solid.treatment, "oriented, filled");
  EXPECT_TRUE(is_closed(solid.surface));
  EXPECT_NEAR(volume(solid.surface), volume_before, 0.01 * volume_before);
}

/// Of a box: one side is split at points where the sides next to it are not.
Triangle_mesh_3 box_with_t_junctions(double noise) {
  Triangle_mesh_3 mesh = box_mesh({0, 0, 0}, {4, 4, 4});
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  Triangle_mesh_3 top = sheet_mesh(4, 4);
  Random random(5);
  for (Point_3& p : top.vertices) p = p + Point_3{0, 0, 4 + random.uniform(-noise, noise)};
  return joined({mesh, top});
}

TEST(Repair_3, TJunctionsAreStitched) {
  for (const double noise : {0.0, 1e-7}) {
    const Solid_3 solid = solid_of(box_with_t_junctions(noise));
    EXPECT_EQ(solid.treatment, "stitched");
    EXPECT_TRUE(is_closed(solid.surface));
    EXPECT_NEAR(volume(solid.surface), 64, 1e-5);
    EXPECT_EQ(*solid.topology, (Topology{1, {1, 0, 0}}));
    EXPECT_EQ(inside_of(solid, {{1.5, 1.5, 3.99}, {1.5, 1.5, 4.01}}), (std::vector<std::uint8_t>{1, 0}));
  }
}

TEST(Repair_3, FinsAndInnerWallsAreTrimmed) {
  Triangle_mesh_3 mesh = torus_mesh(3, 1);
  const Triangle_mesh_3 clean = mesh;
  mesh.vertices.push_back(mesh.vertices[0] + Point_3{0.1, 0, 0.1});
  mesh.triangles.push_back({0, 1, static_cast<int>(mesh.vertices.size()) - 1});
  const Solid_3 solid = solid_of(mesh);
  EXPECT_EQ(solid.treatment, "trimmed");
  EXPECT_EQ(solid.surface, clean);

  // A membrane across the middle of a long box.
  Triangle_mesh_3 halves = joined({box_mesh({0, 0, 0}, {200, 1, 1}), box_mesh({200, 0, 0}, {400, 1, 1})});
  std::erase_if(halves.triangles, [&](const std::array<int, 3>& t) {
    return t[0] >= 8 && std::ranges::all_of(t, [&](int v) { return halves.vertices[v].x == 200; });
  });
  const Solid_3 both = solid_of(halves);
  EXPECT_EQ(both.treatment, "trimmed");
  EXPECT_DOUBLE_EQ(volume(both.surface), 400);
}

TEST(Repair_3, WhatTouchesAlongAnEdgeIsNoFin) {
  Triangle_mesh_3 mesh = joined({box_mesh({0, 0, 0}, {40, 40, 40}), box_mesh({40, 40, 0}, {40.1, 40.1, 40})});
  mesh.vertices.push_back({20, -0.1, -0.1});
  mesh.triangles.push_back({0, 1, static_cast<int>(mesh.vertices.size()) - 1});
  const Solid_3 solid = solid_of(mesh);
  EXPECT_NEAR(volume(solid.surface), 64000.4, 1e-9);
  EXPECT_THAT(solid.remarks, Contains(HasSubstr("1 triangle left out")));
}

/// The wrap holds all triangles and is near to them.
void expect_wrapped(const Triangle_mesh_3& mesh) {
  const Solid_3 solid = solid_of(mesh);
  EXPECT_EQ(solid.treatment, "wrapped");
  EXPECT_TRUE(is_closed(solid.surface));
  EXPECT_GT(volume(solid.surface), 0);
  EXPECT_THAT(solid.remarks.back(), HasSubstr("Wrapped at a distance of about"));
  EXPECT_TRUE(solid.topology);
  std::vector<Point_3> corners;
  for (const std::array<int, 3>& t : mesh.triangles)
    for (const int v : t) corners.push_back(mesh.vertices[v]);
  Box box;
  for (const Point_3& p : corners) box.add(p);
  for (const std::uint8_t inside : inside_of(solid, corners)) ASSERT_EQ(inside, 1);
  for (std::size_t v = 0; v < solid.surface.vertices.size(); v += 50)
    ASSERT_LT(distance_to(mesh, solid.surface.vertices[v]), 0.0011 * box.diagonal());
}

TEST(Repair_3, ASheetIsWrapped) { expect_wrapped(sheet_mesh(8, 1)); }

TEST(Repair_3, ATriangleIsWrapped) { expect_wrapped({{{0, 0, 0}, {9, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}); }

TEST(Repair_3, ASoupIsWrapped) {
  Triangle_mesh_3 soup;
  Random random(8);
  for (int i = 0; i < 12; ++i) {
    const Point_3 p{random.unit(), random.unit(), random.unit()};
    const int first = static_cast<int>(soup.vertices.size());
    for (int k = 0; k < 3; ++k) soup.vertices.push_back(p + 0.4 * Point_3{random.unit(), random.unit(), random.unit()});
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  expect_wrapped(soup);
}

TEST(Repair_3, ABowlIsWrappedBecauseItsHoleIsTooLarge) {
  Triangle_mesh_3 bowl = sphere_mesh({0, 0, 0}, 1);
  std::erase_if(bowl.triangles, [&](const std::array<int, 3>& t) { return bowl.vertices[t[0]].z > -0.4; });
  expect_wrapped(bowl);
}

TEST(Repair_3, WrapOnRequest) {
  const Triangle_mesh_3 mesh = torus_mesh(4, 0.5);
  const Solid_3 solid = solid_of(mesh, Repair::wrap);
  EXPECT_EQ(solid.treatment, "wrapped");
  EXPECT_EQ(*solid.topology, (Topology{0, {1, 1, 0}}));
  EXPECT_GT(volume(solid.surface), volume(mesh));
  EXPECT_LT(volume(solid.surface), 1.1 * volume(mesh));
}

TEST(Repair_3, WrapsAreTheSameForEveryNumberOfThreads) {
  const Triangle_mesh_3 mesh{{{0, 0, 0}, {9, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}}};
  EXPECT_EQ(solid_of(mesh, Repair::wrap, 1).surface, solid_of(mesh, Repair::wrap, 3).surface);
}

TEST(Repair_3, AClosedSurfaceWithoutAnInsideIsWrapped) {
  // Two sheets on each other, joined along their boundary, with different diagonals.
  Triangle_mesh_3 mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  EXPECT_EQ(solid_of(mesh).treatment, "wrapped");
}

TEST(Repair_3, OffSaysWhatIsWrong) {
  Triangle_mesh_3 open = torus_mesh(3, 1);
  open.triangles.pop_back();
  EXPECT_THAT(reason_of(open, Repair::off), AllOf(HasSubstr("3 edges have"), HasSubstr("repair automatic")));
  const Triangle_mesh_3 crossing = joined({box_mesh({0, 0, 0}, {2, 2, 2}), box_mesh({1, 1, 1}, {3, 3, 3})});
  EXPECT_THAT(reason_of(crossing, Repair::off), AllOf(HasSubstr("pairs of triangles"), HasSubstr("repair automatic")));
  Triangle_mesh_3 flipped = torus_mesh(3, 1);
  std::swap(flipped.triangles[7][0], flipped.triangles[7][1]);
  EXPECT_THAT(reason_of(flipped, Repair::off), AllOf(HasSubstr("1 triangle"), HasSubstr("repair automatic")));
  EXPECT_EQ(solid_of(turned(torus_mesh(3, 1)), Repair::off).treatment, "oriented");
}

TEST(Repair_3, NothingToMakeASolidOf) {
  EXPECT_THAT(reason_of({}), HasSubstr("0 triangles"));
  EXPECT_THAT(reason_of({{{0, 0, 0}, {1, 1, 1}}, {}}), HasSubstr("0 triangles"));
  const Triangle_mesh_3 flat{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {0, 0, 0}}, {{0, 1, 2}, {0, 3, 1}, {0, 0, 0}}};
  for (const Repair repair : {Repair::automatic, Repair::off, Repair::wrap})
    EXPECT_THAT(reason_of(flat, repair), HasSubstr("Of 3 triangles none has an area"));
}

}  // namespace
}  // namespace mesecina::test
