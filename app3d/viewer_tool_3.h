// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/style.h"

class QMouseEvent;
class QPainter;
class QWheelEvent;

namespace mesecina {

/// What is offered the mouse before the camera, and draws over the scene.
class Viewer_tool_3 {
 public:
  virtual ~Viewer_tool_3() = default;

  /// True: the tool takes the button; then it gets what follows until a button is released, and the camera nothing.
  virtual bool press(const QMouseEvent& event) = 0;
  /// The mouse moves with the button that the tool took.
  virtual void drag(const QMouseEvent& event) = 0;
  /// Of any button, also one that the camera had.
  virtual void release(const QMouseEvent& event) = 0;
  /// True: the double click is the tool's, which gets what follows as after a press.
  virtual bool double_click(const QMouseEvent& event) = 0;
  /// True: the wheel does not zoom.
  virtual bool wheel(const QWheelEvent& event) = 0;
  /// Drawn above the scene, with depth; cannot be picked. Asked for every picture, so the sets should be the same ones
  /// as long as nothing changes.
  virtual std::vector<Scene_layer> overlay() const = 0;
  /// Painted above everything, in logical pixels of the viewer.
  virtual void paint(QPainter& painter) const = 0;
};

}  // namespace mesecina
