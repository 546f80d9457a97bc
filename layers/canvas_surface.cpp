// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/canvas_surface.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QPainter>
#include <algorithm>

#include "layers/canvas_2.h"
#include "layers/painter_canvas.h"

namespace mesecina {

namespace {

/// Scenes with more elements are not painted at every step of a pan or zoom.
constexpr std::size_t many_elements = 20000;
constexpr int rest_milliseconds = 120;

QSurfaceFormat wanted_format(int samples) {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setSamples(samples);
  format.setStencilBufferSize(8);
  format.setDepthBufferSize(24);
  return format;
}

bool is_empty(const Canvas_content& content) {
  for (const Scene_layer& layer : content.scene.layers)
    if (layer.style.visible && layer.primitives && !layer.primitives->is_empty()) return false;
  return true;
}

bool has_filled_polygons(const std::vector<Scene_layer>& layers) {
  return std::any_of(layers.begin(), layers.end(), [](const Scene_layer& layer) {
    return layer.style.visible && layer.style.filled && layer.primitives &&
           !(layer.primitives->polygon_offsets.empty() && layer.primitives->triangles.empty());
  });
}

std::size_t element_count(const Canvas_content& content) {
  std::size_t count = 0;
  for (const Scene_layer& layer : content.scene.layers)
    if (layer.style.visible && layer.primitives) count += layer.primitives->element_count();
  return count;
}

}  // namespace

bool is_software_renderer(const QByteArray& name) {
  const QByteArray lower = name.toLower();
  return lower.contains("llvmpipe") || lower.contains("softpipe") || lower.contains("swiftshader");
}

Opengl_probe probe_opengl() {
  QOffscreenSurface surface;
  QOpenGLContext context;
  context.setFormat(wanted_format(0));
  if (!context.create()) return {Canvas_2::tr("no OpenGL context can be made")};
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) return {Canvas_2::tr("the OpenGL context cannot be used")};
  const auto version = context.format().version();
  constexpr unsigned renderer = 0x1F01;  // GL_RENDERER
  const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(renderer));
  const bool is_software = name && is_software_renderer(name);
  context.doneCurrent();
  if (context.isOpenGLES()) return {Canvas_2::tr("there is only OpenGL ES")};
  if (version < qMakePair(3, 3))
    return {Canvas_2::tr("OpenGL is %1.%2, 3.3 is needed").arg(version.first).arg(version.second)};
  return {{}, is_software};
}

void paint_foreground(QPainter& painter, const Canvas_content& content, const QSizeF& size, const QPalette& palette) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (is_empty(content) && !content.hint.isEmpty()) {
    const Color& ground = content.scene.background;
    const bool dark = 299 * ground.red + 587 * ground.green + 114 * ground.blue < 128000;
    painter.setPen(dark ? QColor(150, 150, 150) : QColor(120, 120, 120));
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() > 0 ? font.pointSizeF() * 1.25 : 13);
    painter.setFont(font);
    constexpr double margin = 24;
    painter.drawText(QRectF(QPointF(), size).adjusted(margin, margin, -margin, -margin),
                     Qt::AlignCenter | Qt::TextWordWrap, content.hint);
  }
  paint_color_bars(painter, content.scene, size.width(), size.height());
  if (content.rubber_band) {
    QColor color = palette.color(QPalette::Highlight);
    painter.setPen(QPen(color, 1));
    color.setAlpha(40);
    painter.setBrush(color);
    // Lines along the middle of pixels are sharp.
    const QRectF band = content.rubber_band->normalized();
    painter.drawRect(QRectF(band.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

Gl_surface_2::Gl_surface_2(const Canvas_content& content, int samples, std::function<void(QString)> fail,
                           QWidget* parent)
    : QOpenGLWidget(parent), content_(content), fail_(std::move(fail)) {
  setFormat(wanted_format(samples));
}

Gl_surface_2::~Gl_surface_2() { free_renderer(); }

void Gl_surface_2::free_renderer() {
  if (!renderer_) return;
  makeCurrent();
  uploaded_earlier_ += renderer_->uploaded_bytes();
  renderer_.reset();
  aside_.reset();
  doneCurrent();
}

void Gl_surface_2::initializeGL() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { free_renderer(); });
  try {
    renderer_ = std::make_unique<Gl_renderer_2>();
  } catch (const std::exception& error) {
    if (const auto fail = std::exchange(fail_, {})) fail(QString::fromUtf8(error.what()));
  }
}

void Gl_surface_2::paintGL() {
  if (!renderer_) return;
  const double ratio = devicePixelRatioF();
  const QSize pixels = (QSizeF(size()) * ratio).toSize();
  const bool is_aside =
      format().samples() < 2 && (has_filled_polygons(content_.scene.layers) || has_filled_polygons(content_.overlay));
  if (!is_aside) {
    draw_scene(pixels, ratio);
  } else {
    if (!aside_ || aside_->size() != pixels) {
      QOpenGLFramebufferObjectFormat form;
      form.setSamples(samples_for_fills);
      form.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
      aside_ = std::make_unique<QOpenGLFramebufferObject>(pixels, form);
    }
    aside_->bind();
    draw_scene(pixels, ratio);
    aside_->release();
    QOpenGLFramebufferObject::blitFramebuffer(nullptr, aside_.get());
  }
  QPainter painter(this);
  paint_foreground(painter, content_, size(), palette());
}

void Gl_surface_2::draw_scene(const QSize& pixels, double ratio) {
  Scene scene = content_.scene;
  scene.transparent_background = false;
  renderer_->draw(scene, content_.overlay, content_.view, {pixels.width(), pixels.height(), ratio});
}

QImage Gl_surface_2::grab_picture() { return grabFramebuffer().convertToFormat(QImage::Format_RGB32); }

QString Gl_surface_2::description() const {
  return renderer_ ? QString::fromStdString(renderer_->description()) : QStringLiteral("OpenGL");
}

std::size_t Gl_surface_2::uploaded_bytes() const {
  return uploaded_earlier_ + (renderer_ ? renderer_->uploaded_bytes() : 0);
}

Painter_surface_2::Painter_surface_2(const Canvas_content& content, QString reason, QWidget* parent)
    : QWidget(parent), content_(content), reason_(std::move(reason)) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  rest_.setSingleShot(true);
  rest_.setInterval(rest_milliseconds);
  connect(&rest_, &QTimer::timeout, this, [this] {
    exact_ = true;
    update();
  });
}

void Painter_surface_2::content_changed() {
  picture_ = {};
  update();
}

void Painter_surface_2::paint_picture() {
  const double ratio = devicePixelRatioF();
  picture_ = QPixmap((QSizeF(size()) * ratio).toSize());
  picture_.setDevicePixelRatio(ratio);
  picture_view_ = content_.view;
  Scene scene = content_.scene;
  scene.transparent_background = false;
  QPainter painter(&picture_);
  paint_scene(painter, scene, content_.view, width(), height());
  Scene above;
  above.layers = content_.overlay;
  above.transparent_background = true;
  paint_scene(painter, above, content_.view, width(), height());
}

void Painter_surface_2::paintEvent(QPaintEvent*) {
  const QSizeF picture_size = picture_.deviceIndependentSize();
  const bool fits = !picture_.isNull() && picture_.devicePixelRatio() == devicePixelRatioF() &&
                    (picture_size * devicePixelRatioF()).toSize() == (QSizeF(size()) * devicePixelRatioF()).toSize();
  const bool is_current = fits && picture_view_ == content_.view;
  const bool may_wait = fits && !exact_ && element_count(content_) > many_elements;
  if (!is_current && !may_wait) paint_picture();
  exact_ = false;
  QPainter painter(this);
  if (picture_view_ == content_.view) {
    rest_.stop();
    painter.drawPixmap(QPointF(), picture_);
  } else {
    if (!rest_.isActive() || moving_view_ != content_.view) rest_.start();
    moving_view_ = content_.view;
    const Color& ground = content_.scene.background;
    painter.fillRect(rect(), QColor(ground.red, ground.green, ground.blue));
    const double factor = content_.view.scale / picture_view_.scale;
    const Point_2 middle = content_.view.to_pixel(picture_view_.center, width(), height());
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QSizeF shown = QSizeF(size()) * factor;
    painter.drawPixmap(QRectF(QPointF(middle.x - shown.width() / 2, middle.y - shown.height() / 2), shown), picture_,
                       QRectF(picture_.rect()));
  }
  paint_foreground(painter, content_, size(), palette());
}

QImage Painter_surface_2::grab_picture() {
  exact_ = true;
  return grab().toImage().convertToFormat(QImage::Format_RGB32);
}

QString Painter_surface_2::description() const {
  return reason_.isEmpty() ? QStringLiteral("QPainter") : Canvas_2::tr("QPainter (no OpenGL: %1)").arg(reason_);
}

}  // namespace mesecina
