// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/power_crust_3/crust_checks_3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace mesecina::test {

namespace {

/// The simplices of the regular triangulation between inner poles, from the definition.
struct Inner_simplices {
  std::set<int> vertices;
  std::set<std::array<int, 2>> edges;
  std::set<std::array<int, 3>> triangles;
  std::size_t cells = 0;
};

Inner_simplices inner_simplices(const Polar_balls_3& polar) {
  Inner_simplices result;
  for (auto corners : polar.regular->cells) {
    std::ranges::sort(corners);
    std::vector<int> inner;
    for (const int corner : corners)
      if (corner >= 0 && polar.is_inner[corner] != 0) inner.push_back(corner);
    result.vertices.insert(inner.begin(), inner.end());
    for (std::size_t i = 0; i < inner.size(); ++i) {
      for (std::size_t j = i + 1; j < inner.size(); ++j) {
        result.edges.insert({inner[i], inner[j]});
        for (std::size_t k = j + 1; k < inner.size(); ++k) result.triangles.insert({inner[i], inner[j], inner[k]});
      }
    }
    if (inner.size() == 4) ++result.cells;
  }
  return result;
}

double power(const Ball_3& ball, const Point_3& p) {
  return squared_distance(ball.center, p) - ball.radius * ball.radius;
}

void expect_power_vertices(const Crust_3& crust) {
  const std::vector<Ball_3>& balls = crust.polar.poles->balls;
  Box box;
  for (std::size_t s = 0; s < crust.polar.poles->sample_count; ++s) box.add(crust.polar.poles->points[s]);
  // As far as the position of a vertex may be wrong.
  const double error = 1e-8 * box.diagonal();
  const auto tolerance = [&](int ball) { return error * (box.diagonal() + balls[ball].radius); };
  for (std::size_t f = 0; f < crust.surface.face_count(); ++f) {
    const auto [inner, outer] = crust.surface.poles[f];
    EXPECT_NE(crust.polar.is_inner[inner], 0);
    EXPECT_EQ(crust.polar.is_inner[outer], 0);
    for (const int vertex : crust.surface.face(f)) {
      const Point_3& p = crust.surface.vertices[vertex];
      EXPECT_NEAR(power(balls[inner], p), power(balls[outer], p), tolerance(outer));
      for (int b = 0; b < static_cast<int>(balls.size()); ++b)
        EXPECT_GE(power(balls[b], p), power(balls[inner], p) - tolerance(b));
    }
  }
}

}  // namespace

Crust_3 crust_of(const Cloud& cloud, int threads) {
  Progress progress({}, {}, threads);
  const auto poles = std::make_shared<const Poles_3>(find_poles(cloud, progress));
  const auto regular = std::make_shared<const Regular_3>(regular_triangulation(poles->balls, progress));
  Crust_3 crust{label_poles(poles, regular, progress), {}, {}};
  crust.surface = power_crust(crust.polar, progress);
  crust.shape = power_shape(crust.polar, progress);
  return crust;
}

Primitive_set primitives_of(const Power_crust_3& surface) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = surface.vertices;
  set.polygon_offsets = surface.face_offsets;
  set.polygon_vertices = surface.face_vertices;
  set.is_complex = true;
  return set;
}

Topology topology_of_inner_balls(const Polar_balls_3& polar) {
  Progress progress;
  const auto regular =
      std::make_shared<const Regular_3>(regular_triangulation(inner_polar_balls(polar, 1e-4), progress));
  return topology(dual_complex(regular, progress));
}

double volume(const Power_crust_3& surface) {
  double sum = 0;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto corners = surface.face(f);
    const auto at = [&](std::size_t i) { return surface.vertices[corners[i]]; };
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) sum += dot(at(0), cross(at(i), at(i + 1))) / 6;
  }
  return sum;
}

void expect_closed(const Power_crust_3& surface) {
  std::map<std::array<int, 2>, int> forward;
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const auto corners = surface.face(f);
    EXPECT_GE(corners.size(), 3u);
    EXPECT_EQ(std::set<int>(corners.begin(), corners.end()).size(), corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) ++forward[{corners[i], corners[(i + 1) % corners.size()]}];
  }
  for (const auto& [edge, count] : forward) {
    EXPECT_EQ(count, 1) << edge[0] << ' ' << edge[1];
    EXPECT_TRUE(forward.contains({edge[1], edge[0]})) << edge[0] << ' ' << edge[1];
  }
}

void expect_sound(const Crust_3& crust) {
  expect_closed(crust.surface);
  expect_power_vertices(crust);
  const Inner_simplices expected = inner_simplices(crust.polar);
  std::set<int> vertices;
  for (int v = 0; v < static_cast<int>(crust.shape.vertices.size()); ++v)
    if (crust.shape.vertices[v] != Simplex_kind_3::outside) vertices.insert(v);
  EXPECT_EQ(vertices, expected.vertices);
  std::set<std::array<int, 2>> edges;
  for (const Dual_3::Edge& edge : crust.shape.edges) EXPECT_TRUE(edges.insert(edge.balls).second);
  EXPECT_EQ(edges, expected.edges);
  std::set<std::array<int, 3>> triangles;
  for (const Dual_3::Triangle& triangle : crust.shape.triangles) {
    auto corners = triangle.balls;
    std::ranges::sort(corners);
    EXPECT_TRUE(triangles.insert(corners).second);
  }
  EXPECT_EQ(triangles, expected.triangles);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(crust.shape.has_cell, 1)), expected.cells);
  if (crust.surface.face_count() == 0) return;
  // The boundary of a solid has twice the Euler characteristic, and a component more for each cavity.
  const auto of_surface = topology(primitives_of(crust.surface));
  ASSERT_TRUE(of_surface);
  const Topology of_shape = topology(crust.shape);
  EXPECT_EQ(of_surface->euler, 2 * of_shape.euler);
  EXPECT_EQ(of_surface->betti[0], of_shape.betti[0] + of_shape.betti[2]);
  EXPECT_EQ(of_surface->betti[1], 2 * of_shape.betti[1]);
}

}  // namespace mesecina::test
