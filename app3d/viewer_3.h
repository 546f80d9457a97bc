// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGLViewer/qglviewer.h>

#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "app3d/viewer_tool_3.h"
#include "layers/gl_renderer_3.h"

namespace mesecina {

/// The canvas of space: orbit, pan and zoom by libQGLViewer's camera, pictures and picking by our renderer.
class Viewer_3 : public QGLViewer {
  Q_OBJECT
 public:
  /// `is_software`: OpenGL draws without a graphics card. Then edges become smooth only when the view rests.
  explicit Viewer_3(bool is_software, QWidget* parent = nullptr);
  ~Viewer_3() override;

  void set_scene(Scene scene);
  const Scene& scene() const { return scene_; }
  /// Drawn above the scene; cannot be picked.
  void set_overlay(std::vector<Scene_layer> overlay);
  /// Gets the mouse first from now on; null for none. Must live until another is set.
  void set_tool(Viewer_tool_3* tool);
  /// What is seen of another scene than the shown one, from the same view. Costs a picture.
  Id_picture ids_of(const Scene& scene);

  View_3 view() const;
  void set_view(const View_3& view);
  void set_cutting_plane(const std::optional<Cutting_plane_3>& plane);
  /// Shows the whole box from where it is seen now.
  void fit(const Box& box);
  /// Shows the whole scene from this direction, which points towards the viewer.
  void look_from(const Point_3& direction, const Point_3& up);
  void set_projection(Camera_3::Projection projection);
  /// Larger about the middle of the picture.
  void zoom(double factor);

  /// What is seen at this pixel, in logical pixels from the upper left corner, or at most `tolerance` beside it.
  std::optional<Id_picture::Hit> pick(const QPointF& pixel, double tolerance);

  /// Draws at once, as smooth as it can.
  QImage grab_picture();
  /// "OpenGL 4.5 (llvmpipe ...)"
  QString description();
  std::size_t uploaded_bytes() const { return renderer_ ? renderer_->uploaded_bytes() : 0; }

 Q_SIGNALS:
  void view_changed();
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

  Scene scene_;
  std::vector<Scene_layer> overlay_;
  Viewer_tool_3* tool_ = nullptr;
  bool is_tool_dragging_ = false;
  std::optional<Cutting_plane_3> cutting_plane_;
  bool is_software_ = false;
  bool has_failed_ = false;
  bool is_resting_ = true;
  QTimer rest_;
  QTimer pivot_time_;
  std::optional<Scene_layer> pivot_;
  std::unique_ptr<Gl_renderer_3> renderer_;
  Id_picture ids_;
  std::optional<View_3> ids_view_;  ///< of which the ids are; none: they are outdated
};

}  // namespace mesecina
