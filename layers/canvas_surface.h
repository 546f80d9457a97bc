// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QOpenGLWidget>
#include <QPixmap>
#include <QString>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/style.h"
#include "layers/gl_renderer_2.h"

class QOpenGLFramebufferObject;

namespace mesecina {

/// What a Canvas_2 shows.
struct Canvas_content {
  Scene scene;
  std::vector<Scene_layer> overlay;
  std::optional<QRectF> rubber_band;
  QString hint;
  View_2 view;
};

/// Per pixel, that the edges of filled polygons are smooth.
constexpr int samples_for_fills = 4;

/// What a first context tells of the OpenGL there is.
struct Opengl_probe {
  QString reason;            ///< why there can be no QOpenGLWidget with OpenGL 3.3 here; empty when there can
  bool is_software = false;  ///< drawn by the processor, where every sample of a pixel costs time
};
/// Takes some milliseconds.
Opengl_probe probe_opengl();
/// Whether the GL_RENDERER of this name draws without a graphics card.
bool is_software_renderer(const QByteArray& name);

/// What stands on top of a scene whatever draws it: colour bars, rubber band, hint. `size` in logical pixels.
void paint_foreground(QPainter& painter, const Canvas_content& content, const QSizeF& size, const QPalette& palette);

/// Draws a Canvas_content, which must outlive it.
class Canvas_surface {
 public:
  virtual ~Canvas_surface() = default;
  virtual QWidget& widget() = 0;
  /// Scene or overlay are others than before; a changed view, rubber band or hint needs only widget().update().
  virtual void content_changed() = 0;
  virtual QImage grab_picture() = 0;
  virtual QString description() const = 0;
  virtual std::size_t uploaded_bytes() const = 0;
};

class Gl_surface_2 : public QOpenGLWidget, public Canvas_surface {
 public:
  /// `fail` is called, at most once and perhaps while painting, when OpenGL turns out not to do.
  /// With `samples` per pixel. Only the edges of filled polygons need several; where there is one, scenes that have
  /// such polygons are drawn aside.
  Gl_surface_2(const Canvas_content& content, int samples, std::function<void(QString)> fail, QWidget* parent);
  ~Gl_surface_2() override;

  QWidget& widget() override { return *this; }
  void content_changed() override { update(); }
  QImage grab_picture() override;
  QString description() const override;
  std::size_t uploaded_bytes() const override;

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void free_renderer();
  void draw_scene(const QSize& pixels, double ratio);

  const Canvas_content& content_;
  std::function<void(QString)> fail_;
  std::unique_ptr<Gl_renderer_2> renderer_;
  std::unique_ptr<QOpenGLFramebufferObject> aside_;  ///< with several samples per pixel; null until it is needed
  std::size_t uploaded_earlier_ = 0;
};

/// Keeps a picture of large scenes: while the view moves, that is shown in its place, and painted anew when it rests.
class Painter_surface_2 : public QWidget, public Canvas_surface {
 public:
  Painter_surface_2(const Canvas_content& content, QString reason, QWidget* parent);

  QWidget& widget() override { return *this; }
  void content_changed() override;
  QImage grab_picture() override;
  QString description() const override;
  std::size_t uploaded_bytes() const override { return 0; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_picture();

  const Canvas_content& content_;
  QString reason_;
  QPixmap picture_;  ///< of scene and overlay; null when they have changed
  View_2 picture_view_;
  View_2 moving_view_;  ///< for which the picture was last shown in its place
  QTimer rest_;
  bool exact_ = false;  ///< the next painting must be exact
};

}  // namespace mesecina
