// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/plane_frame_3.h"

#include <algorithm>
#include <cmath>

namespace mesecina {

namespace {

Point_3 normalized(const Point_3& p) { return (1 / std::hypot(p.x, p.y, p.z)) * p; }

/// Rotated about an axis of unit length.
Point_3 rotated(const Point_3& p, const Point_3& axis, double angle) {
  const double c = std::cos(angle);
  return c * p + std::sin(angle) * cross(axis, p) + ((1 - c) * dot(axis, p)) * axis;
}

}  // namespace

Box sized(const Box& box) {
  if (!box.is_empty() && box.diagonal() > 0) return box;
  const Point_3 middle = box.is_empty() ? Point_3{} : box.lower;
  Box result;
  result.add(middle - Point_3{1, 1, 1});
  result.add(middle + Point_3{1, 1, 1});
  return result;
}

std::array<Point_3, 4> Plane_frame_3::corners(double shift) const {
  const Point_3 middle = center + shift * normal;
  return {middle - right - up, middle + right - up, middle + right + up, middle - right + up};
}

Plane_frame_3 frame_of(const Cutting_plane_3& plane, const Box& box) {
  const Point_3 middle = midpoint(box.lower, box.upper);
  Plane_frame_3 frame;
  frame.normal = normalized(plane.normal);
  frame.center = middle - dot(middle - plane.point, frame.normal) * frame.normal;
  frame.half_thickness = plane.thickness.value_or(0) / 2;
  // Sides follow the axes as far as they can.
  const Point_3 size = {std::abs(frame.normal.x), std::abs(frame.normal.y), std::abs(frame.normal.z)};
  const Point_3 least = size.x <= size.y && size.x <= size.z ? Point_3{1, 0, 0}
                        : size.y <= size.z                   ? Point_3{0, 1, 0}
                                                             : Point_3{0, 0, 1};
  const Point_3 right = normalized(cross(least, frame.normal));
  const Point_3 up = cross(frame.normal, right);
  double half_width = 0;
  double half_height = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Point_3 off = Point_3{corner & 1U ? box.upper.x : box.lower.x, corner & 2U ? box.upper.y : box.lower.y,
                                corner & 4U ? box.upper.z : box.lower.z} -
                        middle;
    half_width = std::max(half_width, std::abs(dot(off, right)));
    half_height = std::max(half_height, std::abs(dot(off, up)));
  }
  constexpr double room = 1.08;
  constexpr double least_part = 0.1;
  constexpr double part_of_arrow = 0.15;
  const double diagonal = box.diagonal();
  frame.right = (room * std::max(half_width, least_part * diagonal)) * right;
  frame.up = (room * std::max(half_height, least_part * diagonal)) * up;
  frame.arrow = frame.half_thickness + part_of_arrow * diagonal;
  return frame;
}

std::shared_ptr<const Primitive_set> outline_of(const Plane_frame_3& frame) {
  auto set = std::make_shared<Primitive_set>();
  set->dimension = 3;
  const auto add = [&](double shift) {
    const int first = static_cast<int>(set->vertices.size());
    for (const Point_3& corner : frame.corners(shift)) set->vertices.push_back(corner);
    for (int i = 0; i < 4; ++i) set->segments.push_back({first + i, first + (i + 1) % 4});
  };
  add(frame.half_thickness);
  if (frame.half_thickness != 0) add(-frame.half_thickness);
  return set;
}

Cutting_plane_3 plane_facing(const Point_3& direction, const Box& box) {
  const Point_3 size = {std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
  Point_3 normal{0, 0, direction.z < 0 ? -1.0 : 1.0};
  if (size.x > size.y && size.x > size.z) {
    normal = {direction.x < 0 ? -1.0 : 1.0, 0, 0};
  } else if (size.y > size.z) {
    normal = {0, direction.y < 0 ? -1.0 : 1.0, 0};
  }
  return {midpoint(box.lower, box.upper), normal, {}};
}

Cutting_plane_3 shifted(const Cutting_plane_3& plane, double distance) {
  return {plane.point + distance * normalized(plane.normal), plane.normal, plane.thickness};
}

Cutting_plane_3 turned(const Cutting_plane_3& plane, const Point_3& center, const Point_3& axis, double angle) {
  return aligned(plane, center, rotated(plane.normal, axis, angle));
}

Cutting_plane_3 aligned(const Cutting_plane_3& plane, const Point_3& center, const Point_3& normal) {
  return {center, normalized(normal), plane.thickness};
}

}  // namespace mesecina
