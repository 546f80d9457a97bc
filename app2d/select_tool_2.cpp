// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QRectF>
#include <cmath>

#include "app2d/tools_2.h"

namespace mesecina {

bool Tool_2::press(const Canvas_event& event) {
  if (event.button == Qt::LeftButton) return press_left(event);
  if (event.button != Qt::RightButton) return false;
  Q_EMIT editor_.menu_requested(event.pixel);
  return true;
}

bool Tool_2::move(const Canvas_event& event) {
  if (event.buttons & Qt::LeftButton) drag(event);
  Q_EMIT hovered(event);
  return true;
}

QString Select_tool_2::hint(const Canvas_event& event) const {
  if (state_ == State::moving) return tr("Shift keeps to one axis; Esc takes it back");
  if (state_ == State::boxing) return tr("Shift adds to the selection, Ctrl toggles");
  if (state_ == State::resizing) return tr("Release at the radius; Esc takes it back");
  if (editor().handle_at(event))
    return tr("Drag resizes %1").arg(Editor_2::words({{}, {}, editor().selection().disks}));
  const Selection_2 hit = editor().at(event);
  if (hit.is_empty()) return tr("Drag selects, double click adds a point");
  return contains(editor().selection(), hit) ? tr("Drag moves %1").arg(Editor_2::words(editor().selection()))
                                             : tr("Click selects, drag moves");
}

Qt::CursorShape Select_tool_2::cursor(const Canvas_event& event) const {
  if (state_ == State::moving) return Qt::SizeAllCursor;
  if (state_ == State::boxing) return Qt::CrossCursor;
  const auto handle = state_ == State::idle ? editor().handle_at(event) : handle_;
  if (handle) return handle->is_horizontal ? Qt::SizeHorCursor : Qt::SizeVerCursor;
  return editor().at(event).is_empty() ? Qt::ArrowCursor : Qt::PointingHandCursor;
}

bool Select_tool_2::cancel() {
  if (state_ == State::idle) return false;
  if (state_ == State::moving || state_ == State::resizing) editor().drag_by(0, 0);
  editor().canvas().set_rubber_band({});
  editor().select(before_);
  state_ = State::idle;
  Q_EMIT preview_changed();
  return true;
}

Preview_2 Select_tool_2::preview() const {
  Preview_2 preview;
  if (state_ != State::resizing) return preview;
  const auto resized_disk = selected_disks(editor().document().inputs(), {{}, {}, {handle_->disk}});
  if (!resized_disk.empty()) preview.readout = radius_readout(resized_disk.front().radius);
  return preview;
}

bool Select_tool_2::wheel(const Canvas_event& event, double degrees) {
  if (state_ != State::idle || !editor().is_over_selected_disk(event)) return false;
  editor().turn_wheel(degrees);
  return true;
}

bool Select_tool_2::press_left(const Canvas_event& event) {
  state_ = State::pressed;
  start_ = event;
  before_ = editor().selection();
  handle_ = editor().handle_at(event);
  hit_ = handle_ ? Selection_2() : editor().at(event);
  deselects_on_release_ = false;
  const bool is_toggle = event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
  if (hit_.is_empty()) return true;
  if (contains(before_, hit_)) {
    // It may be the start of a drag of all that is selected, so a click on it acts when the button comes up.
    deselects_on_release_ = true;
  } else {
    editor().select(is_toggle ? united(before_, hit_) : hit_);
  }
  return true;
}

Selection_2 Select_tool_2::with_box(const Canvas_event& event) const {
  Box box;
  box.add(start_.position);
  box.add(event.position);
  const Selection_2 found = inside(editor().document().inputs(), editor().reach(), box);
  if (event.modifiers & Qt::ControlModifier) return toggled(before_, found);
  if (event.modifiers & Qt::ShiftModifier) return united(before_, found);
  return found;
}

void Select_tool_2::drag(const Canvas_event& event) {
  if (state_ == State::idle) return;
  if (state_ == State::pressed) {
    if ((event.pixel - start_.pixel).manhattanLength() < QApplication::startDragDistance() / 2.0) return;
    state_ = handle_ ? State::resizing : hit_.is_empty() ? State::boxing : State::moving;
    if (state_ != State::boxing) editor().begin_drag();
  }
  if (state_ == State::resizing) {
    const auto disks = editor().document().inputs().get(disks_input);
    if (!disks || handle_->disk >= disks->size()) return;
    const Point_2& center = (*disks)[handle_->disk].center;
    editor().drag_radius(handle_->disk, distance(center, event.position) - distance(center, start_.position));
    return;
  }
  if (state_ == State::boxing) {
    editor().canvas().set_rubber_band(QRectF(start_.pixel, event.pixel).normalized());
    editor().select(with_box(event));
    return;
  }
  double dx = event.position.x - start_.position.x;
  double dy = event.position.y - start_.position.y;
  if (event.modifiers & Qt::ShiftModifier) (std::abs(dx) > std::abs(dy) ? dy : dx) = 0;
  editor().drag_by(dx, dy);
}

bool Select_tool_2::release(const Canvas_event& event) {
  if (event.button != Qt::LeftButton || state_ == State::idle) return false;
  const bool is_toggle = event.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
  if (state_ == State::pressed) {
    if (handle_) {
      // A click on a handle changes nothing.
    } else if (hit_.is_empty()) {
      if (!is_toggle) editor().select({});
    } else if (deselects_on_release_) {
      editor().select(is_toggle ? toggled(before_, hit_) : hit_);
    }
  }
  editor().canvas().set_rubber_band({});
  state_ = State::idle;
  Q_EMIT hovered(event);
  return true;
}

bool Select_tool_2::double_click(const Canvas_event& event) {
  if (event.button != Qt::LeftButton) return press(event);
  if (editor().at(event).is_empty() && !editor().handle_at(event)) editor().add_point(event.position);
  // Whoever keeps the button pressed goes on with moving the new point.
  return press_left(event);
}

}  // namespace mesecina
