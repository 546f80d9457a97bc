// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <optional>

#include "app3d/editor_3.h"
#include "app3d/sight_3.h"
#include "app3d/viewer_3.h"

namespace mesecina {

/// What the mouse aims at in a viewer, for editing. Pixels are logical ones of the viewer. Needs a picture of ids for
/// each view and scene, and costs nothing more.
class Aim_3 {
 public:
  Aim_3(Viewer_3& viewer, const Editor_3& editor) : viewer_(viewer), editor_(editor) {}

  /// A ball or point, and where on it.
  struct Target {
    Selection_3 element;
    Point_3 place;
  };
  /// The shown ball or point under the cursor or a little beside it; translucent layers do not hide it, solid ones do.
  std::optional<Target> element_at(const QPointF& pixel);
  /// For something new: what is seen there; where nothing is, the place on the cutting plane, if it has one there, or
  /// on the plane through the pivot across the line of sight.
  Point_3 place_at(const QPointF& pixel);
  /// For what is moved: the place on the mesh, the points and the balls, all as they are now but without the selected
  /// ones. None where there is none of them. Needs begin_move() first.
  std::optional<Point_3> surface_at(const QPointF& pixel);
  void begin_move();
  /// What lies in the rectangle and is left by the cutting plane, also behind other things; of balls the centers.
  Selection_3 inside(const QRectF& rectangle) const;
  Sight_3 sight() const;

 private:
  struct Picture {
    Id_picture ids;
    Scene scene;
    std::optional<View_3> view;
  };
  const Id_picture& drawn(Picture& picture, Scene scene);
  /// Device pixel.
  QPoint device(const QPointF& pixel) const;

  Viewer_3& viewer_;
  const Editor_3& editor_;
  Picture elements_;
  Scene surface_scene_;
  Picture surfaces_;
};

}  // namespace mesecina
