// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_path_3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace mesecina {

namespace {

using Quaternion = std::array<double, 4>;  ///< x y z w

double product(const Quaternion& a, const Quaternion& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

/// Of the rotation that takes the axes of coordinates to these.
Quaternion quaternion_of(const Camera_3::Axes& axes) {
  // By the largest of its squared components, so that nothing is lost.
  const auto& [r, u, b] = axes;
  const std::array squares{1 + r.x - u.y - b.z, 1 - r.x + u.y - b.z, 1 - r.x - u.y + b.z, 1 + r.x + u.y + b.z};
  switch (std::ranges::max_element(squares) - squares.begin()) {
    case 0:
      return {squares[0], r.y + u.x, b.x + r.z, u.z - b.y};
    case 1:
      return {r.y + u.x, squares[1], u.z + b.y, b.x - r.z};
    case 2:
      return {b.x + r.z, u.z + b.y, squares[2], r.y - u.x};
    default:
      return {u.z - b.y, b.x - r.z, r.y - u.x, squares[3]};
  }
}

Quaternion normalized(Quaternion q) {
  const double norm = std::sqrt(product(q, q));
  for (double& number : q) number /= norm;
  return q;
}

/// The vector (0, 1, 0) or (0, 0, 1) turned.
Point_3 turned_up(const Quaternion& q) {
  const auto& [x, y, z, w] = q;
  return {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)};
}
Point_3 turned_back(const Quaternion& q) {
  const auto& [x, y, z, w] = q;
  return {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)};
}

/// A camera as numbers between which one may go straight: target, logarithms of distance and height, field of view,
/// quaternion.
using Numbers = std::array<double, 10>;
constexpr std::size_t first_of_quaternion = 6;

Quaternion quaternion_in(const Numbers& n) {
  return {n[first_of_quaternion], n[first_of_quaternion + 1], n[first_of_quaternion + 2], n[first_of_quaternion + 3]};
}

Numbers numbers_of(const Camera_3& camera) {
  const Quaternion q = normalized(quaternion_of(camera.axes()));
  constexpr double least = 1e-300;
  return {camera.target.x,
          camera.target.y,
          camera.target.z,
          std::log(std::max(distance(camera.position, camera.target), least)),
          std::log(std::max(camera.height_at_target(), least)),
          camera.field_of_view,
          q[0],
          q[1],
          q[2],
          q[3]};
}

/// A quaternion and its negative are one rotation; the nearer one is taken.
void turn_to(Numbers& numbers, const Numbers& before) {
  if (product(quaternion_in(numbers), quaternion_in(before)) < 0)
    for (std::size_t i = first_of_quaternion; i < numbers.size(); ++i) numbers[i] = -numbers[i];
}

Camera_3 camera_of(const Numbers& n, Camera_3::Projection projection) {
  Camera_3 camera;
  camera.projection = projection;
  camera.target = {n[0], n[1], n[2]};
  camera.height = std::exp(n[4]);
  camera.field_of_view = n[5];
  const Quaternion q = normalized(quaternion_in(n));
  camera.up = turned_up(q);
  const bool is_perspective = projection == Camera_3::Projection::perspective;
  const double away =
      is_perspective ? camera.height / (2 * std::tan(camera.field_of_view * std::numbers::pi / 360)) : std::exp(n[3]);
  camera.position = camera.target + away * turned_back(q);
  return camera;
}

}  // namespace

Camera_3 camera_on_path(std::span<const Camera_3> key_frames, double place, bool is_loop) {
  if (key_frames.empty()) return {};
  const auto count = static_cast<long>(key_frames.size());
  const double whole = static_cast<double>(is_loop ? count : count - 1);
  if (is_loop) place -= whole * std::floor(place / whole);
  place = std::clamp(place, 0.0, whole);
  const long first = std::min(static_cast<long>(place), std::max(0L, static_cast<long>(whole) - 1));
  const double part = place - static_cast<double>(first);
  const auto at = [&](long i) -> const Camera_3& {
    return key_frames[static_cast<std::size_t>(is_loop ? (i % count + count) % count : std::clamp(i, 0L, count - 1))];
  };
  if (part == 0) return at(first);
  if (part == 1) return at(first + 1);
  std::array<Numbers, 4> around{};
  for (long i = 0; i < 4; ++i) {
    Numbers& numbers = around[static_cast<std::size_t>(i)];
    numbers = numbers_of(at(first - 1 + i));
    if (i > 0) turn_to(numbers, around[static_cast<std::size_t>(i - 1)]);
  }
  const bool has_before = is_loop || first > 0;
  const bool has_after = is_loop || first + 2 < count;
  Numbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double from = around[1][i];
    const double to = around[2][i];
    // A cubic with the slopes of Catmull and Rom; at open ends that of the straight way.
    const double leaving = has_before ? (to - around[0][i]) / 2 : to - from;
    const double arriving = has_after ? (around[3][i] - from) / 2 : to - from;
    const double t = part;
    numbers[i] =
        from +
        t * (leaving + t * (3 * (to - from) - 2 * leaving - arriving + t * (leaving + arriving - 2 * (to - from))));
  }
  return camera_of(numbers, at(first + 1).projection);
}

bool is_nearly_equal(const Camera_3& one, const Camera_3& other) {
  if (one.projection != other.projection) return false;
  constexpr double part = 1e-7;
  const double size = part * std::max(one.height_at_target(), other.height_at_target());
  const Camera_3::Axes first = one.axes();
  const Camera_3::Axes second = other.axes();
  return distance(one.target, other.target) < size &&
         std::abs(one.height_at_target() - other.height_at_target()) < size &&
         std::abs(one.field_of_view - other.field_of_view) < part * one.field_of_view &&
         distance(first.back, second.back) < part && distance(first.up, second.up) < part;
}

}  // namespace mesecina
