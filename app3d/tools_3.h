// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>
#include <vector>

#include "app3d/aim_3.h"
#include "app3d/editor_3.h"
#include "app3d/viewer_tool_3.h"

class QMouseEvent;

namespace mesecina {

/// Where a selected ball can be taken hold of to change its radius.
struct Ball_handle_3 {
  std::size_t ball = 0;
  QPointF pixel;
};

/// One way to use the left button on the viewer; other buttons stay the camera's. With each of them Shift and the wheel
/// resize the selected balls, and what is selected is marked.
class Tool_3 : public QObject, public Viewer_tool_3 {
  Q_OBJECT
 public:
  Tool_3(Editor_3& editor, Viewer_3& viewer);

  /// What a click would do here.
  virtual QString hint(const QPointF& pixel) = 0;
  virtual Qt::CursorShape cursor(const QPointF& pixel) = 0;
  /// The mouse moves without a button.
  virtual void hover(const QPointF&) {}
  /// The mouse has left the viewer.
  virtual void leave() {}
  /// Esc: drops what is half done; false when nothing is.
  virtual bool cancel();
  /// A number that is being chosen, to be shown beside the cursor; empty for none.
  QString readout() const;

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  bool double_click(const QMouseEvent& event) override;
  bool wheel(const QWheelEvent& event) override;
  std::vector<Scene_layer> overlay() const override;
  void paint(QPainter& painter) const override;

 Q_SIGNALS:
  /// The mouse did something with a button or the wheel.
  void used(const QPointF& pixel);

 protected:
  /// True: the tool takes the button. Else the camera has it, and the tool hears of the release alone.
  virtual bool press_left(const QMouseEvent& event) = 0;
  virtual void drag_left(const QMouseEvent&) {}
  virtual void release_left(const QMouseEvent&) {}
  virtual bool uses_handles() const { return false; }

  Editor_3& editor() const { return editor_; }
  Viewer_3& viewer() const { return viewer_; }
  Aim_3& aim() { return aim_; }
  /// None when more balls are selected than there would be room for.
  std::vector<Ball_handle_3> handles() const;
  std::optional<Ball_handle_3> handle_at(const QPointF& pixel) const;
  bool is_resizing() const { return handle_.has_value(); }
  const QPointF& pressed() const { return pressed_; }
  /// Whether the mouse has moved since the press so far that it is no click.
  bool is_drag(const QMouseEvent& event) const;

 private:
  void resize_to(const QPointF& pixel);

  Editor_3& editor_;
  Viewer_3& viewer_;
  Aim_3 aim_;
  QPointF pressed_;
  std::optional<Ball_handle_3> handle_;  ///< that is being dragged

  struct Marks {
    Inputs inputs;
    Selection_3 selection;
    std::vector<Scene_layer> layers;
  };
  mutable std::optional<Marks> marks_;  ///< the last answer of overlay()
};

/// The left button is the camera's.
class Turn_tool_3 : public Tool_3 {
  Q_OBJECT
 public:
  using Tool_3::Tool_3;
  QString hint(const QPointF&) override;
  Qt::CursorShape cursor(const QPointF&) override { return Qt::ArrowCursor; }

 protected:
  bool press_left(const QMouseEvent&) override { return false; }
};

/// Click selects; drag on something moves the selection, on a handle resizes it, elsewhere turns the scene; drag with
/// Shift or Ctrl from where nothing is draws a rectangle, and where the hands of the preset turn with another button,
/// every drag from there.
class Select_tool_3 : public Tool_3 {
  Q_OBJECT
 public:
  using Tool_3::Tool_3;
  QString hint(const QPointF& pixel) override;
  Qt::CursorShape cursor(const QPointF& pixel) override;
  bool cancel() override;
  void paint(QPainter& painter) const override;

 protected:
  bool press_left(const QMouseEvent& event) override;
  void drag_left(const QMouseEvent& event) override;
  void release_left(const QMouseEvent& event) override;
  bool uses_handles() const override { return true; }

 private:
  enum class State { idle, pressed, turning, moving, boxing };
  /// Also without Shift or Ctrl.
  bool draws_rectangles() const;
  Point_3 shift_to(const QMouseEvent& event);

  State state_ = State::idle;
  QRectF rectangle_;
  Selection_3 before_;  ///< the selection at the press
  std::optional<Aim_3::Target> target_;
  bool deselects_on_release_ = false;
};

/// Every click adds a point or a ball, a drag turns the scene; a drag on a handle resizes the new ball.
class Add_tool_3 : public Tool_3 {
  Q_OBJECT
 public:
  enum class Kind { point, ball };
  Add_tool_3(Kind kind, Editor_3& editor, Viewer_3& viewer) : Tool_3(editor, viewer), kind_(kind) {}
  QString hint(const QPointF& pixel) override;
  Qt::CursorShape cursor(const QPointF& pixel) override;
  void hover(const QPointF& pixel) override;
  void leave() override;
  std::vector<Scene_layer> overlay() const override;

 protected:
  bool press_left(const QMouseEvent& event) override;
  void release_left(const QMouseEvent& event) override;
  bool uses_handles() const override { return kind_ == Kind::ball; }

 private:
  void show_ghost(const std::optional<Point_3>& place);

  Kind kind_;
  bool is_pressed_ = false;
  std::shared_ptr<const Primitive_set> ghost_;  ///< what a click would add
};

}  // namespace mesecina
