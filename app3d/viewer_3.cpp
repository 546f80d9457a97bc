// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/viewer_3.h"

#include <QGLViewer/manipulatedCameraFrame.h>

#include <QCloseEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "layers/painter_canvas.h"

namespace mesecina {

namespace {

constexpr int rest_milliseconds = 200;
constexpr int pivot_milliseconds = 1500;
constexpr int layers_while_moving = 4;
constexpr double zoom_per_notch = 1.2;

qglviewer::Vec to_vec(const Point_3& p) { return {p.x, p.y, p.z}; }
Point_3 to_point(const qglviewer::Vec& v) { return {v.x, v.y, v.z}; }

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

Viewer_3::Viewer_3(bool is_software, QWidget* parent) : QGLViewer(parent), is_software_(is_software) {
  // libQGLViewer sets matrices as old OpenGL does.
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CompatibilityProfile);
  format.setOption(QSurfaceFormat::DeprecatedFunctions);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  setFormat(format);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  rest_.setSingleShot(true);
  rest_.setInterval(rest_milliseconds);
  connect(&rest_, &QTimer::timeout, this, [this] {
    is_resting_ = true;
    QOpenGLWidget::update();
  });
  pivot_time_.setSingleShot(true);
  pivot_time_.setInterval(pivot_milliseconds);
  connect(&pivot_time_, &QTimer::timeout, this, [this] {
    pivot_.reset();
    QOpenGLWidget::update();
  });
  clearMouseBindings();
  clearShortcuts();
  setMouseBinding(Qt::NoModifier, Qt::LeftButton, CAMERA, ROTATE);
  setMouseBinding(Qt::NoModifier, Qt::MiddleButton, CAMERA, TRANSLATE);
  setMouseBinding(Qt::ShiftModifier, Qt::LeftButton, CAMERA, TRANSLATE);
  camera()->frame()->setRotatesAroundUpVector(true);
  camera()->frame()->setSceneUpVector(qglviewer::Vec(0, 1, 0));
  // The view stays where the mouse leaves it.
  constexpr double never = 1e9;
  camera()->frame()->setSpinningSensitivity(never);
  connect(camera()->frame(), &qglviewer::ManipulatedCameraFrame::manipulated, this, [this] { moved(); });
}

Viewer_3::~Viewer_3() { free_renderer(); }

void Viewer_3::free_renderer() {
  if (!renderer_) return;
  makeCurrent();
  renderer_.reset();
  doneCurrent();
}

void Viewer_3::init() {
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { free_renderer(); });
  try {
    renderer_ = std::make_unique<Gl_renderer_3>();
  } catch (const std::exception& error) {
    if (!std::exchange(has_failed_, true)) Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

void Viewer_3::set_scene(Scene scene) {
  scene_ = std::move(scene);
  ids_view_.reset();
  const Box box = drawn_box(scene_);
  if (!box.is_empty()) setSceneBoundingBox(to_vec(box.lower), to_vec(box.upper));
  QOpenGLWidget::update();
}

void Viewer_3::set_overlay(std::vector<Scene_layer> overlay) {
  overlay_ = std::move(overlay);
  QOpenGLWidget::update();
}

void Viewer_3::set_tool(Viewer_tool_3* tool) {
  tool_ = tool;
  is_tool_dragging_ = false;
  QOpenGLWidget::update();
}

Id_picture Viewer_3::ids_of(const Scene& scene) {
  if (!renderer_) return {};
  makeCurrent();
  Id_picture ids = renderer_->ids(scene, view(), frame());
  doneCurrent();
  return ids;
}

void Viewer_3::set_cutting_plane(const std::optional<Cutting_plane_3>& plane) {
  cutting_plane_ = plane;
  moved();
}

View_3 Viewer_3::view() const {
  Camera_3 seen;
  seen.position = to_point(camera()->position());
  seen.up = to_point(camera()->upVector());
  // The middle of the picture at the distance of the pivot.
  const Point_3 ahead = to_point(camera()->viewDirection());
  const double away = std::abs(camera()->cameraCoordinatesOf(camera()->pivotPoint()).z);
  constexpr double least = 1e-9;
  seen.target = seen.position + std::max(away, least * std::max(1.0, camera()->sceneRadius())) * ahead;
  seen.field_of_view = camera()->fieldOfView() * 180 / std::numbers::pi;
  if (camera()->type() == qglviewer::Camera::ORTHOGRAPHIC) {
    seen.projection = Camera_3::Projection::orthographic;
    double half_width = 1;
    double half_height = 1;
    camera()->getOrthoWidthHeight(half_width, half_height);
    seen.height = 2 * half_height;
  } else {
    seen.height = seen.height_at_target();
  }
  return {seen, cutting_plane_};
}

void Viewer_3::set_camera(const Camera_3& seen) {
  qglviewer::Camera& own = *camera();
  const Camera_3::Axes axes = seen.axes();
  const bool is_orthographic = seen.projection == Camera_3::Projection::orthographic;
  own.setType(qglviewer::Camera::PERSPECTIVE);
  own.setFieldOfView(radians(seen.field_of_view));
  qglviewer::Quaternion turned;
  turned.setFromRotatedBasis(to_vec(axes.right), to_vec(axes.up), to_vec(axes.back));
  own.setOrientation(turned);
  Point_3 position = seen.position;
  if (is_orthographic) {
    // libQGLViewer shows as much without perspective as it would with it, at the pivot.
    const double shape = own.aspectRatio() < 1 ? own.aspectRatio() : 1;
    position = seen.target + (seen.height * shape / 2 / std::tan(own.fieldOfView() / 2)) * axes.back;
  }
  own.setPosition(to_vec(position));
  own.setPivotPoint(to_vec(seen.target));
  if (is_orthographic) own.setType(qglviewer::Camera::ORTHOGRAPHIC);
  moved();
}

void Viewer_3::set_view(const View_3& view) {
  cutting_plane_ = view.cutting_plane;
  set_camera(view.camera);
}

void Viewer_3::fit(const Box& box) {
  const Camera_3 seen = view().camera;
  set_camera(fit_camera(box, width(), height(), seen.axes().back, seen.up, seen.projection));
}

void Viewer_3::look_from(const Point_3& direction, const Point_3& up) {
  set_camera(fit_camera(drawn_box(scene_), width(), height(), direction, up, view().camera.projection));
}

void Viewer_3::set_projection(Camera_3::Projection projection) {
  Camera_3 seen = view().camera;
  if (seen.projection == projection) return;
  seen.projection = projection;
  if (projection == Camera_3::Projection::perspective)
    seen.position = seen.target + (seen.height / 2 / std::tan(radians(seen.field_of_view) / 2)) * seen.axes().back;
  set_camera(seen);
}

void Viewer_3::zoom_about(const Point_3& place, double factor) {
  Camera_3 seen = view().camera;
  const Camera_3::Axes axes = seen.axes();
  const Point_3 pivot = to_point(camera()->pivotPoint());
  if (seen.projection == Camera_3::Projection::orthographic) {
    // Along the direction of sight nothing moves.
    const Point_3 across = place - dot(place - seen.target, axes.back) * axes.back;
    seen.target = across + (1 / factor) * (seen.target - across);
    seen.height /= factor;
    set_camera(seen);
    camera()->setPivotPoint(to_vec(pivot));
    return;
  }
  const Point_3 position = place + (1 / factor) * (seen.position - place);
  // Never so near that nothing moves any more.
  constexpr double nearest = 1e-6;
  if (distance(position, place) < nearest * camera()->sceneRadius()) return;
  camera()->setPosition(to_vec(position));
  camera()->setPivotPoint(to_vec(pivot));
  moved();
}

void Viewer_3::zoom(double factor) { zoom_about(view().camera.target, factor); }

Point_3 Viewer_3::place_under(const QPointF& pixel) {
  if (const auto hit = pick(pixel, 0)) return hit->place;
  const Camera_3 seen = view().camera;
  const Camera_3::Axes axes = seen.axes();
  const double per_pixel = seen.height_at_target() / std::max(1, height());
  return seen.target + ((pixel.x() - width() / 2.0) * per_pixel) * axes.right -
         ((pixel.y() - height() / 2.0) * per_pixel) * axes.up;
}

std::optional<Id_picture::Hit> Viewer_3::pick(const QPointF& pixel, double tolerance) {
  if (!renderer_) return std::nullopt;
  const Frame_3 here = frame();
  const View_3 seen = view();
  if (ids_view_ != seen || ids_.width() != here.width || ids_.height() != here.height) {
    makeCurrent();
    ids_ = renderer_->ids(scene_, seen, here);
    doneCurrent();
    ids_view_ = seen;
  }
  const QPointF device = pixel * devicePixelRatioF();
  return ids_.find(static_cast<int>(std::floor(device.x())), static_cast<int>(std::floor(device.y())),
                   static_cast<int>(std::round(tolerance * devicePixelRatioF())));
}

Frame_3 Viewer_3::frame() const {
  const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
  Frame_3 frame;
  frame.width = std::max(1, pixels.width());
  frame.height = std::max(1, pixels.height());
  frame.pixel_ratio = devicePixelRatioF();
  return frame;
}

void Viewer_3::paint(int samples) {
  if (!renderer_) return;
  Frame_3 here = frame();
  here.samples = samples;
  if (!is_resting_) here.most_translucent_layers = layers_while_moving;
  std::vector<Scene_layer> above = overlay_;
  if (pivot_) above.push_back(*pivot_);
  if (tool_) std::ranges::move(tool_->overlay(), std::back_inserter(above));
  Scene shown = scene_;
  shown.transparent_background = false;
  renderer_->draw(shown, above, view(), here);
}

void Viewer_3::paintGL() {
  QGLViewer::paintGL();
  // A painter on the widget itself would miss the picture when the whole window is grabbed.
  QOpenGLPaintDevice device((QSizeF(size()) * devicePixelRatioF()).toSize());
  device.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&device);
  painter.setRenderHint(QPainter::Antialiasing);
  if (tool_) tool_->paint(painter);
  paint_color_bars(painter, scene_, width(), height());
}

void Viewer_3::draw() { paint(is_resting_ || !is_software_ ? 2 : 1); }

void Viewer_3::fastDraw() { draw(); }

void Viewer_3::moved() {
  is_resting_ = false;
  rest_.start();
  QOpenGLWidget::update();
  Q_EMIT view_changed();
}

void Viewer_3::show_pivot() {
  auto set = std::make_shared<Primitive_set>();
  set->dimension = 3;
  set->vertices.push_back(to_point(camera()->pivotPoint()));
  set->points.push_back(0);
  Style style;
  style.visible = true;
  style.sliced = false;
  style.color = {230, 60, 40};
  constexpr double size = 9;
  style.point_size = size;
  pivot_ = Scene_layer{"pivot", {}, std::move(set), {}, style};
  pivot_time_.start();
  QOpenGLWidget::update();
}

void Viewer_3::mousePressEvent(QMouseEvent* event) {
  Q_EMIT left();
  is_tool_dragging_ = is_tool_dragging_ || (tool_ && tool_->press(*event));
  if (!is_tool_dragging_) QGLViewer::mousePressEvent(event);
}

void Viewer_3::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) {
    Q_EMIT hovered(event->position());
    return;
  }
  if (is_tool_dragging_) {
    tool_->drag(*event);
  } else {
    QGLViewer::mouseMoveEvent(event);
  }
}

void Viewer_3::mouseReleaseEvent(QMouseEvent* event) {
  if (std::exchange(is_tool_dragging_, false)) {
    tool_->release(*event);
  } else {
    QGLViewer::mouseReleaseEvent(event);
  }
}

void Viewer_3::mouseDoubleClickEvent(QMouseEvent* event) {
  if (tool_ && tool_->double_click(*event)) {
    is_tool_dragging_ = true;
    return;
  }
  if (event->button() != Qt::LeftButton) return;
  if (const auto hit = pick(event->position(), 0)) {
    camera()->setPivotPoint(to_vec(hit->place));
    show_pivot();
  }
}

void Viewer_3::wheelEvent(QWheelEvent* event) {
  if (tool_ && tool_->wheel(*event)) {
    event->accept();
    return;
  }
  constexpr double eighths_per_notch = 120;
  const double notches = event->angleDelta().y() / eighths_per_notch;
  if (notches != 0) zoom_about(place_under(event->position()), std::pow(zoom_per_notch, notches));
  event->accept();
}

void Viewer_3::leaveEvent(QEvent* event) {
  QGLViewer::leaveEvent(event);
  Q_EMIT left();
}

// Keys belong to the actions of the window, and what is kept between runs to its preferences.
void Viewer_3::keyPressEvent(QKeyEvent* event) { event->ignore(); }
void Viewer_3::keyReleaseEvent(QKeyEvent* event) { event->ignore(); }
void Viewer_3::closeEvent(QCloseEvent* event) { event->accept(); }

QImage Viewer_3::grab_picture() {
  is_resting_ = true;
  return grabFramebuffer().convertToFormat(QImage::Format_RGB32);
}

QString Viewer_3::description() {
  if (!renderer_) return tr("no OpenGL");
  makeCurrent();
  const QString text = QString::fromStdString(renderer_->description());
  doneCurrent();
  return text;
}

}  // namespace mesecina
