// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/camera_player_3.h"

#include <algorithm>
#include <utility>

#include "core/camera_path_3.h"

namespace mesecina {

namespace {

/// How much two cameras differ, in pictures.
double difference(const Camera_3& one, const Camera_3& other) {
  const double size = std::max(one.height_at_target(), other.height_at_target());
  return (distance(one.target, other.target) + distance(one.position, other.position)) / size +
         distance(one.axes().up, other.axes().up) + (one.projection == other.projection ? 0 : 1);
}

}  // namespace

Camera_player_3::Camera_player_3(Viewer_3& viewer, QObject* parent) : QObject(parent), viewer_(viewer) {
  constexpr int frame_milliseconds = 15;
  timer_.setInterval(frame_milliseconds);
  connect(&timer_, &QTimer::timeout, this, &Camera_player_3::go_on);
  connect(&viewer_, &Viewer_3::camera_taken, this, &Camera_player_3::stop);
}

void Camera_player_3::set_key_frames(std::vector<Camera_3> key_frames) {
  timer_.stop();
  key_frames_ = std::move(key_frames);
  Q_EMIT changed();
}

void Camera_player_3::add() {
  key_frames_.push_back(viewer_.destination().camera);
  Q_EMIT changed();
}

void Camera_player_3::remove() {
  if (key_frames_.empty()) return;
  const Camera_3 seen = viewer_.destination().camera;
  key_frames_.erase(
      std::ranges::min_element(key_frames_, {}, [&](const Camera_3& frame) { return difference(frame, seen); }));
  if (key_frames_.size() < 2) timer_.stop();
  Q_EMIT changed();
}

void Camera_player_3::play() {
  if (key_frames_.size() < 2) return;
  viewer_.remember_view();
  time_.start();
  timer_.start();
  go_on();
  Q_EMIT changed();
}

void Camera_player_3::stop() {
  if (!timer_.isActive()) return;
  timer_.stop();
  Q_EMIT changed();
}

void Camera_player_3::go_on() {
  constexpr double milliseconds = 1000;
  const double place = static_cast<double>(time_.elapsed()) / (milliseconds * seconds_);
  View_3 view = viewer_.view();
  view.camera = camera_on_path(key_frames_, place, is_loop_);
  viewer_.set_view(view);
  if (!is_loop_ && place >= static_cast<double>(key_frames_.size() - 1)) stop();
}

}  // namespace mesecina
