// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/canvas_surface.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <algorithm>

#include "layers/canvas_2.h"
#include "layers/painter_canvas.h"
#include "layers/software_pictures.h"

namespace mesecina {

namespace {

/// Scenes with more elements are not painted at every step of a pan or zoom.
constexpr std::size_t many_elements = 20000;
constexpr std::size_t many_elements_for_opengl = 40000;
/// Scenes with more elements take QPainter long enough to be felt.
constexpr std::size_t many_elements_to_wait_for = 50000;
constexpr int rest_milliseconds = 120;

bool is_empty(const Canvas_content& content) {
  for (const Scene_layer& layer : content.scene.layers)
    if (layer.style.visible && layer.primitives && !layer.primitives->is_empty()) return false;
  return true;
}

std::size_t element_count(const Canvas_content& content) {
  std::size_t count = 0;
  for (const Scene_layer& layer : content.scene.layers)
    if (layer.style.visible && layer.primitives) count += layer.primitives->element_count();
  return count;
}

}  // namespace

QSurfaceFormat canvas_format(int samples) {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setSamples(samples);
  format.setStencilBufferSize(8);
  format.setDepthBufferSize(24);
  return format;
}

bool is_software_renderer(const QByteArray& name) {
  const QByteArray lower = name.toLower();
  return lower.contains("llvmpipe") || lower.contains("softpipe") || lower.contains("swiftshader");
}

Opengl_probe probe_opengl() {
  QOffscreenSurface surface;
  QOpenGLContext context;
  context.setFormat(canvas_format(0));
  if (!context.create()) return {Canvas_2::tr("no OpenGL context can be made"), false, {}};
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface))
    return {Canvas_2::tr("the OpenGL context cannot be used"), false, {}};
  const auto version = context.format().version();
  constexpr unsigned renderer = 0x1F01;  // GL_RENDERER
  const auto* name = reinterpret_cast<const char*>(context.functions()->glGetString(renderer));
  const QByteArray drawer(name ? name : "");
  context.doneCurrent();
  if (context.isOpenGLES()) return {Canvas_2::tr("there is only OpenGL ES"), false, {}};
  if (version < qMakePair(3, 3))
    return {Canvas_2::tr("OpenGL is %1.%2, 3.3 is needed").arg(version.first).arg(version.second), false, {}};
  return {{}, is_software_renderer(drawer), QString::fromUtf8(drawer)};
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

Picture_rest::Picture_rest(QWidget& widget) {
  timer.setSingleShot(true);
  timer.setInterval(rest_milliseconds);
  QObject::connect(&timer, &QTimer::timeout, &widget, [this, &widget] {
    must_be_exact = true;
    widget.update();
  });
}

void Picture_rest::note(const View_2& shown) {
  must_be_exact = false;
  if (view == shown) {
    timer.stop();
  } else if (!timer.isActive() || moving != shown) {
    timer.start();
  }
  moving = shown;
}

Gl_surface_2::Gl_surface_2(const Canvas_content& content, std::function<void(QString)> fail, QWidget* parent)
    : QOpenGLWidget(parent), content_(content), fail_(std::move(fail)) {
  setFormat(canvas_format(samples_for_fills));
}

Gl_surface_2::~Gl_surface_2() { free_renderer(); }

void Gl_surface_2::free_renderer() {
  if (!renderer_) return;
  makeCurrent();
  uploaded_earlier_ += renderer_->uploaded_bytes();
  renderer_.reset();
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
  const Gl_renderer_2::Frame frame{pixels.width(), pixels.height(), ratio};
  Scene scene = content_.scene;
  scene.transparent_background = false;
  renderer_->draw(scene, content_.overlay, content_.view, frame);
  QPainter painter(this);
  paint_foreground(painter, content_, size(), palette());
}

QImage Gl_surface_2::grab_picture() { return grabFramebuffer().convertToFormat(QImage::Format_RGB32); }

QString Gl_surface_2::description() const {
  return renderer_ ? QString::fromStdString(renderer_->description()) : QStringLiteral("OpenGL");
}

std::size_t Gl_surface_2::uploaded_bytes() const {
  return uploaded_earlier_ + (renderer_ ? renderer_->uploaded_bytes() : 0);
}

Painter_surface_2::Painter_surface_2(const Canvas_content& content, QString description,
                                     std::unique_ptr<Software_pictures> software, QWidget* parent)
    : QWidget(parent),
      content_(content),
      description_(std::move(description)),
      software_(std::move(software)),
      rest_(*this) {
  setAttribute(Qt::WA_OpaquePaintEvent);
}

Painter_surface_2::~Painter_surface_2() = default;

void Painter_surface_2::scene_changed() {
  ++scene_revision_;
  update();
}

bool Painter_surface_2::fits() const {
  return !picture_.isNull() && picture_revision_ == scene_revision_ &&
         picture_.devicePixelRatio() == devicePixelRatioF() &&
         picture_.size() == (QSizeF(size()) * devicePixelRatioF()).toSize();
}

Picture_order Painter_surface_2::order() const {
  return {content_.scene, content_.view, QSizeF(size()), devicePixelRatioF(), scene_revision_};
}

void Painter_surface_2::paint_picture() {
  const double ratio = devicePixelRatioF();
  const QSize pixels = (QSizeF(size()) * ratio).toSize();
  rest_.view = content_.view;
  picture_revision_ = scene_revision_;
  if (software_ && is_sooner_by_opengl(content_.scene)) {
    const QImage image = software_->paint(content_.scene, content_.view, {pixels.width(), pixels.height(), ratio});
    picture_ = QPixmap::fromImage(image);
    picture_.setDevicePixelRatio(ratio);
    if (!picture_.isNull()) return;
  }
  picture_ = QPixmap(pixels);
  picture_.setDevicePixelRatio(ratio);
  Scene scene = content_.scene;
  scene.transparent_background = false;
  QPainter painter(&picture_);
  paint_scene(painter, scene, content_.view, width(), height());
}

void Painter_surface_2::order_picture() {
  if (ordered_ && ordered_->revision == scene_revision_ && ordered_->view == content_.view &&
      ordered_->size == QSizeF(size()) && ordered_->pixel_ratio == devicePixelRatioF())
    return;
  if (!background_) {
    background_ = std::make_unique<Background_picture>(
        *this, [this](const QImage& picture, const Picture_order& order) { take_picture(picture, order); });
  }
  Picture_order wanted = order();
  ordered_ = wanted;
  ordered_->scene = {};
  background_->paint(std::move(wanted));
}

void Painter_surface_2::take_picture(const QImage& picture, const Picture_order& order) {
  if (order.revision < picture_revision_ || (fits() && rest_.view == content_.view)) return;
  picture_ = QPixmap::fromImage(picture);
  picture_revision_ = order.revision;
  rest_.view = order.view;
  update();
}

void Painter_surface_2::paintEvent(QPaintEvent*) {
  const bool is_current = fits() && rest_.view == content_.view;
  const bool is_by_opengl = software_ && is_sooner_by_opengl(content_.scene);
  const std::size_t count = element_count(content_);
  const std::size_t many = is_by_opengl ? many_elements_for_opengl : many_elements;
  const bool may_wait = fits() && !rest_.must_be_exact && count > many;
  if (is_current) {
    ordered_.reset();
  } else if (!may_wait) {
    if (count > many_elements_to_wait_for && !is_by_opengl && !is_grabbing_) {
      order_picture();
    } else {
      paint_picture();
    }
  }
  rest_.note(content_.view);
  QPainter painter(this);
  if (fits() && rest_.view == content_.view) {
    painter.drawPixmap(QPointF(), picture_);
  } else {
    const Color& ground = content_.scene.background;
    painter.fillRect(rect(), QColor(ground.red, ground.green, ground.blue));
    const double factor = content_.view.scale / rest_.view.scale;
    const Point_2 middle = content_.view.to_pixel(rest_.view.center, width(), height());
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QSizeF shown = picture_.deviceIndependentSize() * factor;
    painter.drawPixmap(QRectF(QPointF(middle.x - shown.width() / 2, middle.y - shown.height() / 2), shown), picture_,
                       QRectF(picture_.rect()));
  }
  Scene above;
  above.layers = content_.overlay;
  above.transparent_background = true;
  painter.save();
  paint_scene(painter, above, content_.view, width(), height());
  painter.restore();
  paint_foreground(painter, content_, size(), palette());
}

QImage Painter_surface_2::grab_picture() {
  rest_.must_be_exact = true;
  is_grabbing_ = true;
  const QImage picture = grab().toImage().convertToFormat(QImage::Format_RGB32);
  is_grabbing_ = false;
  return picture;
}

std::size_t Painter_surface_2::uploaded_bytes() const { return software_ ? software_->uploaded_bytes() : 0; }

}  // namespace mesecina
