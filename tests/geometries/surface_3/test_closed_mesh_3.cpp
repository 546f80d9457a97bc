// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/closed_mesh_3.h"

#include "tests/geometries/surface_3/surface_checks_3.h"

namespace mesecina::test {
namespace {

const auto stay = [](int, const Point_3& p) { return p; };

TEST(Closed_mesh_3, ATriangleAndItsBackBecomeASurface) {
  Triangle_mesh_3 mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
  std::vector<int> pieces{0, 1};
  split_double_edges(mesh, pieces, stay);
  EXPECT_TRUE(is_closed_manifold(mesh));
  EXPECT_EQ(topology(mesh).betti, (std::array<std::int64_t, 3>{1, 0, 1}));
  EXPECT_EQ(pieces.size(), mesh.triangles.size());
}

TEST(Closed_mesh_3, ADiagonalOnBothSidesIsSplit) {
  // Two squares with the same corners and the same diagonal.
  Triangle_mesh_3 mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}}};
  std::vector<int> pieces{0, 0, 1, 1};
  split_double_edges(mesh, pieces, stay);
  EXPECT_TRUE(is_closed_manifold(mesh));
  EXPECT_EQ(topology(mesh).betti, (std::array<std::int64_t, 3>{1, 0, 1}));
}

Triangle_mesh_3 octahedron() {
  return {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}}};
}

TEST(Closed_mesh_3, OnlyShortEdgesCollapse) {
  Triangle_mesh_3 mesh = octahedron();
  // The triangles at vertex 4 run around two points at nearly the same place.
  mesh.vertices.push_back({0, 1e-9, 1});
  mesh.triangles = {{0, 1, 6}, {1, 2, 6}, {2, 3, 4}, {3, 0, 4}, {0, 6, 4},
                    {6, 2, 4}, {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
  ASSERT_TRUE(is_closed_manifold(mesh));
  std::vector<int> pieces(mesh.triangles.size());
  for (std::size_t t = 0; t < pieces.size(); ++t) pieces[t] = static_cast<int>(t);
  Progress progress;
  auto untouched = mesh;
  auto same = pieces;
  collapse_short_edges(untouched, same, 1e-12, progress);
  EXPECT_EQ(untouched, mesh);
  collapse_short_edges(mesh, pieces, 1e-6, progress);
  EXPECT_TRUE(is_closed_manifold(mesh));
  EXPECT_EQ(mesh.vertices.size(), 6u);
  EXPECT_EQ(mesh.triangles.size(), 8u);
  EXPECT_EQ(pieces, (std::vector<int>{0, 1, 2, 3, 6, 7, 8, 9}));
}

TEST(Closed_mesh_3, NoSurfaceVanishes) {
  Triangle_mesh_3 mesh = octahedron();
  std::vector<int> pieces(mesh.triangles.size(), 0);
  Progress progress;
  collapse_short_edges(mesh, pieces, 100, progress);
  EXPECT_TRUE(is_closed_manifold(mesh));
  EXPECT_EQ(topology(mesh).betti, (std::array<std::int64_t, 3>{1, 0, 1}));
  EXPECT_GE(mesh.vertices.size(), 4u);
}

}  // namespace
}  // namespace mesecina::test
