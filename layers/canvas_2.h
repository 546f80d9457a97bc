// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "core/style.h"

namespace mesecina {

/// A mouse event on the canvas, in logical pixels and in the plane.
struct Canvas_event {
  QPointF pixel;
  Point_2 position;
  Qt::MouseButton button = Qt::NoButton;
  Qt::MouseButtons buttons;
  Qt::KeyboardModifiers modifiers;
};

/// What does something with the mouse on the canvas (select, insert, spray, ...). Navigation is the canvas's own.
/// Each returns whether it used the event.
class Canvas_tool {
 public:
  virtual ~Canvas_tool() = default;
  virtual bool press(const Canvas_event&) { return false; }
  virtual bool move(const Canvas_event&) { return false; }  ///< also without a button: hover
  virtual bool release(const Canvas_event&) { return false; }
  virtual bool double_click(const Canvas_event&) { return false; }
  virtual void leave() {}
};

/// The planar view: draws a Scene, pans (middle drag, Space + left drag), zooms to the cursor (wheel, pinch), and hands
/// all else to its tool. Drawn by OpenGL 3.3 where there is one, else by QPainter; both look the same. Where OpenGL has
/// no graphics card, each scene is painted by the one of the two that paints it sooner (see Software_pictures).
class Canvas_2 : public QWidget {
  Q_OBJECT
 public:
  enum class Backend { automatic, opengl, painter };  ///< opengl: also where there is no graphics card
  explicit Canvas_2(Backend backend = Backend::automatic, QWidget* parent = nullptr);
  ~Canvas_2() override;

  /// Layers whose Primitive_set is the one of the last scene are not uploaded again.
  void set_scene(Scene scene);
  const Scene& scene() const;
  /// Drawn above the scene, outside of pictures: selection, highlight of the hovered element and its dual.
  void set_overlay(std::vector<Scene_layer> overlay);
  /// A selection rectangle in pixels; nullopt for none.
  void set_rubber_band(std::optional<QRectF> rectangle);
  /// Shown in the middle of an empty canvas.
  void set_hint(const QString& text);

  const View_2& view() const;
  /// Remembers the old view for previous_view unless it is a small step of the same gesture.
  void set_view(const View_2& view);
  /// Shows all of the box, also when the canvas gets another size, until the view is moved.
  void fit(const Box& box);
  void previous_view();
  void zoom(double factor);  ///< about the middle

  /// Not owned; null for none.
  void set_tool(Canvas_tool* tool);
  /// "OpenGL 4.5 (name)", "QPainter, OpenGL in software: name" or "QPainter (no OpenGL: reason)".
  QString backend_name() const;
  /// In the window: not for software.
  bool uses_opengl() const;
  /// Bytes sent to the graphics card since start; for tests: a pan sends none.
  std::size_t uploaded_bytes() const;
  /// Pixels of what is on screen, in device pixels.
  QImage grab_picture();

 Q_SIGNALS:
  void view_changed(const View_2& view);
  void backend_failed(const QString& reason);

 protected:
  bool event(QEvent* event) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mesecina
