// SPDX-License-Identifier: GPL-3.0-or-later
#include <QGLViewer/manipulatedCameraFrame.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app3d/qglviewer_points.h"
#include "app3d/viewer_3.h"
#include "core/camera_path_3.h"

namespace mesecina {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

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
  // Which took the upward direction of the picture for that of the scene.
  own.frame()->setSceneUpVector(to_vec(up_));
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
  stop_flight();
  cutting_plane_ = view.cutting_plane;
  set_camera(view.camera);
}

View_3 Viewer_3::destination() const { return is_flying() ? View_3{flight_.ends[1], cutting_plane_} : view(); }

void Viewer_3::go_to(const View_3& view) {
  Q_EMIT camera_taken();
  if (!is_nearly_equal(destination(), view)) history_.remember(destination());
  fly_to(view);
}

void Viewer_3::previous_view() {
  Q_EMIT camera_taken();
  if (const auto before = history_.take(destination())) fly_to(*before);
}

void Viewer_3::remember_view() { history_.remember(destination()); }

void Viewer_3::remember_step() {
  Q_EMIT camera_taken();
  stop_flight();
  constexpr int pause_between_steps = 500;
  const bool goes_on = last_step_.isValid() && last_step_.elapsed() < pause_between_steps;
  last_step_.start();
  if (!goes_on) history_.remember(view());
}

void Viewer_3::fly_to(const View_3& view) {
  const bool is_seen = isVisible() && flight_time_ > 0;
  const Camera_3 from = this->view().camera;
  cutting_plane_ = view.cutting_plane;
  flight_timer_.stop();
  if (!is_seen || is_nearly_equal(from, view.camera)) {
    set_camera(view.camera);
    return;
  }
  flight_.ends = {from, view.camera};
  flight_.time.start();
  flight_timer_.start();
  moved();
}

void Viewer_3::fly() {
  const double part = static_cast<double>(flight_.time.elapsed()) / std::max(1, flight_time_);
  if (part >= 1) {
    flight_timer_.stop();
    set_camera(flight_.ends[1]);
  } else {
    // Starts and ends slowly.
    set_camera(camera_on_path(flight_.ends, part * part * (3 - 2 * part)));
  }
}

void Viewer_3::stop_flight() { flight_timer_.stop(); }

void Viewer_3::fit(const Box& box) {
  View_3 seen = destination();
  const Camera_3& camera = seen.camera;
  seen.camera = fit_camera(box, width(), height(), camera.axes().back, camera.up, camera.projection);
  go_to(seen);
}

void Viewer_3::look_from(const Point_3& direction, const Point_3& up) {
  View_3 seen = destination();
  seen.camera = fit_camera(drawn_box(scene_), width(), height(), direction, up, seen.camera.projection);
  go_to(seen);
}

void Viewer_3::look_from(const Point_3& direction) {
  const double along = dot(direction, up_);
  const Point_3 across = cross(direction, up_);
  if (dot(across, across) > 0) {
    look_from(direction, up_);
  } else {
    // As one sees the top when one bends over the front.
    const Point_3 front = up_.y > 0 ? Point_3{0, 0, 1} : Point_3{0, -1, 0};
    look_from(direction, (along > 0 ? -1.0 : 1.0) * front);
  }
}

void Viewer_3::set_projection(Camera_3::Projection projection) {
  View_3 seen = destination();
  Camera_3& camera = seen.camera;
  if (camera.projection == projection) return;
  camera.projection = projection;
  if (projection == Camera_3::Projection::perspective)
    camera.position =
        camera.target + (camera.height / 2 / std::tan(radians(camera.field_of_view) / 2)) * camera.axes().back;
  go_to(seen);
}

void Viewer_3::set_up(const Point_3& up) {
  up_ = up;
  camera()->frame()->setSceneUpVector(to_vec(up));
}

void Viewer_3::set_free_turning(bool is_free) {
  camera()->frame()->setRotatesAroundUpVector(!is_free);
  View_3 seen = destination();
  // A tilted turntable turns in surprising ways.
  const Camera_3::Axes axes = seen.camera.axes();
  constexpr double upright = 1e-6;
  if (is_free || std::abs(dot(axes.right, up_)) < upright) return;
  seen.camera.up = up_;
  go_to(seen);
}

void Viewer_3::set_mouse_preset(Mouse_preset preset) {
  mouse_preset_ = preset;
  clearMouseBindings();
  for (const Mouse_binding& binding : mouse_bindings(preset)) {
    const MouseAction action = binding.drag == Camera_drag::turn   ? ROTATE
                               : binding.drag == Camera_drag::move ? TRANSLATE
                                                                   : ZOOM;
    setMouseBinding(binding.modifiers, binding.button, CAMERA, action);
  }
}

void Viewer_3::set_marks(bool has_gizmo, bool has_scale_bar) {
  has_gizmo_ = has_gizmo;
  has_scale_bar_ = has_scale_bar;
  QOpenGLWidget::update();
}

void Viewer_3::zoom_about(const Point_3& place, double factor) {
  Camera_3 seen = view().camera;
  const Camera_3::Axes axes = seen.axes();
  const Point_3 pivot = to_point(camera()->pivotPoint());
  if (seen.projection == Camera_3::Projection::orthographic) {
    // Along the direction of sight nothing moves.
    const Point_3 across = place - dot(place - seen.target, axes.back) * axes.back;
    const Point_3 shift = (1 - 1 / factor) * (across - seen.target);
    seen.target = seen.target + shift;
    seen.position = seen.position + shift;
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

void Viewer_3::zoom(double factor) {
  remember_step();
  zoom_about(view().camera.target, factor);
}

Point_3 Viewer_3::place_under(const QPointF& pixel) {
  if (const auto hit = pick(pixel, 0)) return hit->place;
  const Camera_3 seen = view().camera;
  const Camera_3::Axes axes = seen.axes();
  const double per_pixel = seen.height_at_target() / std::max(1, height());
  return seen.target + ((pixel.x() - width() / 2.0) * per_pixel) * axes.right -
         ((pixel.y() - height() / 2.0) * per_pixel) * axes.up;
}

}  // namespace mesecina
