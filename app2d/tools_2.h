// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "app2d/editor_2.h"
#include "layers/canvas_2.h"

namespace mesecina {

/// What is half done.
struct Preview_2 {
  std::vector<Point_2> line;
  std::optional<Disk_2> disk;
  QString readout;  ///< a number that is being chosen, shown beside the cursor
  bool is_empty() const { return line.empty() && !disk && readout.isEmpty(); }
};

/// "radius 12.5"
QString radius_readout(double radius);

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
  virtual Preview_2 preview() const { return {}; }
  /// True for a tool that resizes selected disks by their handles; they are shown only then.
  virtual bool uses_handles() const { return false; }
  /// Whether the wheel, turned by so many degrees, does something else than zoom here.
  virtual bool wheel(const Canvas_event&, double) { return false; }

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

/// Click selects, drag on something moves the selection, drag on a handle of a disk resizes, drag elsewhere draws a
/// box, double click adds a point. The wheel over a selected disk resizes the selected ones.
class Select_tool_2 : public Tool_2 {
  Q_OBJECT
 public:
  using Tool_2::Tool_2;
  QString hint(const Canvas_event& event) const override;
  Qt::CursorShape cursor(const Canvas_event& event) const override;
  bool cancel() override;
  Preview_2 preview() const override;
  bool uses_handles() const override { return true; }
  bool wheel(const Canvas_event& event, double degrees) override;
  bool release(const Canvas_event& event) override;
  bool double_click(const Canvas_event& event) override;

 protected:
  bool press_left(const Canvas_event& event) override;
  void drag(const Canvas_event& event) override;

 private:
  enum class State { idle, pressed, moving, resizing, boxing };
  Selection_2 with_box(const Canvas_event& event) const;

  State state_ = State::idle;
  Canvas_event start_;
  Selection_2 before_;  ///< the selection at the press
  Selection_2 hit_;
  std::optional<Disk_handle_2> handle_;  ///< that was pressed
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

/// Places at equal distances along the way of the mouse.
class Spray_path_2 {
 public:
  void start(const Point_2& position) { last_ = position; }
  void stop() { last_.reset(); }
  /// Calls place(position) for each place passed on the way to `position`; nothing before start().
  void go_to(const Point_2& position, double step, const std::function<void(const Point_2&)>& place);

 private:
  std::optional<Point_2> last_;
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
  Spray_path_2 path_;
  int gesture_ = 0;
};

/// A drag from the center to the boundary draws a disk, a click one with the usual radius; a drag with Ctrl sprays such
/// disks. The wheel over the new disk resizes it.
class Disk_tool_2 : public Tool_2 {
  Q_OBJECT
 public:
  using Tool_2::Tool_2;
  QString hint(const Canvas_event& event) const override;
  Qt::CursorShape cursor(const Canvas_event&) const override { return Qt::CrossCursor; }
  bool cancel() override;
  Preview_2 preview() const override;
  bool wheel(const Canvas_event& event, double degrees) override;
  bool release(const Canvas_event& event) override;
  bool double_click(const Canvas_event& event) override { return press(event); }
  /// Of sprayed disks, from center to center, in logical pixels.
  void set_spacing(double pixels) { spacing_ = pixels; }

 protected:
  bool press_left(const Canvas_event& event) override;
  void drag(const Canvas_event& event) override;

 private:
  enum class State { idle, pressed, drawing, spraying };
  void spray(const Point_2& position);

  State state_ = State::idle;
  Canvas_event start_;
  Point_2 cursor_;
  double spacing_ = 12;
  Spray_path_2 path_;
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
  Preview_2 preview() const override;
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
