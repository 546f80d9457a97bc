// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "app2d/tools_2.h"

namespace mesecina {

namespace {
/// Between vertices of an outline drawn in one go, in logical pixels.
constexpr double freehand_spacing = 8;
/// A double click ends with a second click at about the same place, which is no vertex.
constexpr double same_place = 3;
}  // namespace

QString Insert_tool_2::hint(const Canvas_event&) const { return tr("Click adds a point"); }

bool Insert_tool_2::press_left(const Canvas_event& event) {
  editor().add_point(event.position);
  return true;
}

QString Spray_tool_2::hint(const Canvas_event&) const { return tr("Drag draws points"); }

bool Spray_tool_2::press_left(const Canvas_event& event) {
  ++gesture_;
  last_ = event.position;
  editor().add_point(event.position, QStringLiteral("spray/%1").arg(gesture_));
  return true;
}

void Spray_tool_2::drag(const Canvas_event& event) {
  if (!last_) return;
  // A quick stroke jumps over many pixels between two events.
  const double step = spacing_ / editor().canvas().view().scale;
  double far = distance(*last_, event.position);
  while (far >= step) {
    const double t = step / far;
    last_ = Point_2{last_->x + t * (event.position.x - last_->x), last_->y + t * (event.position.y - last_->y)};
    editor().add_point(*last_, QStringLiteral("spray/%1").arg(gesture_));
    far = distance(*last_, event.position);
  }
}

bool Spray_tool_2::release(const Canvas_event& event) {
  if (event.button != Qt::LeftButton) return false;
  last_.reset();
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

std::vector<Point_2> Outline_tool_2::preview() const {
  if (ring_.empty()) return {};
  std::vector<Point_2> line = ring_;
  line.push_back(cursor_);
  return line;
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
