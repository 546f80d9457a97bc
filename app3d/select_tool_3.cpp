// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "app3d/marks_3.h"
#include "app3d/tools_3.h"

namespace mesecina {

namespace {

constexpr Qt::KeyboardModifiers adding = Qt::ShiftModifier | Qt::ControlModifier;

/// Along the axis that the way goes along most.
Point_3 straightened(const Sight_3& sight, const Point_3& place, const Point_2& from, const Point_2& to) {
  constexpr std::array<Point_3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const auto start = sight.pixel(place);
  if (!start) return {};
  Point_3 best;
  double most = -1;
  for (const Point_3& axis : axes) {
    const auto end = sight.pixel(place + sight.pixel_size(place) * axis);
    const Point_2 way = end ? Point_2{end->x - start->x, end->y - start->y} : Point_2{};
    const double length = std::hypot(way.x, way.y);
    // An axis almost along the line of sight would run away from the cursor.
    constexpr double shortest = 0.1;
    const double share = length < shortest ? 0 : std::abs(way.x * (to.x - from.x) + way.y * (to.y - from.y)) / length;
    if (share <= most) continue;
    most = share;
    best = axis;
  }
  return (sight.along(to, place, best) - sight.along(from, place, best)) * best;
}

}  // namespace

QString Select_tool_3::hint(const QPointF& pixel) {
  if (state_ == State::moving)
    return tr("Across the line of sight; Shift: along an axis, Ctrl: on the surface; Esc takes it back");
  if (state_ == State::boxing) return tr("Shift adds to the selection, Ctrl toggles");
  if (is_resizing()) return tr("Release at the radius; Esc takes it back");
  if (handle_at(pixel)) return tr("Drag resizes %1").arg(Editor_3::words({{}, editor().selection().balls}));
  const auto target = aim().element_at(pixel);
  if (!target)
    return draws_rectangles() ? tr("Drag draws a rectangle that selects; Shift adds, Ctrl toggles")
                              : tr("Drag turns the scene; with Shift it draws a rectangle that selects");
  return contains(editor().selection(), target->element)
             ? tr("Drag moves %1").arg(Editor_3::words(editor().selection()))
             : tr("Click selects, drag moves");
}

Qt::CursorShape Select_tool_3::cursor(const QPointF& pixel) {
  if (state_ == State::moving) return Qt::SizeAllCursor;
  if (state_ == State::boxing) return Qt::CrossCursor;
  if (is_resizing() || handle_at(pixel)) return Qt::SizeHorCursor;
  return aim().element_at(pixel) ? Qt::PointingHandCursor : Qt::ArrowCursor;
}

bool Select_tool_3::cancel() {
  if (Tool_3::cancel()) return true;
  if (state_ != State::moving && state_ != State::boxing) return false;
  if (state_ == State::moving) editor().drag_by({});
  editor().select(before_);
  state_ = State::idle;
  viewer().update();
  return true;
}

bool Select_tool_3::draws_rectangles() const { return selects_by_drag(viewer().mouse_preset()); }

bool Select_tool_3::press_left(const QMouseEvent& event) {
  state_ = State::pressed;
  before_ = editor().selection();
  target_ = aim().element_at(event.position());
  deselects_on_release_ = false;
  const bool is_adding = event.modifiers() & adding;
  if (!target_) {
    const bool is_ours = is_adding || draws_rectangles();
    if (!is_ours) state_ = State::turning;
    return is_ours;
  }
  if (contains(before_, target_->element)) {
    // It may be the start of a drag of all that is selected, so a click on it acts when the button comes up.
    deselects_on_release_ = true;
  } else {
    editor().select(is_adding ? united(before_, target_->element) : target_->element);
  }
  return true;
}

Point_3 Select_tool_3::shift_to(const QMouseEvent& event) {
  const Sight_3 sight = aim().sight();
  const Point_2 from{pressed().x(), pressed().y()};
  const Point_2 to{event.position().x(), event.position().y()};
  if (event.modifiers() & Qt::ControlModifier) {
    const std::vector<Point_3> grabbed = positions(editor().drag_start(), target_->element);
    const auto surface = aim().surface_at(event.position());
    if (surface && !grabbed.empty()) return *surface - grabbed.front();
  }
  if (event.modifiers() & Qt::ShiftModifier) return straightened(sight, target_->place, from, to);
  return sight.across(to, target_->place) - sight.across(from, target_->place);
}

void Select_tool_3::drag_left(const QMouseEvent& event) {
  if (state_ == State::pressed) {
    if (!is_drag(event)) return;
    state_ = target_ ? State::moving : State::boxing;
    if (state_ == State::moving) {
      editor().begin_drag();
      aim().begin_move();
    }
  }
  if (state_ == State::moving) {
    editor().drag_by(shift_to(event));
  } else if (state_ == State::boxing) {
    rectangle_ = QRectF(pressed(), event.position()).normalized();
    const Selection_3 found = aim().inside(rectangle_);
    editor().select(event.modifiers() & Qt::ControlModifier ? toggled(before_, found)
                    : event.modifiers() & Qt::ShiftModifier ? united(before_, found)
                                                            : found);
    viewer().update();
  }
}

void Select_tool_3::release_left(const QMouseEvent& event) {
  const State ended = std::exchange(state_, State::idle);
  const bool is_adding = event.modifiers() & adding;
  if (ended == State::turning || (ended == State::pressed && !target_)) {
    if (!is_drag(event) && !is_adding) editor().select({});
  } else if (ended == State::pressed && target_ && deselects_on_release_) {
    editor().select(is_adding ? toggled(before_, target_->element) : target_->element);
  } else if (ended == State::boxing) {
    viewer().update();
  }
}

void Select_tool_3::paint(QPainter& painter) const {
  Tool_3::paint(painter);
  if (state_ == State::boxing) paint_rectangle_3(painter, rectangle_);
}

}  // namespace mesecina
