// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/viewer_3.h"

#include <QGLViewer/manipulatedCameraFrame.h>

#include <QCloseEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app3d/qglviewer_points.h"
#include "layers/painter_canvas.h"

namespace mesecina {

namespace {

constexpr int rest_milliseconds = 200;
constexpr int pivot_milliseconds = 1500;
constexpr int layers_while_moving = 4;
constexpr double zoom_per_notch = 1.2;

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
  clearShortcuts();
  set_mouse_preset(Mouse_preset::standard);
  set_free_turning(false);
  set_up(up_);
  // The view stays where the mouse leaves it.
  constexpr double never = 1e9;
  camera()->frame()->setSpinningSensitivity(never);
  connect(camera()->frame(), &qglviewer::ManipulatedCameraFrame::manipulated, this, [this] { moved(); });
  constexpr int frame_milliseconds = 15;
  flight_timer_.setInterval(frame_milliseconds);
  connect(&flight_timer_, &QTimer::timeout, this, &Viewer_3::fly);
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
  // Which would take the middle of the box for the pivot.
  const qglviewer::Vec pivot = camera()->pivotPoint();
  if (box.diagonal() > 0) setSceneBoundingBox(to_vec(box.lower), to_vec(box.upper));
  camera()->setPivotPoint(pivot);
  QOpenGLWidget::update();
}

void Viewer_3::set_overlay(std::vector<Scene_layer> overlay) {
  overlay_ = std::move(overlay);
  QOpenGLWidget::update();
}

void Viewer_3::set_tool(Viewer_tool_3* tool) {
  if (dragging_ == tool_) dragging_ = nullptr;
  tool_ = tool;
  QOpenGLWidget::update();
}

void Viewer_3::set_handle(Viewer_tool_3* handle) {
  if (dragging_ == handle_) dragging_ = nullptr;
  handle_ = handle;
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
  if (!is_resting_) {
    here.most_translucent_layers = layers_while_moving;
    if (is_software_) here.coarseness = pace_.coarseness();
  }
  std::vector<Scene_layer> above = overlay_;
  if (pivot_) above.push_back(*pivot_);
  for (const Viewer_tool_3* tool : {handle_, tool_})
    if (tool) std::ranges::move(tool->overlay(), std::back_inserter(above));
  Scene shown = scene_;
  shown.transparent_background = false;
  QElapsedTimer time;
  time.start();
  renderer_->draw(shown, above, view(), here);
  if (!is_software_) return;
  context()->functions()->glFinish();
  // As many pixels as samples: what is smooth tells of pictures that are not.
  constexpr double seconds_per_nanosecond = 1e-9;
  pace_.took(seconds_per_nanosecond * static_cast<double>(time.nsecsElapsed()) / (samples * samples), here.coarseness);
}

void Viewer_3::paintGL() {
  QGLViewer::paintGL();
  // A painter on the widget itself would miss the picture when the whole window is grabbed.
  QOpenGLPaintDevice device((QSizeF(size()) * devicePixelRatioF()).toSize());
  device.setDevicePixelRatio(devicePixelRatioF());
  QPainter painter(&device);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Viewer_tool_3* tool : {handle_, tool_})
    if (tool) tool->paint(painter);
  paint_marks(painter);
  paint_color_bars(painter, scene_, width(), height());
}

QPointF Viewer_3::corner_of_marks() const {
  constexpr double margin = 8;
  const double below = below_marks_ && below_marks_->isVisible() ? height() - below_marks_->y() : 0;
  return {margin, height() - below - margin};
}

Axis_gizmo Viewer_3::gizmo() const {
  return {view().camera, corner_of_marks() + QPointF(Axis_gizmo::size, -Axis_gizmo::size) / 2};
}

Scale_bar Viewer_3::scale() const {
  constexpr double most_pixels = 140;
  return scale_bar(std::max(1, height()) / view().camera.height_at_target(), most_pixels);
}

void Viewer_3::paint_marks(QPainter& painter) const {
  painter.setFont(font());
  if (has_gizmo_) gizmo().paint(painter, scene_.background, hovered_axis_);
  if (!has_scale_bar_) return;
  constexpr double lift = 4;
  const bool is_exact = view().camera.projection == Camera_3::Projection::orthographic;
  const double beside = has_gizmo_ ? Axis_gizmo::size + 2 * lift : 0;
  paint_scale_bar(painter, scale(), is_exact, corner_of_marks() + QPointF(beside, -lift), scene_.background);
}

void Viewer_3::draw() {
  constexpr int smooth = 2;
  const bool is_smooth = !is_software_ || (is_resting_ && pace_.affords(smooth * smooth));
  paint(is_smooth ? smooth : 1);
}

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

/// The first of handle and tool that takes what is offered; null for none.
Viewer_tool_3* Viewer_3::taker(const std::function<bool(Viewer_tool_3&)>& offer) const {
  for (Viewer_tool_3* tool : {handle_, tool_})
    if (tool && offer(*tool)) return tool;
  return nullptr;
}

void Viewer_3::mousePressEvent(QMouseEvent* event) {
  Q_EMIT left();
  if (dragging_) return;
  const auto axis = has_gizmo_ && event->button() == Qt::LeftButton ? gizmo().direction_at(event->position())
                                                                    : std::optional<Point_3>();
  if (axis) {
    constexpr double almost = 0.999;
    const bool is_seen_from_there = dot(destination().camera.axes().back, *axis) > almost;
    look_from((is_seen_from_there ? -1.0 : 1.0) * *axis);
    return;
  }
  dragging_ = taker([&](Viewer_tool_3& tool) { return tool.press(*event); });
  if (dragging_) return;
  Q_EMIT camera_taken();
  stop_flight();
  if (!before_gesture_) before_gesture_ = view();
  QGLViewer::mousePressEvent(event);
}

void Viewer_3::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() == Qt::NoButton) {
    const auto axis = has_gizmo_ ? gizmo().direction_at(event->position()) : std::optional<Point_3>();
    if (std::exchange(hovered_axis_, axis) != axis) QOpenGLWidget::update();
    Q_EMIT hovered(event->position());
  } else if (dragging_) {
    dragging_->drag(*event);
  } else {
    QGLViewer::mouseMoveEvent(event);
  }
}

void Viewer_3::mouseReleaseEvent(QMouseEvent* event) {
  if (Viewer_tool_3* tool = std::exchange(dragging_, nullptr)) {
    tool->release(*event);
    return;
  }
  QGLViewer::mouseReleaseEvent(event);
  if (tool_) tool_->release(*event);
  if (event->buttons() != Qt::NoButton) return;
  if (before_gesture_ && !is_flying() && !is_nearly_equal(*before_gesture_, view()))
    history_.remember(*before_gesture_);
  before_gesture_.reset();
}

void Viewer_3::mouseDoubleClickEvent(QMouseEvent* event) {
  // The second of two quick clicks.
  if (has_gizmo_ && gizmo().direction_at(event->position())) return;
  dragging_ = taker([&](Viewer_tool_3& tool) { return tool.double_click(*event); });
  if (dragging_ || event->button() != Qt::LeftButton) return;
  if (const auto hit = pick(event->position(), 0)) {
    stop_flight();
    camera()->setPivotPoint(to_vec(hit->place));
    show_pivot();
  }
}

void Viewer_3::wheelEvent(QWheelEvent* event) {
  event->accept();
  if (taker([&](Viewer_tool_3& tool) { return tool.wheel(*event); })) return;
  constexpr double eighths_per_notch = 120;
  const double notches = event->angleDelta().y() / eighths_per_notch;
  if (notches == 0) return;
  remember_step();
  zoom_about(place_under(event->position()), std::pow(zoom_per_notch, notches));
}

void Viewer_3::leaveEvent(QEvent* event) {
  QGLViewer::leaveEvent(event);
  hovered_axis_.reset();
  Q_EMIT left();
}

// Keys belong to the actions of the window, and what is kept between runs to its preferences.
void Viewer_3::keyPressEvent(QKeyEvent* event) { event->ignore(); }
void Viewer_3::keyReleaseEvent(QKeyEvent* event) { event->ignore(); }
void Viewer_3::closeEvent(QCloseEvent* event) { event->accept(); }

QImage Viewer_3::grab_picture() {
  is_resting_ = true;
  // With smooth edges, however long that takes.
  pace_ = {};
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
