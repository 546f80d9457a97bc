// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLViewer/qglviewer.h>

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app3d/mouse_preset_3.h"
#include "app3d/view_history_3.h"
#include "app3d/view_marks_3.h"
#include "app3d/viewer_tool_3.h"
#include "layers/frame_pace.h"
#include "layers/gl_renderer_3.h"

namespace mesecina {

/// The canvas of space: orbit, pan and zoom by libQGLViewer's camera, pictures and picking by our renderer.
class Viewer_3 : public QGLViewer {
  Q_OBJECT
 public:
  /// `is_software`: OpenGL draws without a graphics card. Then edges become smooth only when the view rests,
  /// and pictures coarser while it moves if they take long.
  explicit Viewer_3(bool is_software, QWidget* parent = nullptr);
  ~Viewer_3() override;

  void set_scene(Scene scene);
  const Scene& scene() const { return scene_; }
  /// Drawn above the scene; cannot be picked.
  void set_overlay(std::vector<Scene_layer> overlay);
  /// Gets the mouse first from now on; null for none. Must live until another is set.
  void set_tool(Viewer_tool_3* tool);
  /// Gets the mouse before the tool; null for none. Must live until another is set.
  void set_handle(Viewer_tool_3* handle);
  /// What is seen of another scene than the shown one, from the same view. Costs a picture.
  Id_picture ids_of(const Scene& scene);

  View_3 view() const;
  /// Where a flight goes; else view().
  View_3 destination() const;
  /// At once. One cannot go back from there.
  void set_view(const View_3& view);
  /// By a flight; the cutting plane is there at once. previous_view() leads back.
  void go_to(const View_3& view);
  /// To where the view was before the last gesture or jump; does nothing when there is none.
  void previous_view();
  /// Something that will move the view without go_to() begins: previous_view() leads to before it.
  void remember_view();
  /// As remember_view(), but steps that follow each other within half a second are one. Takes the camera.
  void remember_step();
  /// Milliseconds that a flight takes; 0: there are none.
  void set_flight_time(int milliseconds) { flight_time_ = milliseconds; }
  bool is_flying() const { return flight_timer_.isActive(); }
  /// At once. One cannot go back from there, unless remember_view() was called before.
  void set_cutting_plane(const std::optional<Cutting_plane_3>& plane);
  /// Shows the whole box from where it is seen now, by go_to().
  void fit(const Box& box);
  /// Shows the whole scene from this direction, which points towards the viewer, by go_to().
  void look_from(const Point_3& direction, const Point_3& up);
  /// The same, with what points upwards in the scene upwards, or as standard views have it when one looks along that.
  void look_from(const Point_3& direction);
  /// By go_to().
  void set_projection(Camera_3::Projection projection);
  /// At once. Larger about the middle of the picture.
  void zoom(double factor);

  /// The direction about which the scene turns: (0, 1, 0) or (0, 0, 1).
  void set_up(const Point_3& up);
  const Point_3& up() const { return up_; }
  /// Turns about any direction, like a ball under the mouse; else about up(), like a turntable.
  void set_free_turning(bool is_free);
  void set_mouse_preset(Mouse_preset preset);
  Mouse_preset mouse_preset() const { return mouse_preset_; }
  /// What is painted over the scene.
  void set_marks(bool has_gizmo, bool has_scale_bar);
  /// Marks stay above this child widget while it is visible.
  void keep_marks_above(QWidget* widget) { below_marks_ = widget; }
  Axis_gizmo gizmo() const;
  /// Of the scene at the pivot, in logical pixels.
  Scale_bar scale() const;

  /// What is seen at this pixel, in logical pixels from the upper left corner, or at most `tolerance` beside it.
  std::optional<Id_picture::Hit> pick(const QPointF& pixel, double tolerance);

  /// Draws at once, as smooth as it can.
  QImage grab_picture();
  /// "OpenGL 4.5 (llvmpipe ...)"
  QString description();
  std::size_t uploaded_bytes() const { return renderer_ ? renderer_->uploaded_bytes() : 0; }

 Q_SIGNALS:
  void view_changed();
  /// Somebody takes the camera: what moves it should stop.
  void camera_taken();
  /// The mouse moves without a button.
  void hovered(const QPointF& pixel);
  void left();
  /// OpenGL turned out not to do. Said at most once.
  void failed(const QString& reason);

 protected:
  void init() override;
  void paintGL() override;
  void draw() override;
  void fastDraw() override;
  void postDraw() override {}
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  Frame_3 frame() const;
  void paint(int samples);
  void free_renderer();
  void set_camera(const Camera_3& camera);
  /// So that the place under this pixel stays there.
  void zoom_about(const Point_3& place, double factor);
  Point_3 place_under(const QPointF& pixel);
  void show_pivot();
  void moved();
  void fly_to(const View_3& view);
  void fly();
  void stop_flight();
  Viewer_tool_3* taker(const std::function<bool(Viewer_tool_3&)>& offer) const;
  QPointF corner_of_marks() const;
  void paint_marks(QPainter& painter) const;

  Scene scene_;
  std::vector<Scene_layer> overlay_;
  Viewer_tool_3* handle_ = nullptr;
  Viewer_tool_3* tool_ = nullptr;
  Viewer_tool_3* dragging_ = nullptr;  ///< what took the button
  std::optional<Cutting_plane_3> cutting_plane_;
  bool is_software_ = false;
  bool has_failed_ = false;
  bool is_resting_ = true;
  Frame_pace pace_;
  QTimer rest_;
  QTimer pivot_time_;
  std::optional<Scene_layer> pivot_;
  std::unique_ptr<Gl_renderer_3> renderer_;
  Mouse_preset mouse_preset_ = Mouse_preset::standard;
  Point_3 up_{0, 1, 0};
  bool has_gizmo_ = true;
  bool has_scale_bar_ = true;
  std::optional<Point_3> hovered_axis_;
  QPointer<QWidget> below_marks_;
  View_history_3 history_;
  std::optional<View_3> before_gesture_;
  QElapsedTimer last_step_;
  struct Flight {
    std::array<Camera_3, 2> ends;
    QElapsedTimer time;
  };
  Flight flight_;
  QTimer flight_timer_;
  int flight_time_ = 250;
  Id_picture ids_;
  std::optional<View_3> ids_view_;  ///< of which the ids are; none: they are outdated
};

}  // namespace mesecina
