// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/point.h"

namespace mesecina {

/// Where the scene is seen from: a value.
struct Camera_3 {
  enum class Projection { perspective, orthographic };

  Point_3 position{0, 0, 1};
  Point_3 target;       ///< in the middle of the picture; about which one turns
  Point_3 up{0, 1, 0};  ///< upwards in the picture, as far as it is across the direction of sight
  Projection projection = Projection::perspective;
  double field_of_view = 40;  ///< of perspective: degrees from the bottom to the top of the picture
  double height = 2;          ///< of orthographic: units of the scene from bottom to top

  bool operator==(const Camera_3&) const = default;
  /// Unit vectors to the right, upwards and towards the viewer; some frame where `up` is along the direction of sight
  /// or the target is the position.
  struct Axes {
    Point_3 right;
    Point_3 up;
    Point_3 back;
  };
  Axes axes() const;
  /// Units of the scene from bottom to top of the picture at the target.
  double height_at_target() const;
};

/// The part of space that is shown: within half a thickness of the plane; or all on the side the normal points away
/// from, where there is no thickness.
struct Cutting_plane_3 {
  Point_3 point;
  Point_3 normal{0, 0, 1};  ///< any length but 0
  std::optional<double> thickness;
  bool operator==(const Cutting_plane_3&) const = default;
};

/// How a scene in space is seen.
struct View_3 {
  Camera_3 camera;
  std::optional<Cutting_plane_3> cutting_plane;
  bool operator==(const View_3&) const = default;
};

/// The camera that sees the box from `direction` (pointing from the box to the camera), with a margin
/// of 5 %, in a picture of this shape; a sensible one for an empty box or a single point.
Camera_3 fit_camera(const Box& box, double width, double height, const Point_3& direction, const Point_3& up,
                    Camera_3::Projection projection);
/// The same from a little to the right and above, y upwards, in perspective.
Camera_3 fit_camera(const Box& box, double width, double height);

/// Least and greatest distance along the direction of sight between which the camera sees the ball around the box. In
/// perspective the least is positive.
std::pair<double, double> depth_range(const Camera_3& camera, const Box& box);

/// The text of a view file: {"camera": {"position": [x, y, z], "target": ..., "up": ..., "projection": "perspective",
/// "field-of-view": degrees} or with "projection": "orthographic", "height": units}, "cutting-plane": {"point": ...,
/// "normal": ..., "thickness": t}, "camera-path": [cameras]}, the plane, its thickness and the path where there are
/// such. Numbers read back as they were. `path`: the key frames of a way of the camera.
std::string to_json(const View_3& view, std::span<const Camera_3> path = {});
/// Reads it. Throws std::invalid_argument, with what was expected, for any other text and for numbers that make no
/// view: not finite, nothing between position and target, a field of view beyond (0, 180), no height, no normal.
View_3 parse_view_3(std::string_view text);
/// The key frames in it; none where there is no "camera-path". Throws as parse_view_3 does, of these cameras too.
std::vector<Camera_3> parse_camera_path_3(std::string_view text);

}  // namespace mesecina
