// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>
#include <vector>

#include "app2d/editor_2.h"
#include "layers/canvas_2.h"

namespace mesecina {

/// One way to use the left button on the canvas. All of them open the menu with the right one.
class Tool_2 : public QObject, public Canvas_tool {
  Q_OBJECT
 public:
  explicit Tool_2(Editor_2& editor) : QObject(&editor), editor_(editor) {}

  /// What a click would do here.
  virtual QString hint(const Canvas_event& event) const = 0;
  virtual Qt::CursorShape cursor(const Canvas_event& event) const = 0;
  /// Esc: drops what is half done; false when nothing is.
  virtual bool cancel() { return false; }
  /// Enter: completes what is half done; false when nothing is.
  virtual bool complete() { return false; }
  /// A line that is being drawn; empty most of the time.
  virtual std::vector<Point_2> preview() const { return {}; }

  bool press(const Canvas_event& event) override;
  bool move(const Canvas_event& event) override;
  void leave() override { Q_EMIT left(); }

 Q_SIGNALS:
  void hovered(const mesecina::Canvas_event& event);
  void left();
  void preview_changed();

 protected:
  virtual bool press_left(const Canvas_event& event) = 0;
  virtual void drag(const Canvas_event&) {}
  Editor_2& editor() const { return editor_; }

 private:
  Editor_2& editor_;
};

/// Click selects, drag on something moves the selection, drag elsewhere draws a box, double click adds a point.
class Select_tool_2 : public Tool_2 {
  Q_OBJECT
 public:
  using Tool_2::Tool_2;
  QString hint(const Canvas_event& event) const override;
  Qt::CursorShape cursor(const Canvas_event& event) const override;
  bool cancel() override;
  bool release(const Canvas_event& event) override;
  bool double_click(const Canvas_event& event) override;

 protected:
  bool press_left(const Canvas_event& event) override;
  void drag(const Canvas_event& event) override;

 private:
  enum class State { idle, pressed, moving, boxing };
  Selection_2 with_box(const Canvas_event& event) const;

  State state_ = State::idle;
  Canvas_event start_;
  Selection_2 before_;  ///< the selection at the press
  Selection_2 hit_;
  bool deselects_on_release_ = false;
};

/// Every click adds a point.
class Insert_tool_2 : public Tool_2 {
  Q_OBJECT
 public:
  using Tool_2::Tool_2;
  QString hint(const Canvas_event& event) const override;
  Qt::CursorShape cursor(const Canvas_event&) const override { return Qt::CrossCursor; }
  bool double_click(const Canvas_event& event) override { return press(event); }

 protected:
  bool press_left(const Canvas_event& event) override;
};

/// Drawing with the mouse leaves points behind, no nearer to each other than the spacing.
class Spray_tool_2 : public Tool_2 {
  Q_OBJECT
 public:
  using Tool_2::Tool_2;
  QString hint(const Canvas_event& event) const override;
  Qt::CursorShape cursor(const Canvas_event&) const override { return Qt::CrossCursor; }
  bool release(const Canvas_event& event) override;
  bool double_click(const Canvas_event& event) override { return press(event); }
  /// In logical pixels.
  void set_spacing(double pixels) { spacing_ = pixels; }
  double spacing() const { return spacing_; }

 protected:
  bool press_left(const Canvas_event& event) override;
  void drag(const Canvas_event& event) override;

 private:
  double spacing_ = 12;
  std::optional<Point_2> last_;
  int gesture_ = 0;
};

/// Clicks set the vertices of a ring, a drag draws it freely; double click or Enter closes it.
class Outline_tool_2 : public Tool_2 {
  Q_OBJECT
 public:
  using Tool_2::Tool_2;
  QString hint(const Canvas_event& event) const override;
  Qt::CursorShape cursor(const Canvas_event&) const override { return Qt::CrossCursor; }
  bool cancel() override;
  bool complete() override;
  std::vector<Point_2> preview() const override;
  bool move(const Canvas_event& event) override;
  bool double_click(const Canvas_event& event) override;

 protected:
  bool press_left(const Canvas_event& event) override;
  void drag(const Canvas_event& event) override;

 private:
  void add(const Point_2& vertex, double least_distance);

  Ring_2 ring_;
  Point_2 cursor_;
};

/// Dragging moves the view.
class Pan_tool_2 : public Tool_2 {
  Q_OBJECT
 public:
  using Tool_2::Tool_2;
  QString hint(const Canvas_event& event) const override;
  Qt::CursorShape cursor(const Canvas_event& event) const override;

 protected:
  bool press_left(const Canvas_event& event) override;
  void drag(const Canvas_event& event) override;

 private:
  QPointF last_;
};

}  // namespace mesecina
