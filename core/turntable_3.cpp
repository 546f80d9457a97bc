// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/turntable_3.h"

#include <cmath>
#include <numbers>

namespace mesecina {

namespace {

/// About a unit vector.
Point_3 rotated(const Point_3& v, const Point_3& axis, double sine, double cosine) {
  const Point_3 across = cross(axis, v);
  const double along = dot(axis, v) * (1 - cosine);
  return {v.x * cosine + across.x * sine + axis.x * along, v.y * cosine + across.y * sine + axis.y * along,
          v.z * cosine + across.z * sine + axis.z * along};
}

}  // namespace

Point_3 up_axis(const Camera_3& camera) {
  const Point_3 up = camera.axes().up;
  constexpr double rounding = 1e-9;
  Point_3 best{0, 1, 0};
  double most = std::abs(up.y);
  if (std::abs(up.z) > most + rounding) {
    best = {0, 0, 1};
    most = std::abs(up.z);
  }
  if (std::abs(up.x) > most + rounding) best = {1, 0, 0};
  return dot(best, up) < 0 ? -1.0 * best : best;
}

Camera_3 turned_on_table(const Camera_3& camera, double turns) {
  turns -= std::floor(turns);
  if (turns == 0) return camera;
  const Point_3 axis = up_axis(camera);
  const double angle = 2 * std::numbers::pi * turns;
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  Camera_3 result = camera;
  result.position = camera.target + rotated(camera.position - camera.target, axis, sine, cosine);
  result.up = rotated(camera.up, axis, sine, cosine);
  return result;
}

}  // namespace mesecina
