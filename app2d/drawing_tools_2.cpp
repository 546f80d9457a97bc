// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <cmath>
#include <utility>

#include "app2d/tools_2.h"
#include "layers/panel_paint.h"

namespace mesecina {

namespace {
/// Between vertices of an outline drawn in one go, in logical pixels.
constexpr double freehand_spacing = 8;
/// A double click ends with a second click at about the same place, which is no vertex.
constexpr double same_place = 3;
constexpr int readout_digits = 5;
}  // namespace

QString radius_readout(double radius) {
  return QCoreApplication::translate("tools", "radius %1").arg(short_number(radius, readout_digits));
}

void Spray_path_2::go_to(const Point_2& position, double step, const std::function<void(const Point_2&)>& place) {
  if (!last_) return;
  // A quick stroke jumps over many pixels between two events.
  double far = distance(*last_, position);
  while (far >= step) {
    const double t = step / far;
    last_ = Point_2{last_->x + t * (position.x - last_->x), last_->y + t * (position.y - last_->y)};
    place(*last_);
    far = distance(*last_, position);
  }
}

QString Insert_tool_2::hint(const Canvas_event&) const { return tr("Click adds a point"); }

bool Insert_tool_2::press_left(const Canvas_event& event) {
  editor().add_point(event.position);
  return true;
}

QString Spray_tool_2::hint(const Canvas_event&) const { return tr("Drag draws points"); }

bool Spray_tool_2::press_left(const Canvas_event& event) {
  ++gesture_;
  path_.start(event.position);
  editor().add_point(event.position, QStringLiteral("spray/%1").arg(gesture_));
  return true;
}

void Spray_tool_2::drag(const Canvas_event& event) {
  path_.go_to(event.position, spacing_ / editor().canvas().view().scale, [this](const Point_2& position) {
    editor().add_point(position, QStringLiteral("spray/%1").arg(gesture_));
  });
}

bool Spray_tool_2::release(const Canvas_event& event) {
  if (event.button != Qt::LeftButton) return false;
  path_.stop();
  return true;
}

QString Disk_tool_2::hint(const Canvas_event&) const {
  if (state_ == State::drawing) return tr("Release at the radius; Esc drops the disk");
  return tr("Drag from the center to the radius; click draws radius %1, Ctrl+drag sprays")
      .arg(short_number(editor().usual_radius(), readout_digits));
}

bool Disk_tool_2::cancel() {
  if (state_ == State::idle) return false;
  state_ = State::idle;
  path_.stop();
  Q_EMIT preview_changed();
  return true;
}

Preview_2 Disk_tool_2::preview() const {
  if (state_ != State::drawing) return {};
  const double radius = distance(start_.position, cursor_);
  return {{start_.position, cursor_}, Disk_2{start_.position, radius}, radius_readout(radius)};
}

bool Disk_tool_2::wheel(const Canvas_event& event, double degrees) {
  if (state_ != State::idle || !editor().is_over_selected_disk(event)) return false;
  editor().turn_wheel(degrees);
  return true;
}

bool Disk_tool_2::press_left(const Canvas_event& event) {
  start_ = event;
  cursor_ = event.position;
  if (event.modifiers & Qt::ControlModifier) {
    state_ = State::spraying;
    ++gesture_;
    path_.start(event.position);
    spray(event.position);
  } else {
    state_ = State::pressed;
  }
  return true;
}

void Disk_tool_2::spray(const Point_2& position) {
  editor().add_disk({position, editor().usual_radius()}, QStringLiteral("spray-disks/%1").arg(gesture_));
}

void Disk_tool_2::drag(const Canvas_event& event) {
  if (state_ == State::idle) return;
  if (state_ == State::spraying) {
    path_.go_to(event.position, spacing_ / editor().canvas().view().scale,
                [this](const Point_2& position) { spray(position); });
    return;
  }
  const double moved = (event.pixel - start_.pixel).manhattanLength();
  if (state_ == State::pressed && moved < QApplication::startDragDistance() / 2.0) return;
  state_ = State::drawing;
  cursor_ = event.position;
  Q_EMIT preview_changed();
}

bool Disk_tool_2::release(const Canvas_event& event) {
  if (event.button != Qt::LeftButton || state_ == State::idle) return false;
  const State state = std::exchange(state_, State::idle);
  path_.stop();
  const double radius = state == State::drawing ? distance(start_.position, event.position) : editor().usual_radius();
  if (state != State::spraying && radius > 0) editor().add_disk({start_.position, radius});
  Q_EMIT preview_changed();
  Q_EMIT hovered(event);
  return true;
}

QString Outline_tool_2::hint(const Canvas_event&) const {
  if (ring_.empty()) return tr("Click or drag draws an outline");
  return tr("Double click or Enter closes the outline, Esc drops it (%1 vertices)").arg(ring_.size());
}

bool Outline_tool_2::cancel() {
  if (ring_.empty()) return false;
  ring_.clear();
  Q_EMIT preview_changed();
  return true;
}

bool Outline_tool_2::complete() {
  if (ring_.empty()) return false;
  constexpr std::size_t fewest = 3;
  if (ring_.size() < fewest) {
    Q_EMIT editor().failed(tr("An outline needs at least 3 vertices; it has %1 so far.").arg(ring_.size()));
    return true;
  }
  editor().add_ring(std::move(ring_));
  ring_.clear();
  Q_EMIT preview_changed();
  return true;
}

Preview_2 Outline_tool_2::preview() const {
  Preview_2 preview;
  if (ring_.empty()) return preview;
  preview.line = ring_;
  preview.line.push_back(cursor_);
  return preview;
}

void Outline_tool_2::add(const Point_2& vertex, double least_distance) {
  if (!ring_.empty() && distance(ring_.back(), vertex) * editor().canvas().view().scale < least_distance) return;
  ring_.push_back(vertex);
  Q_EMIT preview_changed();
}

bool Outline_tool_2::press_left(const Canvas_event& event) {
  cursor_ = event.position;
  add(event.position, same_place);
  return true;
}

void Outline_tool_2::drag(const Canvas_event& event) {
  if (!ring_.empty()) add(event.position, freehand_spacing);
}

bool Outline_tool_2::move(const Canvas_event& event) {
  cursor_ = event.position;
  if (!ring_.empty()) Q_EMIT preview_changed();
  return Tool_2::move(event);
}

bool Outline_tool_2::double_click(const Canvas_event& event) {
  if (event.button != Qt::LeftButton) return press(event);
  add(event.position, same_place);
  complete();
  return true;
}

QString Pan_tool_2::hint(const Canvas_event&) const { return tr("Drag moves the view"); }

Qt::CursorShape Pan_tool_2::cursor(const Canvas_event& event) const {
  return event.buttons & Qt::LeftButton ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
}

bool Pan_tool_2::press_left(const Canvas_event& event) {
  last_ = event.pixel;
  return true;
}

void Pan_tool_2::drag(const Canvas_event& event) {
  View_2 view = editor().canvas().view();
  const QPointF moved = event.pixel - last_;
  view.center = {view.center.x - moved.x() / view.scale, view.center.y + moved.y() / view.scale};
  last_ = event.pixel;
  editor().canvas().set_view(view);
}

}  // namespace mesecina
