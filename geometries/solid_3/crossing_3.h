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

/// Coordinate planes, each by the axis along which it is looked at; the order of the others keeps the orientation.
inline std::array<double, 2> project(const Point_3& p, int axis) {
  return axis == 2 ? std::array{p.x, p.y} : axis == 0 ? std::array{p.y, p.z} : std::array{p.z, p.x};
}

/// Where a ray begins: a point whose coordinates are doubles. All signs are exact.
class Double_place {
 public:
  explicit Double_place(const Point_3& p) : point_(p), box_{p, p} {}

  /// A box that contains the point.
  const Box& box() const { return box_; }
  /// Of the line from p to q, looking against the axis: 1 left of it, -1 right of it, 0 on it.
  int side_of_line(const Point_3& p, const Point_3& q, int axis) const {
    const auto convert_2 = [axis](const Point_3& r) {
      const auto [x, y] = project(r, axis);
      return Kernel::Point_2(x, y);
    };
    return CGAL::orientation(convert_2(p), convert_2(q), convert_2(point_));
  }
  /// Of the plane of a triangle: 1 where its corners are seen counterclockwise.
  int side_of_plane(const Corners_3& t) const {
    return CGAL::orientation(convert(t[0]), convert(t[1]), convert(t[2]), convert(point_));
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

  const Box& box() const { return box_; }
  int side_of_line(const Point_3& p, const Point_3& q, int axis) const {
    const auto convert_2 = [axis](const Point_3& r) {
      const auto [x, y] = project(r, axis);
      return Kernel::Point_2(x, y);
    };
    const Kernel::Point_2 place = axis == 2   ? Kernel::Point_2(point_.x(), point_.y())
                                  : axis == 0 ? Kernel::Point_2(point_.y(), point_.z())
                                              : Kernel::Point_2(point_.z(), point_.x());
    return CGAL::orientation(convert_2(p), convert_2(q), place);
  }
  int side_of_plane(const Corners_3& t) const {
    return CGAL::orientation(convert(t[0]), convert(t[1]), convert(t[2]), point_);
  }

 private:
  static Kernel::Point_3 convert(const Point_3& p) { return {p.x, p.y, p.z}; }

  Kernel::Point_3 point_;
  Box box_;
};

/// On which side of a triangle a ray upwards begins that begins on it: 1 on that of its normal, -1 on the other one; 0
/// for triangles without area, which no ray meets. Exact.
inline int side_of_ray(const Corners_3& t) {
  for (const int axis : {2, 0, 1})
    if (const int turn = Double_place(t[2]).side_of_line(t[0], t[1], axis); turn != 0) return turn;
  return 0;
}

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
/// on the surface. Triangles without area are never met.
template <class Place>
Crossing_3 crossing_above(const Corners_3& t, const Place& place) {
  const Box box = box_of(t);
  if (!may_be_above(box, place.box())) return {};
  std::array<int, 3> sides{};
  // Of the triangle looked at along an axis: 1 or -1 when the place is in it, and its turn is this one; 2 where it is
  // no triangle but the place is in line with it.
  const auto turn_around = [&](int axis) {
    bool is_left = false;
    bool is_right = false;
    for (std::size_t i = 0; i < 3; ++i) {
      sides[i] = place.side_of_line(t[i], t[(i + 1) % 3], axis);
      is_left |= sides[i] > 0;
      is_right |= sides[i] < 0;
      if (is_left && is_right) return 0;
    }
    return is_left ? 1 : is_right ? -1 : 2;
  };
  const int turn = turn_around(2);
  if (turn == 0) return {};
  const bool may_be_on = box.lower.z <= place.box().upper.z;
  if (turn == 2) {
    if (!may_be_on) return {};
    const int along_x = turn_around(0);
    const int seen = along_x == 2 ? turn_around(1) : along_x;
    return {0, seen == 1 || seen == -1};
  }
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
    if (moved_is_left != (turn == 1)) return {};
  }
  return {turn, false};
}

}  // namespace mesecina
