// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/tools_3.h"

#include <QApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app3d/marks_3.h"

namespace mesecina {

namespace {

/// How near the cursor has to be to a handle, in logical pixels.
constexpr double grab_radius = 8;
/// Handles are at least this far from the center, so that it stays free.
constexpr double least_handle_distance = 22;
constexpr std::size_t most_balls_with_handles = 50;
constexpr double least_dragged_radius = 0.5;
constexpr double eighths_per_degree = 8;

}  // namespace

Tool_3::Tool_3(Editor_3& editor, Viewer_3& viewer)
    : QObject(&editor), editor_(editor), viewer_(viewer), aim_(viewer, editor) {}

bool Tool_3::is_drag(const QMouseEvent& event) const {
  return (event.position() - pressed_).manhattanLength() >= QApplication::startDragDistance() / 2.0;
}

std::vector<Ball_handle_3> Tool_3::handles() const {
  std::vector<Ball_handle_3> handles;
  const auto balls = editor_.document().inputs().get(balls_input);
  const std::vector<std::size_t>& selected = editor_.selection().balls;
  if (!balls || selected.size() > most_balls_with_handles || !editor_.reach().balls) return handles;
  const Sight_3 sight = aim_.sight();
  for (const std::size_t i : selected) {
    if (i >= balls->size()) continue;
    const auto pixel = sight.pixel((*balls)[i].center);
    const double radius = sight.outline_radius((*balls)[i].center, (*balls)[i].radius);
    // Beside others, handles far outside of their ball would seem to be those of another one.
    if (!pixel || !std::isfinite(radius) || (radius < least_handle_distance / 2 && selected.size() > 1)) continue;
    handles.push_back({i, {pixel->x + std::max(radius, least_handle_distance), pixel->y}});
  }
  return handles;
}

std::optional<Ball_handle_3> Tool_3::handle_at(const QPointF& pixel) const {
  std::optional<Ball_handle_3> found;
  double best = grab_radius;
  for (const Ball_handle_3& handle : handles()) {
    const QPointF off = handle.pixel - pixel;
    const double away = std::hypot(off.x(), off.y());
    if (away > best) continue;
    best = away;
    found = handle;
  }
  return found;
}

void Tool_3::resize_to(const QPointF& pixel) {
  const auto start = editor_.dragged_ball(handle_->ball);
  if (!start) return;
  const Sight_3 sight = aim_.sight();
  const auto away = [&](const QPointF& at) {
    return distance(sight.across({at.x(), at.y()}, start->center), start->center);
  };
  const double least = least_dragged_radius * sight.pixel_size(start->center);
  editor_.drag_radius(handle_->ball, std::max(least, start->radius + away(pixel) - away(pressed_)));
}

bool Tool_3::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  pressed_ = event.position();
  handle_ = uses_handles() ? handle_at(pressed_) : std::nullopt;
  if (!handle_) return press_left(event);
  editor_.begin_drag();
  return true;
}

void Tool_3::drag(const QMouseEvent& event) {
  if (handle_) {
    resize_to(event.position());
  } else {
    drag_left(event);
  }
  Q_EMIT used(event.position());
}

void Tool_3::release(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return;
  if (!std::exchange(handle_, std::nullopt)) release_left(event);
  Q_EMIT used(event.position());
}

bool Tool_3::double_click(const QMouseEvent& event) { return press(event); }

bool Tool_3::cancel() {
  if (!std::exchange(handle_, std::nullopt)) return false;
  editor_.drag_by({});
  return true;
}

QString Tool_3::readout() const {
  if (!handle_) return {};
  const std::vector<Ball_3> balls = selected_balls(editor_.document().inputs(), {{}, {handle_->ball}});
  return balls.empty() ? QString() : radius_readout_3(balls.front().radius);
}

bool Tool_3::wheel(const QWheelEvent& event) {
  if (!(event.modifiers() & Qt::ShiftModifier) || editor_.selection().balls.empty()) return false;
  // Some systems turn the wheel sideways while Shift is held.
  const int eighths = event.angleDelta().y() == 0 ? event.angleDelta().x() : event.angleDelta().y();
  editor_.turn_wheel(eighths / eighths_per_degree);
  Q_EMIT used(event.position());
  return true;
}

std::vector<Scene_layer> Tool_3::overlay() const {
  const Inputs& inputs = editor_.document().inputs();
  const bool is_same = marks_ && marks_->inputs == inputs && marks_->selection == editor_.selection();
  if (!is_same) marks_ = {inputs, editor_.selection(), selection_marks_3(inputs, editor_.selection())};
  return marks_->layers;
}

void Tool_3::paint(QPainter& painter) const {
  if (editor_.document().inputs().is_empty()) {
    painter.setFont(viewer_.font());
    painter.setPen(Qt::gray);
    painter.drawText(viewer_.rect(), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Drop a file here, press B and click to add balls, or choose a shape of the menu Insert"));
  }
  paint_outlines_3(painter, aim_.sight(), editor_.document().inputs(), editor_.selection());
  if (!uses_handles()) return;
  for (const Ball_handle_3& handle : handles()) paint_handle_3(painter, handle.pixel);
}

QString Turn_tool_3::hint(const QPointF&) { return tr("? shows keys and mouse"); }

}  // namespace mesecina
