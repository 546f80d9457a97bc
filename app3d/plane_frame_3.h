// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "core/primitives.h"
#include "core/view_3.h"

namespace mesecina {

/// The part of a cutting plane that is shown and taken hold of: a rectangle around what the plane cuts of a box, and an
/// arrow along the normal in its middle.
struct Plane_frame_3 {
  Point_3 center;  ///< on the plane, nearest to the middle of the box
  Point_3 right;   ///< from the center to the middle of a side
  Point_3 up;      ///< to the middle of a neighbouring side
  Point_3 normal;  ///< unit length
  double arrow = 1;
  double half_thickness = 0;

  Point_3 tip() const { return center + arrow * normal; }
  /// In order around the rectangle, moved by so much along the normal.
  std::array<Point_3, 4> corners(double shift) const;
};

/// The box; for one without a size a cube of size 2 around its place.
Box sized(const Box& box);

/// `box` must have a size.
Plane_frame_3 frame_of(const Cutting_plane_3& plane, const Box& box);

/// Outlines of the rectangle, or of both where the plane has a thickness.
std::shared_ptr<const Primitive_set> outline_of(const Plane_frame_3& frame);

/// A plane through the middle of the box along two axes of coordinates, the one most across this direction, that takes
/// away what lies towards it.
Cutting_plane_3 plane_facing(const Point_3& direction, const Box& box);
/// Moved along its normal.
Cutting_plane_3 shifted(const Cutting_plane_3& plane, double distance);
/// Turned about an axis of unit length through a center, by radians counterclockwise seen from the axis' tip.
Cutting_plane_3 turned(const Cutting_plane_3& plane, const Point_3& center, const Point_3& axis, double angle);
/// With another normal, through the same center.
Cutting_plane_3 aligned(const Cutting_plane_3& plane, const Point_3& center, const Point_3& normal);

}  // namespace mesecina
