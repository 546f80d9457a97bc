// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "app3d/example_3.h"
#include "app3d/files_3.h"
#include "app3d/first_look_3.h"
#include "geometries/modules_3.h"

namespace mesecina {
namespace {

TEST(Example_3, IsAClosedRingSeenFromOutside) {
  for (const int segments : {12, 96}) {
    const Triangle_mesh_3 mesh = twisted_ring(segments);
    std::map<std::pair<int, int>, int> edges;
    double volume = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) ++edges[{from, to}];
      volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
    }
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    EXPECT_GT(volume, 0);
    const auto euler = static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges.size()) / 2 +
                       static_cast<long>(mesh.triangles.size());
    EXPECT_EQ(euler, 0);
  }
}

TEST(First_look_3, FollowsTheKindOfDataUntilTheUserHasChosen) {
  const auto registry = make_registry_3();
  const Inputs mesh = Inputs().with(mesh_input, twisted_ring(12));
  const Inputs balls = Inputs().with(balls_input, std::vector<Ball_3>{{{0, 0, 0}, 1}});
  const Inputs points = Inputs().with(cloud_input, std::vector<Point_3>{{0, 0, 0}});
  const auto is_visible = [](const Layer_list& layers, const char* id) {
    return find_entry(layers, id)->style.visible;
  };
  Layer_list layers = first_look_3(*registry, mesh);
  EXPECT_TRUE(is_visible(layers, "mesh") && is_visible(layers, "scale-axis"));
  layers = look_at_3(*registry, balls, layers);
  EXPECT_TRUE(is_visible(layers, "given-balls"));
  EXPECT_FALSE(is_visible(layers, "mesh"));
  layers = look_at_3(*registry, points, layers);
  EXPECT_TRUE(is_visible(layers, "points"));
  find_entry(layers, "points")->style.point_size = 7;
  EXPECT_EQ(look_at_3(*registry, mesh, layers), layers);
}

TEST(Files_3, AppendedHoldsBoth) {
  const Inputs first = Inputs()
                           .with(mesh_input, Triangle_mesh_3{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}})
                           .with(balls_input, std::vector<Ball_3>{{{0, 0, 0}, 1}});
  const Inputs second = Inputs()
                            .with(mesh_input, Triangle_mesh_3{{{5, 0, 0}, {6, 0, 0}, {5, 1, 0}}, {{2, 1, 0}}})
                            .with(cloud_input, std::vector<Point_3>{{9, 9, 9}});
  const Inputs both = appended_3(first, second);
  EXPECT_EQ(both.get(mesh_input)->vertices.size(), 6U);
  EXPECT_EQ(both.get(mesh_input)->triangles[1], (std::array{5, 4, 3}));
  EXPECT_EQ(both.get(balls_input)->size(), 1U);
  EXPECT_EQ(both.get(cloud_input)->size(), 1U);
  EXPECT_EQ(appended_3(first, {}), first);
}

}  // namespace
}  // namespace mesecina
