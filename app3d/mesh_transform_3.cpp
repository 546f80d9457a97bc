// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/mesh_transform_3.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace mesecina {

namespace {

using Rows = std::array<Point_3, 3>;

/// Cosine and sine; of whole quarter turns exactly.
std::pair<double, double> turned_unit(double degrees) {
  constexpr double quarter = 90;
  const double quarters = degrees / quarter;
  if (quarters == std::floor(quarters)) {
    constexpr std::array<std::pair<double, double>, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    const double within = std::fmod(quarters, 4);
    return exact[static_cast<std::size_t>(within < 0 ? within + 4 : within)];
  }
  const double angle = std::fmod(degrees, 4 * quarter) * std::numbers::pi / (2 * quarter);
  return {std::cos(angle), std::sin(angle)};
}

Rows product(const Rows& first, const Rows& second) {
  Rows result;
  for (std::size_t i = 0; i < first.size(); ++i)
    result[i] = first[i].x * second[0] + first[i].y * second[1] + first[i].z * second[2];
  return result;
}

/// About the pivot, without the shift.
Rows linear_part(const Transform_3& transform) {
  const auto along = [&](std::size_t axis) { return transform.mirrored[axis] ? -transform.scale : transform.scale; };
  Rows rows{Point_3{along(0), 0, 0}, {0, along(1), 0}, {0, 0, along(2)}};
  const auto [cx, sx] = turned_unit(transform.degrees[0]);
  const auto [cy, sy] = turned_unit(transform.degrees[1]);
  const auto [cz, sz] = turned_unit(transform.degrees[2]);
  rows = product({Point_3{1, 0, 0}, {0, cx, -sx}, {0, sx, cx}}, rows);
  rows = product({Point_3{cy, 0, sy}, {0, 1, 0}, {-sy, 0, cy}}, rows);
  return product({Point_3{cz, -sz, 0}, {sz, cz, 0}, {0, 0, 1}}, rows);
}

std::function<Point_3(const Point_3&)> map_of(const Transform_3& transform) {
  const Rows rows = linear_part(transform);
  const bool is_shift = rows == Rows{Point_3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return [rows, is_shift, pivot = transform.pivot, shift = transform.shift](const Point_3& p) {
    if (is_shift) return p + shift;
    const Point_3 off = p - pivot;
    return Point_3{dot(rows[0], off), dot(rows[1], off), dot(rows[2], off)} + pivot + shift;
  };
}

Point_3 middle_of(const Inputs& inputs) {
  const Box box = bounding_box(inputs);
  return box.is_empty() ? Point_3{} : midpoint(box.lower, box.upper);
}

}  // namespace

Inputs transformed(const Inputs& inputs, const Transform_3& transform) {
  const auto map = map_of(transform);
  Inputs result = inputs;
  if (const auto mesh = inputs.get(mesh_input)) {
    Triangle_mesh_3 copy = *mesh;
    for (Point_3& vertex : copy.vertices) vertex = map(vertex);
    bool is_turned_over = false;
    for (const bool is_mirrored : transform.mirrored) is_turned_over = is_turned_over != is_mirrored;
    if (is_turned_over) {
      for (auto& triangle : copy.triangles) std::swap(triangle[1], triangle[2]);
    }
    result = result.with(mesh_input, std::move(copy));
  }
  if (const auto balls = inputs.get(balls_input)) {
    std::vector<Ball_3> copy = *balls;
    for (Ball_3& ball : copy) ball = {map(ball.center), transform.scale * ball.radius};
    result = result.with(balls_input, std::move(copy));
  }
  if (const auto cloud = inputs.get(cloud_input)) {
    std::vector<Point_3> copy = *cloud;
    for (Point_3& point : copy) point = map(point);
    result = result.with(cloud_input, std::move(copy));
  }
  return result;
}

Transform_3 centered(const Inputs& inputs, Transform_3 transform) {
  transform.shift = {};
  transform.shift = Point_3{} - middle_of(transformed(inputs, transform));
  return transform;
}

Transform_3 normalized(const Inputs& inputs, Transform_3 transform) {
  transform.scale = 1;
  const double diagonal = bounding_box(transformed(inputs, transform)).diagonal();
  if (diagonal > 0 && std::isfinite(1 / diagonal)) transform.scale = 1 / diagonal;
  return centered(inputs, transform);
}

}  // namespace mesecina
