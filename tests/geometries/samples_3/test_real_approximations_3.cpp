// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <string>

#include "tests/geometries/samples_3/approximations_3.h"
#include "tests/geometries/shapes.h"
#include "tests/geometries/solid_3/meshes_3.h"

namespace mesecina::test {
namespace {

/// `error` in units of the sampling distance, a hundredth of the diagonal; 0 for not measured.
void expect_good_approximation(const std::string& file, double error) {
  const Solid_3 solid = solid_of(real_mesh(file), Repair::automatic, 2);
  ASSERT_TRUE(solid.topology);
  Box box;
  for (const Point_3& p : solid.surface.vertices) box.add(p);
  const double distance = 0.01 * box.diagonal();
  const Ball_approximation_3 result = approximation_of(solid, distance, 2);
  EXPECT_EQ(topology(*result.dual).betti, solid.topology->betti);
  EXPECT_EQ(topology_of_axis(result).betti, solid.topology->betti);
  EXPECT_FALSE(result.is_exhausted);
  if (error > 0) {
    EXPECT_LE(error_of(solid, result, distance), error);
  }
}

TEST(Real_approximations_3, Kitten) {
  MESECINA_NEED_DATA();
  expect_good_approximation("kitten.obj", 0.4);
}

TEST(Real_approximations_3, Elephant) {
  MESECINA_NEED_DATA();
  expect_good_approximation("elephant.off", 0.4);
}

TEST(Real_approximations_3, Fandisk) {
  MESECINA_NEED_DATA();
  expect_good_approximation("fandisk.off", 0.4);
}

TEST(Real_approximations_3, Dolphin) {
  MESECINA_NEED_DATA();
  expect_good_approximation("dolphin.off", 0.4);
}

TEST(Real_approximations_3, Armadillo) {
  MESECINA_NEED_DATA();
  expect_good_approximation("armadillo.obj", 0.4);
}

TEST(Real_approximations_3, ScannedNefertiti) {
  MESECINA_NEED_DATA();
  expect_good_approximation("nefertiti_scan.obj", 0);
}

TEST(Real_approximations_3, Triceratops) {
  MESECINA_NEED_DATA();
  expect_good_approximation("triceratops.off", 0);
}

}  // namespace
}  // namespace mesecina::test
