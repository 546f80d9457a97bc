// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>
#include <QOpenGLWidget>
#include <QPixmap>
#include <QString>
#include <QSurfaceFormat>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/style.h"
#include "layers/background_picture.h"
#include "layers/gl_renderer_2.h"

namespace mesecina {

class Software_pictures;

/// What a Canvas_2 shows.
struct Canvas_content {
  Scene scene;
  std::vector<Scene_layer> overlay;
  std::optional<QRectF> rubber_band;
  QString hint;
  View_2 view;
};

/// What a first context tells of the OpenGL there is.
struct Opengl_probe {
  QString reason;            ///< why there can be no QOpenGLWidget with OpenGL 3.3 here; empty when there can
  bool is_software = false;  ///< drawn by the processor, where every sample of a pixel costs time
  QString name;              ///< of what draws: "llvmpipe (LLVM 15.0.6, 256 bits)"
};
/// Takes some milliseconds.
Opengl_probe probe_opengl();
/// Whether the GL_RENDERER of this name draws without a graphics card.
bool is_software_renderer(const QByteArray& name);

/// Of contexts that a canvas draws by.
QSurfaceFormat canvas_format(int samples);
/// Per pixel, that the edges of filled polygons and loops of arcs are smooth.
inline constexpr int samples_for_fills = 4;

/// What stands on top of a scene whatever draws it: colour bars, rubber band, hint. `size` in logical pixels.
void paint_foreground(QPainter& painter, const Canvas_content& content, const QSizeF& size, const QPalette& palette);

/// Draws a Canvas_content, which must outlive it.
class Canvas_surface {
 public:
  virtual ~Canvas_surface() = default;
  virtual QWidget& widget() = 0;
  /// To be called when the scene is another; for all other changes widget().update() is enough.
  virtual void scene_changed() = 0;
  virtual QImage grab_picture() = 0;
  virtual QString description() const = 0;
  virtual std::size_t uploaded_bytes() const = 0;
};

/// Of which view a kept picture is, and when it is to be painted anew because the view has come to rest.
struct Picture_rest {
  View_2 view;    ///< of the picture
  View_2 moving;  ///< for which the picture was last shown in its place
  QTimer timer;
  bool must_be_exact = false;  ///< the next painting

  explicit Picture_rest(QWidget& widget);
  /// After each painting.
  void note(const View_2& shown);
};

class Gl_surface_2 : public QOpenGLWidget, public Canvas_surface {
 public:
  /// `fail` is called, at most once and perhaps while painting, when OpenGL turns out not to do.
  Gl_surface_2(const Canvas_content& content, std::function<void(QString)> fail, QWidget* parent);
  ~Gl_surface_2() override;

  QWidget& widget() override { return *this; }
  void scene_changed() override { update(); }
  QImage grab_picture() override;
  QString description() const override;
  std::size_t uploaded_bytes() const override;

 protected:
  void initializeGL() override;
  void paintGL() override;

 private:
  void free_renderer();

  const Canvas_content& content_;
  std::function<void(QString)> fail_;
  std::unique_ptr<Gl_renderer_2> renderer_;
  std::size_t uploaded_earlier_ = 0;
};

/// Keeps a picture of the scene: while the view of a large one moves, that is shown in its place, and painted anew when
/// it rests. Very large scenes are painted in the background, and the last picture is shown until then. Hovering and
/// selecting paint above it.
class Painter_surface_2 : public QWidget, public Canvas_surface {
 public:
  /// `description`: of how it draws. `software` (may be null) paints the pictures of scenes that is sooner for.
  Painter_surface_2(const Canvas_content& content, QString description, std::unique_ptr<Software_pictures> software,
                    QWidget* parent);
  ~Painter_surface_2() override;

  QWidget& widget() override { return *this; }
  void scene_changed() override;
  QImage grab_picture() override;
  QString description() const override { return description_; }
  std::size_t uploaded_bytes() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_picture();
  void order_picture();
  void take_picture(const QImage& picture, const Picture_order& order);
  /// The picture is that of the scene, in the size of the widget; perhaps of another view.
  bool fits() const;
  Picture_order order() const;

  const Canvas_content& content_;
  QString description_;
  std::unique_ptr<Software_pictures> software_;
  QPixmap picture_;                     ///< of a scene; null at first
  std::uint64_t scene_revision_ = 1;    ///< of the scene to be shown
  std::uint64_t picture_revision_ = 0;  ///< of the scene in the picture
  bool is_grabbing_ = false;
  std::optional<Picture_order> ordered_;  ///< the last one, without its scene
  Picture_rest rest_;
  std::unique_ptr<Background_picture> background_;  ///< null until there is a very large scene
};

}  // namespace mesecina
