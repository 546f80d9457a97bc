// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/view_3.h"

namespace mesecina {
namespace {

Box box_of(const Point_3& lower, const Point_3& upper) {
  Box box;
  box.add(lower);
  box.add(upper);
  return box;
}

TEST(View_3, JsonReadsBackTheSame) {
  View_3 view;
  view.camera.position = {0.1, -1.0 / 3, 1e-7};
  view.camera.target = {2, 3, 4e10};
  view.camera.up = {0, 0, 1};
  view.camera.field_of_view = 33.3;
  EXPECT_EQ(parse_view_3(to_json(view)), view);
  view.cutting_plane = Cutting_plane_3{{1, 2, 3}, {0, 0.1, 0.7}, {}};
  EXPECT_EQ(parse_view_3(to_json(view)), view);
  view.cutting_plane->thickness = 0.25;
  view.camera = Camera_3{{0, 0, 5}, {}, {0, 1, 0}, Camera_3::Projection::orthographic, 40, 0.3};
  EXPECT_EQ(parse_view_3(to_json(view)), view);
}

TEST(View_3, TextsThatMakeNoViewAreRefused) {
  const std::string good = to_json(View_3{{}, Cutting_plane_3{}});
  EXPECT_NO_THROW(parse_view_3(good));
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
  };
  for (const std::string& text :
       {std::string(), std::string("{"), std::string("[]"), std::string("{}"), std::string("{\"camera\": 3}"),
        with("\"target\"", "\"targets\""), with("\"field-of-view\": 40.0", "\"field-of-view\": 180"),
        with("\"field-of-view\": 40.0", "\"field-of-view\": \"wide\""), with("\"perspective\"", "\"orthographic\""),
        with("\"perspective\"", "\"oblique\""), with("\"perspective\"", "7"), with("1.0", "0.0"),
        with("\"normal\"", "\"normals\""), with("1.0", "null")})
    EXPECT_THROW(parse_view_3(text), std::invalid_argument) << text;
}

TEST(View_3, AxesAreAFrameWhateverTheCamera) {
  for (const Camera_3& camera :
       {Camera_3{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}}, Camera_3{{0, 5, 0}, {0, 0, 0}, {0, 1, 0}},
        Camera_3{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, Camera_3{{0, 0, 1}, {0, 0, 0}, {0, 0, 0}}}) {
    const Camera_3::Axes axes = camera.axes();
    for (const Point_3& axis : {axes.right, axes.up, axes.back}) EXPECT_NEAR(dot(axis, axis), 1, 1e-12);
    const Point_3 across = cross(axes.right, axes.up) - axes.back;
    EXPECT_NEAR(dot(across, across), 0, 1e-12);
  }
}

TEST(View_3, FitShowsEveryCornerAndNoMoreThanNeeded) {
  const Box box = box_of({1, -2, 3}, {2, 4, 3.5});
  for (const auto& [width, height] : {std::pair{400.0, 300.0}, {100.0, 900.0}, {900.0, 100.0}}) {
    for (const auto projection : {Camera_3::Projection::perspective, Camera_3::Projection::orthographic}) {
      const Camera_3 camera = fit_camera(box, width, height, {0.4, 0.3, 1}, {0, 1, 0}, projection);
      const Camera_3::Axes axes = camera.axes();
      double largest = 0;
      for (int i = 0; i < 8; ++i) {
        const Point_3 corner{i & 1 ? box.lower.x : box.upper.x, i & 2 ? box.lower.y : box.upper.y,
                             i & 4 ? box.lower.z : box.upper.z};
        const Point_3 seen = corner - camera.position;
        const double away = -dot(seen, axes.back);
        const bool is_perspective = projection == Camera_3::Projection::perspective;
        const double half_height =
            is_perspective ? away * std::tan(camera.field_of_view * std::numbers::pi / 360) : camera.height / 2;
        largest = std::max({largest, std::abs(dot(seen, axes.up)) / half_height,
                            std::abs(dot(seen, axes.right)) / (half_height * width / height)});
        const auto [near, far] = depth_range(camera, box);
        EXPECT_LT(near, away);
        EXPECT_GT(far, away);
      }
      EXPECT_NEAR(largest, 0.95, 1e-9);
    }
  }
}

TEST(View_3, NothingAndASinglePointAreSeenFromSomewhere) {
  for (const Box& box : {Box{}, box_of({5, 5, 5}, {5, 5, 5})}) {
    const Camera_3 camera = fit_camera(box, 400, 300);
    EXPECT_GT(distance(camera.position, camera.target), 0.1);
    EXPECT_GT(camera.height, 0.1);
    const auto [near, far] = depth_range(camera, box);
    EXPECT_GT(near, 0);
    EXPECT_GT(far, near);
  }
}

}  // namespace
}  // namespace mesecina
