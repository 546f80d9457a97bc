// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "geometries/solid_3/clean_mesh_3.h"
#include "geometries/solid_3/self_crossings_3.h"
#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

std::vector<std::array<int, 2>> found_in(const Triangle_mesh_3& mesh, std::size_t limit = 1000000, int threads = 1) {
  Progress progress({}, {}, threads);
  return find_self_crossings(mesh, Surface_locator_3(mesh, progress), limit, progress);
}

/// On a small lattice most pairs that meet do so in a degenerate way.
Triangle_mesh_3 soup(int vertices, int triangles, int lattice, std::uint64_t seed) {
  Random random(seed);
  Triangle_mesh_3 mesh;
  for (int i = 0; i < vertices; ++i) {
    if (lattice > 0) {
      mesh.vertices.push_back({static_cast<double>(random.index(lattice)), static_cast<double>(random.index(lattice)),
                               static_cast<double>(random.index(lattice))});
    } else {
      mesh.vertices.push_back({random.unit(), random.unit(), random.unit()});
    }
  }
  for (int i = 0; i < triangles; ++i)
    mesh.triangles.push_back({random.index(vertices), random.index(vertices), random.index(vertices)});
  return clean_mesh(mesh).mesh;
}

TEST(Self_crossings_3, SoupsAsConstructedExactly) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Triangle_mesh_3 general = soup(40, 60, 0, seed);
    EXPECT_EQ(found_in(general), crossing_pairs(general)) << seed;
    const Triangle_mesh_3 degenerate = soup(40, 60, 4, seed);
    EXPECT_EQ(found_in(degenerate), crossing_pairs(degenerate)) << seed;
    EXPECT_FALSE(found_in(degenerate).empty());
  }
}

TEST(Self_crossings_3, NoneInCleanSurfaces) {
  EXPECT_TRUE(found_in(torus_mesh(3, 1)).empty());
  EXPECT_TRUE(found_in(box_mesh({0, 0, 0}, {1, 1, 1})).empty());
  EXPECT_TRUE(found_in(sheet_mesh(10, 10)).empty());
}

TEST(Self_crossings_3, StopsAtTheLimitAndIsTheSameForEveryNumberOfThreads) {
  const Triangle_mesh_3 mesh = soup(300, 600, 0, 9);
  const auto all = found_in(mesh);
  ASSERT_GT(all.size(), 1000u);
  EXPECT_EQ(all, found_in(mesh, 1000000, 4));
  EXPECT_GE(found_in(mesh, 100).size(), 100u);
  EXPECT_LT(found_in(mesh, 100).size(), 1000u);
}

}  // namespace
}  // namespace mesecina::test
