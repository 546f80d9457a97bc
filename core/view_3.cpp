// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view_3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

namespace mesecina {

namespace {

using Ordered_json = nlohmann::ordered_json;

constexpr double part_of_picture = 0.95;
constexpr const char* perspective_name = "perspective";
constexpr const char* orthographic_name = "orthographic";

double length(const Point_3& p) { return std::hypot(p.x, p.y, p.z); }

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Of the ball around the box; 1 where there is no size to go by.
double radius_of(const Box& box) {
  const double radius = box.diagonal() / 2;
  return std::isfinite(radius) && radius > 0 ? radius : 1;
}

Point_3 center_of(const Box& box) { return box.is_empty() ? Point_3{} : midpoint(box.lower, box.upper); }

/// The corners of the box relative to its middle.
std::array<Point_3, 8> corners_around(const Box& box) {
  std::array<Point_3, 8> corners;
  if (box.is_empty()) return corners;
  const Point_3 half = 0.5 * (box.upper - box.lower);
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z};
  return corners;
}

Ordered_json to_array(const Point_3& p) { return Ordered_json::array({p.x, p.y, p.z}); }

[[noreturn]] void refuse(const std::string& expected) { throw std::invalid_argument("expected " + expected); }

double number_of(const Ordered_json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_number() || !std::isfinite(found->get<double>()))
    refuse("a finite number \"" + std::string(name) + "\"");
  return found->get<double>();
}

Point_3 point_of(const Ordered_json& json, const char* name) {
  const auto found = json.find(name);
  const auto is_number = [](const Ordered_json& entry) {
    return entry.is_number() && std::isfinite(entry.get<double>());
  };
  if (found == json.end() || !found->is_array() || found->size() != 3 || !std::ranges::all_of(*found, is_number))
    refuse("three finite numbers \"" + std::string(name) + "\": [x, y, z]");
  return {(*found)[0].get<double>(), (*found)[1].get<double>(), (*found)[2].get<double>()};
}

const Ordered_json& object_of(const Ordered_json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_object()) refuse("an object \"" + std::string(name) + "\"");
  return *found;
}

Camera_3 camera_of(const Ordered_json& json) {
  Camera_3 camera;
  camera.position = point_of(json, "position");
  camera.target = point_of(json, "target");
  camera.up = point_of(json, "up");
  if (camera.position == camera.target) refuse("a \"target\" that is not the \"position\"");
  const std::string projection = json.value("projection", perspective_name);
  if (projection == orthographic_name) {
    camera.projection = Camera_3::Projection::orthographic;
    camera.height = number_of(json, "height");
    if (!(camera.height > 0)) refuse("a positive \"height\"");
  } else if (projection == perspective_name) {
    camera.field_of_view = number_of(json, "field-of-view");
    if (!(camera.field_of_view > 0 && camera.field_of_view < 180)) refuse("a \"field-of-view\" between 0 and 180");
  } else {
    refuse("\"projection\": \"perspective\" or \"orthographic\"");
  }
  return camera;
}

Ordered_json to_object(const Camera_3& camera) {
  Ordered_json json;
  json["position"] = to_array(camera.position);
  json["target"] = to_array(camera.target);
  json["up"] = to_array(camera.up);
  if (camera.projection == Camera_3::Projection::orthographic) {
    json["projection"] = orthographic_name;
    json["height"] = camera.height;
  } else {
    json["projection"] = perspective_name;
    json["field-of-view"] = camera.field_of_view;
  }
  return json;
}

/// Runs `read` on the JSON object that the text must be.
template <class Read>
auto read_view_file(std::string_view text, const Read& read) {
  const Ordered_json json = Ordered_json::parse(text, nullptr, false);
  if (!json.is_object()) refuse("a JSON object with a \"camera\"");
  try {
    return read(json);
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(error.what());
  }
}

}  // namespace

Camera_3::Axes Camera_3::axes() const {
  Axes axes;
  Point_3 toward = position - target;
  if (!(length(toward) > 0)) toward = {0, 0, 1};
  axes.back = (1 / length(toward)) * toward;
  constexpr double nearly_parallel = 1e-9;
  for (const Point_3& candidate : {up, Point_3{0, 1, 0}, Point_3{0, 0, -1}}) {
    axes.right = cross(candidate, axes.back);
    if (length(axes.right) > nearly_parallel * length(candidate)) break;
  }
  axes.right = (1 / length(axes.right)) * axes.right;
  axes.up = cross(axes.back, axes.right);
  return axes;
}

double Camera_3::height_at_target() const {
  if (projection == Projection::orthographic) return height;
  return 2 * distance(position, target) * std::tan(radians(field_of_view) / 2);
}

Camera_3 fit_camera(const Box& box, double width, double height, const Point_3& direction, const Point_3& up,
                    Camera_3::Projection projection) {
  Camera_3 camera;
  camera.projection = projection;
  camera.target = center_of(box);
  camera.up = up;
  camera.position = camera.target + direction;
  const Camera_3::Axes axes = camera.axes();
  const double aspect = width > 0 && height > 0 ? width / height : 1;
  const double slope_y = part_of_picture * std::tan(radians(camera.field_of_view) / 2);
  const double slope_x = slope_y * aspect;
  // In units of the smallest that fits; a box without a size has corners at 0.
  double half_height = 0;
  double away = 0;
  for (const Point_3& corner : corners_around(box)) {
    const double x = std::abs(dot(corner, axes.right));
    const double y = std::abs(dot(corner, axes.up));
    half_height = std::max({half_height, y / part_of_picture, x / (part_of_picture * aspect)});
    away = std::max(away, dot(corner, axes.back) + std::max(x / slope_x, y / slope_y));
  }
  camera.height = half_height > 0 ? 2 * half_height : 2;
  camera.position = camera.target + (away > 0 ? away : 3) * axes.back;
  return camera;
}

Camera_3 fit_camera(const Box& box, double width, double height) {
  constexpr Point_3 direction{0.45, 0.3, 1};
  return fit_camera(box, width, height, direction, {0, 1, 0}, Camera_3::Projection::perspective);
}

std::pair<double, double> depth_range(const Camera_3& camera, const Box& box) {
  constexpr double slack = 1.01;
  constexpr double least_part = 1e-3;
  const double radius = slack * radius_of(box);
  const double middle = dot(camera.position - center_of(box), camera.axes().back);
  if (camera.projection == Camera_3::Projection::orthographic) return {middle - radius, middle + radius};
  const double far = std::max(middle + radius, least_part * radius);
  return {std::max(middle - radius, least_part * far), far};
}

std::string to_json(const View_3& view, std::span<const Camera_3> path) {
  Ordered_json json;
  json["camera"] = to_object(view.camera);
  if (view.cutting_plane) {
    json["cutting-plane"]["point"] = to_array(view.cutting_plane->point);
    json["cutting-plane"]["normal"] = to_array(view.cutting_plane->normal);
    if (view.cutting_plane->thickness) json["cutting-plane"]["thickness"] = *view.cutting_plane->thickness;
  }
  for (const Camera_3& camera : path) json["camera-path"].push_back(to_object(camera));
  constexpr int indent = 2;
  return json.dump(indent) + "\n";
}

View_3 parse_view_3(std::string_view text) {
  return read_view_file(text, [](const Ordered_json& json) {
    View_3 view;
    view.camera = camera_of(object_of(json, "camera"));
    if (json.contains("cutting-plane")) {
      const Ordered_json& plane = object_of(json, "cutting-plane");
      view.cutting_plane = {point_of(plane, "point"), point_of(plane, "normal"), {}};
      if (!(length(view.cutting_plane->normal) > 0)) refuse("a \"normal\" that is not 0");
      if (plane.contains("thickness")) view.cutting_plane->thickness = number_of(plane, "thickness");
    }
    return view;
  });
}

std::vector<Camera_3> parse_camera_path_3(std::string_view text) {
  return read_view_file(text, [](const Ordered_json& json) {
    std::vector<Camera_3> path;
    if (!json.contains("camera-path")) return path;
    if (!json["camera-path"].is_array()) refuse("an array \"camera-path\" of cameras");
    for (const Ordered_json& camera : json["camera-path"]) {
      if (!camera.is_object()) refuse("an array \"camera-path\" of cameras");
      path.push_back(camera_of(camera));
    }
    return path;
  });
}

}  // namespace mesecina
