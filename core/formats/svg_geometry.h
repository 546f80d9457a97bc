// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// x' = a x + c y + e, y' = b x + d y + f, as in SVG.
struct Affine_2 {
  double a = 1;
  double b = 0;
  double c = 0;
  double d = 1;
  double e = 0;
  double f = 0;

  Point_2 operator()(const Point_2& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  /// First the right one, then the left one.
  Affine_2 operator*(const Affine_2& right) const;
};

/// A cubic Bézier curve that starts where the one before it ends.
struct Svg_curve {
  Point_2 control_1;
  Point_2 control_2;
  Point_2 end;
  bool is_straight = false;  ///< the control points mean nothing
};

struct Subpath {
  Point_2 start;
  std::vector<Svg_curve> curves;
  bool is_closed = false;  ///< by a command, not merely by ending where it starts

  const Point_2& end() const { return curves.empty() ? start : curves.back().end; }
  void add_line(const Point_2& to) { curves.push_back({{}, {}, to, true}); }
  void add_cubic(const Point_2& control_1, const Point_2& control_2, const Point_2& to) {
    curves.push_back({control_1, control_2, to, false});
  }
  void add_quadratic(const Point_2& control, const Point_2& to);
  /// The image of the unit circle's arc from angle `from` over `sweep` (radians, negative: clockwise), in pieces of at
  /// most 45 degrees, whose distance from the arc is below 5e-6 of the larger radius. Must start at end().
  void add_arc(const Affine_2& circle_to_plane, double from, double sweep, const Point_2& to);
  /// SVG's elliptical arc, with its rules for radii that are zero, negative or too small.
  void add_svg_arc(double radius_x, double radius_y, double rotation_degrees, bool large, bool positive_sweep,
                   const Point_2& to);
};

Subpath transformed(const Subpath& subpath, const Affine_2& transform);

bool is_finite(const Subpath& subpath);

/// Of the curves, not of their control points.
Box bounding_box(const Subpath& subpath);

/// A polyline from start to end whose distance from the curves is at most `tolerance`. Not finite or absurdly large
/// curves give at most a thousand vertices each.
Ring_2 flatten(const Subpath& subpath, double tolerance);

}  // namespace mesecina
