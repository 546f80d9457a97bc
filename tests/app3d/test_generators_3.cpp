// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app3d/generators_3.h"

namespace mesecina {
namespace {

const Generator_3& find(const std::string& id) { return *std::ranges::find(generators_3(), id, &Generator_3::id); }

Generator_order_3 order_for(const Generator_3& generator) {
  Generator_order_3 order;
  order.count = generator.usual_count;
  order.center = {10, -20, 30};
  order.size = 4;
  order.least_radius = 0.5;
  order.greatest_radius = 1.5;
  return order;
}

TEST(Generators_3, MakeWhatTheySayWhereTheyAreTold) {
  for (const Generator_3& generator : generators_3()) {
    const Generator_order_3 order = order_for(generator);
    const Inputs made = generator.make(order);
    const char* expected = generator.product == Product_3::mesh    ? "mesh"
                           : generator.product == Product_3::balls ? "balls"
                                                                   : "cloud";
    ASSERT_EQ(made.ids(), std::vector<std::string>{expected}) << generator.id;
    std::vector<Point_3> places;
    if (const auto cloud = made.get(cloud_input)) places = *cloud;
    if (const auto mesh = made.get(mesh_input)) places = mesh->vertices;
    if (const auto balls = made.get(balls_input)) {
      for (const Ball_3& ball : *balls) places.push_back(ball.center);
    }
    if (generator.product != Product_3::mesh) {
      EXPECT_EQ(places.size(), order.count) << generator.id;
    }
    Box box;
    for (const Point_3& place : places) box.add(place - order.center);
    const double reach = std::max({-box.lower.x, -box.lower.y, -box.lower.z, box.upper.x, box.upper.y, box.upper.z});
    EXPECT_LE(reach, 1.02 * order.size) << generator.id;
    EXPECT_GT(box.diagonal(), order.size) << generator.id;
  }
}

TEST(Generators_3, SeedsChooseAndRepeat) {
  for (const Generator_3& generator : generators_3()) {
    Generator_order_3 order = order_for(generator);
    const Box first = bounding_box(generator.make(order));
    EXPECT_EQ(bounding_box(generator.make(order)).lower, first.lower) << generator.id;
    ++order.seed;
    EXPECT_EQ(bounding_box(generator.make(order)).lower != first.lower, generator.has_seed) << generator.id;
  }
}

TEST(Generators_3, MeshesAreClosedAndSeenFromOutside) {
  const std::map<std::string, long> euler{{"sphere", 2}, {"cube", 2}, {"torus", 0}, {"twisted-ring", 0}};
  for (const Generator_3& generator : generators_3()) {
    if (generator.product != Product_3::mesh) continue;
    for (const std::size_t count : {std::size_t{3}, std::size_t{12}, generator.usual_count}) {
      Generator_order_3 order;
      order.count = count;
      const auto mesh = generator.make(order).get(mesh_input);
      std::map<std::pair<int, int>, int> edges;
      double volume = 0;
      for (const auto& [a, b, c] : mesh->triangles) {
        for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) ++edges[{from, to}];
        const auto corner = [&](int i) { return mesh->vertices[static_cast<std::size_t>(i)]; };
        volume += dot(corner(a), cross(corner(b), corner(c))) / 6;
      }
      for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1) << generator.id << " " << count;
        EXPECT_TRUE(edges.contains({edge.second, edge.first})) << generator.id << " " << count;
      }
      EXPECT_GT(volume, 0) << generator.id << " " << count;
      EXPECT_EQ(static_cast<long>(mesh->vertices.size()) - static_cast<long>(edges.size()) / 2 +
                    static_cast<long>(mesh->triangles.size()),
                euler.at(generator.id))
          << generator.id << " " << count;
    }
  }
}

TEST(Generators_3, PointsLieOnTheirSurfaces) {
  const Generator_order_3 order = order_for(find("sphere-points"));
  const auto on_sphere = find("sphere-points").make(order).get(cloud_input);
  for (const Point_3& p : *on_sphere) EXPECT_NEAR(distance(p, order.center), order.size, 1e-12);
  const auto on_torus = find("torus-points").make(order).get(cloud_input);
  for (const Point_3& p : *on_torus) {
    const Point_3 off = (1 / order.size) * (p - order.center);
    EXPECT_NEAR(std::hypot(std::hypot(off.x, off.y) - 0.7, off.z), 0.3, 1e-12);
  }
}

}  // namespace
}  // namespace mesecina
