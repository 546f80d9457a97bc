// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/point.h"

namespace mesecina {

using Corners_3 = std::array<Point_3, 3>;

inline Box box_of(const Corners_3& corners) {
  Box box;
  for (const Point_3& p : corners) box.add(p);
  return box;
}

/// Where a ray begins: a point whose coordinates are doubles. All signs are exact.
class Double_place {
 public:
  explicit Double_place(const Point_3& p) : point_(p), box_{p, p} {}

  /// A box that contains the point.
  const Box& box() const { return box_; }
  /// Of the line from p to q, seen from above: 1 left of it, -1 right of it, 0 on it.
  int side_of_line(const Point_3& p, const Point_3& q) const {
    return CGAL::orientation(Kernel::Point_2(p.x, p.y), Kernel::Point_2(q.x, q.y), Kernel::Point_2(point_.x, point_.y));
  }
  /// Of the plane of a triangle: 1 where its corners are seen counterclockwise.
  int side_of_plane(const Corners_3& t) const {
    return CGAL::orientation(convert(t[0]), convert(t[1]), convert(t[2]), convert(point_));
  }
  /// It lies on a triangle with area.
  bool is_on(const Corners_3& t) const {
    return Kernel::Triangle_3(convert(t[0]), convert(t[1]), convert(t[2])).has_on(convert(point_));
  }

 private:
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  static Kernel::Point_3 convert(const Point_3& p) { return {p.x, p.y, p.z}; }

  Point_3 point_;
  Box box_;
};

/// Where a ray begins: a point whose coordinates are no doubles. Slower, and for one thread.
class Exact_place {
 public:
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

  explicit Exact_place(const Kernel::Point_3& p) : point_(p) {
    const auto [x_low, x_high] = CGAL::to_interval(p.x());
    const auto [y_low, y_high] = CGAL::to_interval(p.y());
    const auto [z_low, z_high] = CGAL::to_interval(p.z());
    box_ = {{x_low, y_low, z_low}, {x_high, y_high, z_high}};
  }
  /// The centroid of a triangle.
  static Exact_place middle_of(const Corners_3& t) {
    return Exact_place(CGAL::centroid(convert(t[0]), convert(t[1]), convert(t[2])));
  }

  /// Of a triangle as seen from above: 1 counterclockwise, 0 where it is vertical.
  static int turn_of(const Corners_3& t) {
    return CGAL::orientation(project(convert(t[0])), project(convert(t[1])), project(convert(t[2])));
  }
  const Box& box() const { return box_; }
  int side_of_line(const Point_3& p, const Point_3& q) const {
    return CGAL::orientation(project(convert(p)), project(convert(q)), project(point_));
  }
  int side_of_plane(const Corners_3& t) const {
    return CGAL::orientation(convert(t[0]), convert(t[1]), convert(t[2]), point_);
  }
  bool is_on(const Corners_3& t) const {
    return Kernel::Triangle_3(convert(t[0]), convert(t[1]), convert(t[2])).has_on(point_);
  }

 private:
  static Kernel::Point_3 convert(const Point_3& p) { return {p.x, p.y, p.z}; }
  static Kernel::Point_2 project(const Kernel::Point_3& p) { return {p.x(), p.y()}; }

  Kernel::Point_3 point_;
  Box box_;
};

/// How the ray upwards from a place meets a triangle.
struct Crossing_3 {
  int direction = 0;   ///< 1: the triangle is crossed towards the side of its normal; -1: from there; 0: not crossed
  bool is_on = false;  ///< the place is on the triangle
};

/// Whether box (of triangles) may hold something above a place.
inline bool may_be_above(const Box& box, const Box& place) {
  return box.lower.x <= place.upper.x && box.upper.x >= place.lower.x && box.lower.y <= place.upper.y &&
         box.upper.y >= place.lower.y && box.upper.z >= place.lower.z;
}

/// Exact. The ray begins at the place moved by (d, e, 0) with infinitely small 0 < e << d, so that it meets no vertex
/// and no edge: the directions of a closed surface's crossings add up to its winding number, except where the place is
/// on the surface. The triangle has area.
template <class Place>
Crossing_3 crossing_above(const Corners_3& t, const Place& place) {
  const Box box = box_of(t);
  if (!may_be_above(box, place.box())) return {};
  std::array<int, 3> sides{};
  bool is_left = false;
  bool is_right = false;
  for (std::size_t i = 0; i < 3; ++i) {
    sides[i] = place.side_of_line(t[i], t[(i + 1) % 3]);
    is_left |= sides[i] > 0;
    is_right |= sides[i] < 0;
    if (is_left && is_right) return {};
  }
  const bool may_be_on = box.lower.z <= place.box().upper.z;
  if (!is_left && !is_right) return {0, may_be_on && place.is_on(t)};
  const int turn = is_left ? 1 : -1;
  if (may_be_on) {
    const int side = place.side_of_plane(t);
    if (side == 0) return {0, true};
    if (side == turn) return {};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (sides[i] != 0) continue;
    const Point_3& p = t[i];
    const Point_3& q = t[(i + 1) % 3];
    const bool moved_is_left = p.y != q.y ? p.y > q.y : q.x > p.x;
    if (moved_is_left != is_left) return {};
  }
  return {turn, false};
}

}  // namespace mesecina
