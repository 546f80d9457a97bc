// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>
#include <QPointF>
#include <array>
#include <optional>

#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

/// The axes of coordinates in a corner of the picture, as the camera sees their directions. Lengths in logical pixels.
class Axis_gizmo {
 public:
  static constexpr double radius = 38;     ///< from the middle to the ends of the axes
  static constexpr double end_radius = 9;  ///< of the buttons at the ends
  static constexpr double size = 2 * (radius + end_radius);

  Axis_gizmo(const Camera_3& camera, const QPointF& middle);

  /// The direction to which the end under this pixel points; the nearest one to the viewer where several are; nullopt
  /// beside them.
  std::optional<Point_3> direction_at(const QPointF& pixel) const;
  /// `hovered`: the direction whose end is emphasized.
  void paint(QPainter& painter, Color ground, const std::optional<Point_3>& hovered) const;

 private:
  struct End {
    Point_3 direction;
    QPointF place;
    double height = 0;  ///< towards the viewer
    std::size_t axis = 0;
    bool is_positive = true;
  };
  QPointF middle_;
  std::array<End, 6> ends_;  ///< from the farthest to the nearest
};

/// A line of a round length: 1, 2 or 5 times a power of ten, in units of the scene.
struct Scale_bar {
  double length = 1;
  double pixels = 100;
};
/// The longest one of at most so many pixels. `unit`: of the scene, in pixels; positive and finite.
Scale_bar scale_bar(double unit, double most_pixels);
/// `corner`: the lower left one. `is_exact`: false where the scale holds in one depth only, which is said.
void paint_scale_bar(QPainter& painter, const Scale_bar& bar, bool is_exact, const QPointF& corner, Color ground);

}  // namespace mesecina
