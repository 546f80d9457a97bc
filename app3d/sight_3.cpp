// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/sight_3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mesecina {

namespace {

Point_3 normalized(const Point_3& p) { return (1 / std::hypot(p.x, p.y, p.z)) * p; }

}  // namespace

Sight_3::Sight_3(const Camera_3& camera, double width, double height)
    : camera_(camera), axes_(camera.axes()), width_(width), height_(std::max(height, 1.0)) {
  const bool is_perspective = camera.projection == Camera_3::Projection::perspective;
  unit_ = (is_perspective ? 2 * std::tan(camera.field_of_view * std::numbers::pi / 360) : camera.height) / height_;
}

Sight_line Sight_3::line(const Point_2& pixel) const {
  const Point_3 aside = (unit_ * (pixel.x - width_ / 2)) * axes_.right - (unit_ * (pixel.y - height_ / 2)) * axes_.up;
  if (camera_.projection == Camera_3::Projection::orthographic) return {camera_.position + aside, -1.0 * axes_.back};
  return {camera_.position, normalized(aside - axes_.back)};
}

double Sight_3::pixel_size(const Point_3& place) const {
  if (camera_.projection == Camera_3::Projection::orthographic) return unit_;
  return std::max(0.0, dot(camera_.position - place, axes_.back)) * unit_;
}

std::optional<Point_2> Sight_3::pixel(const Point_3& place) const {
  const double size = pixel_size(place);
  if (!(size > 0)) return std::nullopt;
  const Point_3 off = place - camera_.position;
  return Point_2{width_ / 2 + dot(off, axes_.right) / size, height_ / 2 - dot(off, axes_.up) / size};
}

double Sight_3::outline_radius(const Point_3& center, double radius) const {
  const double size = pixel_size(center);
  if (!(size > 0)) return 0;
  if (camera_.projection == Camera_3::Projection::orthographic) return radius / size;
  const double share = radius * radius / squared_distance(camera_.position, center);
  return share < 1 ? radius / size / std::sqrt(1 - share) : std::numeric_limits<double>::infinity();
}

std::optional<Point_3> Sight_3::on_plane(const Point_2& pixel, const Point_3& point, const Point_3& normal) const {
  const Sight_line seen = line(pixel);
  const double rate = dot(seen.direction, normal);
  const double away = dot(point - seen.from, normal) / rate;
  const bool is_seen = camera_.projection == Camera_3::Projection::orthographic || away > 0;
  if (rate == 0 || !std::isfinite(away) || !is_seen) return std::nullopt;
  return seen.from + away * seen.direction;
}

Point_3 Sight_3::across(const Point_2& pixel, const Point_3& place) const {
  return on_plane(pixel, place, axes_.back).value_or(place);
}

double Sight_3::along(const Point_2& pixel, const Point_3& place, const Point_3& direction) const {
  const Sight_line seen = line(pixel);
  const double slant = dot(seen.direction, direction);
  constexpr double least = 1e-6;
  if (1 - slant * slant < least) return 0;
  const Point_3 off = seen.from - place;
  return (dot(off, direction) - slant * dot(off, seen.direction)) / (1 - slant * slant);
}

bool is_left(const std::optional<Cutting_plane_3>& plane, const Point_3& place) {
  if (!plane) return true;
  const double length = std::sqrt(dot(plane->normal, plane->normal));
  const double side = dot(place - plane->point, plane->normal) / length;
  return plane->thickness ? std::abs(side) <= *plane->thickness / 2 : side <= 0;
}

}  // namespace mesecina
