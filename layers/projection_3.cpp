// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/projection_3.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace mesecina {

Projection_3::Projection_3(const Camera_3& camera, const Box& box, const Frame_3& frame)
    : camera_(camera),
      axes_(camera.axes()),
      frame_(frame),
      is_perspective_(camera.projection == Camera_3::Projection::perspective) {
  std::tie(near_, far_) = depth_range(camera, box);
  half_height_ = is_perspective_ ? std::tan(camera.field_of_view * std::numbers::pi / 360) : camera.height / 2;
  half_width_ = half_height_ * frame.width / std::max(frame.height, 1);
  pixel_size_ = 2 * half_height_ / (std::max(frame.height, 1) * std::max(frame.samples, 1));
}

Point_3 Projection_3::direction_to_eye(const Point_3& direction) const {
  return {dot(direction, axes_.right), dot(direction, axes_.up), dot(direction, axes_.back)};
}

Point_3 Projection_3::to_eye(const Point_3& place) const { return direction_to_eye(place - camera_.position); }

Projection_3::Matrix Projection_3::eye_matrix(const Point_3& origin) const {
  const Point_3 shift = to_eye(origin);
  Matrix matrix{};
  const std::array rows{axes_.right, axes_.up, axes_.back};
  const std::array shifts{shift.x, shift.y, shift.z};
  for (std::size_t row = 0; row < 3; ++row) {
    matrix[row] = static_cast<float>(rows[row].x);
    matrix[4 + row] = static_cast<float>(rows[row].y);
    matrix[8 + row] = static_cast<float>(rows[row].z);
    matrix[12 + row] = static_cast<float>(shifts[row]);
  }
  matrix[15] = 1;
  return matrix;
}

Projection_3::Matrix Projection_3::clip_matrix() const {
  const Tile tile = frame_.whole_tile();
  // The tile fills the picture: x of the whole picture becomes zoom * x + shift.
  const double zoom_x = static_cast<double>(frame_.width) / tile.width;
  const double zoom_y = static_cast<double>(frame_.height) / tile.height;
  const double shift_x = zoom_x - 1 - 2.0 * tile.left / tile.width;
  const double shift_y = zoom_y - 1 - 2.0 * tile.bottom / tile.height;
  Matrix matrix{};
  matrix[0] = static_cast<float>(zoom_x / half_width_);
  matrix[5] = static_cast<float>(zoom_y / half_height_);
  if (is_perspective_) {
    matrix[8] = static_cast<float>(-shift_x);
    matrix[9] = static_cast<float>(-shift_y);
    matrix[10] = static_cast<float>((far_ + near_) / (near_ - far_));
    matrix[11] = -1;
    matrix[14] = static_cast<float>(2 * far_ * near_ / (near_ - far_));
  } else {
    matrix[12] = static_cast<float>(shift_x);
    matrix[13] = static_cast<float>(shift_y);
    matrix[10] = static_cast<float>(2 / (near_ - far_));
    matrix[14] = static_cast<float>((far_ + near_) / (near_ - far_));
    matrix[15] = 1;
  }
  return matrix;
}

Point_3 Projection_3::place_at(int column, int row, double depth) const {
  const double x = (2 * (column + 0.5) / frame_.width - 1) * half_width_;
  const double y = (1 - 2 * (row + 0.5) / frame_.height) * half_height_;
  const double away = is_perspective_ ? far_ * near_ / (far_ - depth * (far_ - near_)) : near_ + depth * (far_ - near_);
  const double factor = is_perspective_ ? away : 1;
  return camera_.position + (factor * x) * axes_.right + (factor * y) * axes_.up - away * axes_.back;
}

}  // namespace mesecina
