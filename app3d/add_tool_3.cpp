// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMouseEvent>
#include <utility>

#include "app3d/marks_3.h"
#include "app3d/tools_3.h"

namespace mesecina {

QString Add_tool_3::hint(const QPointF& pixel) {
  if (is_resizing()) return tr("Release at the radius; Esc takes it back");
  if (uses_handles() && handle_at(pixel)) return tr("Drag resizes the ball");
  const bool is_ball = kind_ == Kind::ball;
  const QString what = is_ball ? tr("Click adds a ball here") : tr("Click adds a point here");
  return is_ball ? tr("%1; drag turns the scene, Shift+wheel resizes").arg(what)
                 : tr("%1; drag turns the scene").arg(what);
}

Qt::CursorShape Add_tool_3::cursor(const QPointF& pixel) {
  return is_resizing() || (uses_handles() && handle_at(pixel)) ? Qt::SizeHorCursor : Qt::CrossCursor;
}

void Add_tool_3::show_ghost(const std::optional<Point_3>& place) {
  if (!place && !ghost_) return;
  ghost_.reset();
  if (place) {
    auto set = std::make_shared<Primitive_set>();
    set->dimension = 3;
    set->vertices.push_back(*place);
    if (kind_ == Kind::ball) {
      set->balls.push_back({0, editor().usual_radius(viewer().view().camera.height_at_target())});
    } else {
      set->points.push_back(0);
    }
    ghost_ = std::move(set);
  }
  viewer().update();
}

void Add_tool_3::hover(const QPointF& pixel) {
  const bool is_on_handle = uses_handles() && handle_at(pixel);
  show_ghost(is_on_handle ? std::nullopt : std::optional(aim().place_at(pixel)));
}

void Add_tool_3::leave() { show_ghost({}); }

std::vector<Scene_layer> Add_tool_3::overlay() const {
  std::vector<Scene_layer> layers = Tool_3::overlay();
  if (ghost_) layers.push_back(ghost_layer_3(ghost_));
  return layers;
}

bool Add_tool_3::press_left(const QMouseEvent& event) {
  // Keys are for the camera: only a plain click adds.
  is_pressed_ = event.modifiers() == Qt::NoModifier;
  return event.type() == QEvent::MouseButtonDblClick;
}

void Add_tool_3::release_left(const QMouseEvent& event) {
  if (!std::exchange(is_pressed_, false) || is_drag(event)) return;
  const Point_3 place = aim().place_at(event.position());
  show_ghost({});
  if (kind_ == Kind::ball) {
    editor().add_ball({place, editor().usual_radius(viewer().view().camera.height_at_target())});
  } else {
    editor().add_point(place);
  }
}

}  // namespace mesecina
