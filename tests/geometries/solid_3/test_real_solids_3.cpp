// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

TEST(Real_solids_3, ClosedShapesStayAsTheyAre) {
  MESECINA_NEED_DATA();
  struct Shape {
    std::string file;
    int genus;
  };
  const std::vector<Shape> shapes{{"anchor_dense.off", 4}, {"armadillo.obj", 0},      {"cheese_genus133.off", 133},
                                  {"dolphin.off", 0},      {"elephant.off", 3},       {"fandisk.off", 0},
                                  {"fertility.off", 4},    {"goathead.obj", 0},       {"hand.obj", 0},
                                  {"kitten.obj", 1},       {"nefertiti_scan.obj", 0}, {"sword.obj", 0},
                                  {"tray_bottom.stl", 23}, {"triceratops.off", 0}};
  for (const auto& [file, genus] : shapes) {
    const Solid_3 solid = solid_of(real_mesh(file), Repair::automatic, 2);
    EXPECT_EQ(solid.treatment, "none") << file;
    ASSERT_TRUE(solid.topology) << file;
    EXPECT_EQ(*solid.topology, (Topology{1 - genus, {1, genus, 0}})) << file;
    EXPECT_GT(volume(solid.surface), 0) << file;
  }
}

TEST(Real_solids_3, InsideAsDefined) {
  MESECINA_NEED_DATA();
  for (const std::string file : {"elephant.off", "triceratops.off", "tray_bottom.stl"}) {
    const Triangle_mesh_3 mesh = real_mesh(file);
    const Solid_3 solid = solid_of(mesh);
    std::vector<Point_3> points = points_around(mesh, 40, 21);
    const std::vector<Point_3> difficult = difficult_points(mesh, 60, 22);
    points.insert(points.end(), difficult.begin(), difficult.end());
    const std::vector<std::uint8_t> inside = inside_of(solid, points);
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(inside[i] != 0, place_of(solid.surface, points[i]) != Place::outside) << file << ' ' << i;
  }
}

TEST(Real_solids_3, BadShapesBecomeSolids) {
  MESECINA_NEED_DATA();
  struct Shape {
    std::string file;
    std::string treatment;
    Topology topology;
  };
  const std::vector<Shape> shapes{{"bad_conrod_misoriented.stl", "trimmed, oriented, united", {1, {1, 0, 0}}},
                                  {"bad_open_scan_demosthenes.obj", "filled", {1, {1, 0, 0}}},
                                  {"bad_plane_holes.obj", "filled", {1, {1, 0, 0}}},
                                  {"bad_two_spheres.obj", "united", {1, {1, 0, 0}}},
                                  {"featuretype_tjunctions.stl", "stitched", {-8, {1, 9, 0}}}};
  for (const auto& [file, treatment, topology] : shapes) {
    const Solid_3 solid = solid_of(real_mesh(file));
    EXPECT_EQ(solid.treatment, treatment) << file;
    EXPECT_TRUE(is_closed(solid.surface)) << file;
    ASSERT_TRUE(solid.topology) << file;
    EXPECT_EQ(*solid.topology, topology) << file;
  }
  for (const std::string file : {"bad_self_intersect.obj", "noisy_fertility_0.3pc.off"}) {
    const Triangle_mesh_3 mesh = real_mesh(file);
    const Solid_3 solid = solid_of(mesh);
    EXPECT_EQ(solid.treatment, "united") << file;
    EXPECT_TRUE(is_closed(solid.surface)) << file;
    EXPECT_NEAR(volume(solid.surface), volume(mesh), 0.05 * volume(mesh)) << file;
  }
  const Solid_3 umbrellas = solid_of(real_mesh("bad_5_umbrellas.off"));
  EXPECT_EQ(umbrellas.treatment, "wrapped");
  EXPECT_TRUE(is_closed(umbrellas.surface));
}

}  // namespace
}  // namespace mesecina::test
