// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/surface_3/surface_checks_3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mesecina::test {

namespace {

double distance_to_segment(const Point_3& p, const Point_3& a, const Point_3& b) {
  const Point_3 along = b - a;
  const double square = dot(along, along);
  return distance(p, a + (square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0.0) * along);
}

double distance_to_triangle(const Point_3& p, const Point_3& a, const Point_3& b, const Point_3& c) {
  const Point_3 normal = cross(b - a, c - a);
  const double square = dot(normal, normal);
  if (square > 0 && dot(cross(normal, b - a), p - a) >= 0 && dot(cross(normal, c - b), p - b) >= 0 &&
      dot(cross(normal, a - c), p - c) >= 0)
    return std::abs(dot(normal, p - a)) / std::sqrt(square);
  return std::min({distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

}  // namespace

testing::AssertionResult is_closed_manifold(const Triangle_mesh_3& mesh) {
  // Around each vertex, from one neighbour to the next.
  struct Step {
    int center;
    int from;
    int to;
    auto operator<=>(const Step&) const = default;
  };
  std::vector<Step> steps;
  for (const auto& corners : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      if (corners[i] == corners[(i + 1) % 3])
        return testing::AssertionFailure() << "a triangle has vertex " << corners[i] << " twice";
      steps.push_back({corners[i], corners[(i + 1) % 3], corners[(i + 2) % 3]});
    }
  }
  std::ranges::sort(steps);
  std::size_t begin = 0;
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    std::size_t end = begin;
    while (end < steps.size() && steps[end].center == v) ++end;
    if (begin == end) return testing::AssertionFailure() << "vertex " << v << " is not used";
    const std::span<const Step> around(steps.data() + begin, steps.data() + end);
    for (std::size_t i = 1; i < around.size(); ++i)
      if (around[i].from == around[i - 1].from)
        return testing::AssertionFailure() << "edge " << v << " " << around[i].from << " is there twice";
    std::size_t count = 0;
    int at = around.front().from;
    do {
      const auto next = std::ranges::lower_bound(around, at, {}, &Step::from);
      if (next == around.end() || next->from != at)
        return testing::AssertionFailure() << "edge " << v << " " << at << " is open";
      at = next->to;
      ++count;
    } while (at != around.front().from && count <= around.size());
    if (count != around.size()) return testing::AssertionFailure() << "the triangles at vertex " << v << " are no disk";
    begin = end;
  }
  return testing::AssertionSuccess();
}

Topology topology(const Triangle_mesh_3& mesh) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = mesh.vertices;
  set.triangles = mesh.triangles;
  set.is_complex = true;
  return mesecina::topology(set).value();
}

double signed_volume(const Triangle_mesh_3& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  return volume;
}

double distance_to_union(std::span<const Ball_3> balls, const Point_3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [center, radius] : balls) least = std::min(least, distance(center, point) - radius);
  return least;
}

std::vector<Point_3> boundary_points(std::span<const Ball_3> balls, double spacing) {
  std::vector<Point_3> points;
  for (const auto& [center, radius] : balls) {
    const int count = 1 + static_cast<int>(4 * std::numbers::pi * radius * radius / (spacing * spacing));
    for (int i = 0; i < count; ++i) {
      const double z = 1 - (2 * i + 1.0) / count;
      const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
      const double width = std::sqrt(1 - z * z);
      const Point_3 p = center + radius * Point_3{width * std::cos(turn), width * std::sin(turn), z};
      if (distance_to_union(balls, p) > -1e-12 * radius) points.push_back(p);
    }
  }
  return points;
}

double distance_to_mesh(const Triangle_mesh_3& mesh, const Point_3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.triangles)
    least = std::min(least, distance_to_triangle(point, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
  return least;
}

std::vector<Point_3> mesh_points(const Triangle_mesh_3& mesh) {
  std::vector<Point_3> points;
  constexpr int steps = 4;
  for (const auto& [a, b, c] : mesh.triangles)
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j)
        points.push_back((1.0 * i / steps) * mesh.vertices[a] + (1.0 * j / steps) * mesh.vertices[b] +
                         (1.0 * (steps - i - j) / steps) * mesh.vertices[c]);
  return points;
}

}  // namespace mesecina::test
