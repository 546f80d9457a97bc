// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/view_3.h"

namespace mesecina {

/// What is behind one pixel.
struct Sight_line {
  Point_3 from;
  Point_3 direction;  ///< unit length, away from the viewer
};

/// Between the places of a scene and the logical pixels of a picture, which count from its upper left corner. All in
/// O(1).
class Sight_3 {
 public:
  Sight_3(const Camera_3& camera, double width, double height);

  /// Unit vectors to the right, upwards and towards the viewer.
  const Camera_3::Axes& axes() const { return axes_; }
  Sight_line line(const Point_2& pixel) const;
  /// None for what is behind the viewer.
  std::optional<Point_2> pixel(const Point_3& place) const;
  /// Units of the scene per pixel there; 0 behind the viewer.
  double pixel_size(const Point_3& place) const;
  /// Of the outline of a ball, in pixels; infinity inside of it, 0 behind the viewer.
  double outline_radius(const Point_3& center, double radius) const;
  /// Where this pixel sees the plane; none when it does not.
  std::optional<Point_3> on_plane(const Point_2& pixel, const Point_3& point, const Point_3& normal) const;
  /// Where this pixel sees the plane across the line of sight through a place; that place when it is behind the viewer.
  Point_3 across(const Point_2& pixel, const Point_3& place) const;
  /// How far along a unit vector from this place one comes nearest to what is behind the pixel; 0 for a vector along
  /// the line of sight.
  double along(const Point_2& pixel, const Point_3& place, const Point_3& direction) const;

 private:
  Camera_3 camera_;
  Camera_3::Axes axes_;
  double width_;
  double height_;
  double unit_;  ///< of a pixel: at distance 1, or everywhere without perspective
};

/// Whether the cutting plane leaves this place. All is left where there is no plane.
bool is_left(const std::optional<Cutting_plane_3>& plane, const Point_3& place);

}  // namespace mesecina
