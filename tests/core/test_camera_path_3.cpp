// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "core/camera_path_3.h"

namespace mesecina {
namespace {

Camera_3 seen_from(const Point_3& direction, double away) {
  Camera_3 camera;
  camera.target = {1, 2, 3};
  camera.position = camera.target + away * direction;
  return camera;
}

const std::vector<Camera_3> quarter_turns{seen_from({0, 0, 1}, 4), seen_from({1, 0, 0}, 4), seen_from({0, 0, -1}, 16),
                                          seen_from({-1, 0, 0}, 4)};

TEST(Camera_path_3, GoesThroughItsKeyFrames) {
  for (const bool is_loop : {false, true}) {
    for (std::size_t i = 0; i < quarter_turns.size(); ++i) {
      EXPECT_EQ(camera_on_path(quarter_turns, static_cast<double>(i), is_loop), quarter_turns[i]);
      // Nothing jumps there.
      for (const double side : {-1e-9, 1e-9}) {
        const double place = static_cast<double>(i) + side;
        if (!is_loop && (place < 0 || place > 3)) continue;
        EXPECT_TRUE(is_nearly_equal(camera_on_path(quarter_turns, place, is_loop), quarter_turns[i])) << place;
      }
    }
  }
  EXPECT_EQ(camera_on_path(quarter_turns, -5), quarter_turns.front());
  EXPECT_EQ(camera_on_path(quarter_turns, 17), quarter_turns.back());
  EXPECT_EQ(camera_on_path(quarter_turns, 6, true), quarter_turns[2]);
}

TEST(Camera_path_3, HalfwayOfTwoTurnsByHalfTheAngleAndScalesByTheRootOfTheFactor) {
  const std::vector<Camera_3> two{quarter_turns[1], quarter_turns[2]};
  const Camera_3 middle = camera_on_path(two, 0.5);
  EXPECT_LT(distance(middle.axes().back, {std::sqrt(0.5), 0, -std::sqrt(0.5)}), 1e-12);
  EXPECT_LT(distance(middle.axes().up, {0, 1, 0}), 1e-12);
  EXPECT_NEAR(distance(middle.position, middle.target), 8, 1e-9);
  EXPECT_LT(distance(middle.target, {1, 2, 3}), 1e-12);
}

TEST(Camera_path_3, IsSmoothAcrossKeyFrames) {
  constexpr double step = 1e-4;
  for (double place = step; place < 4; place += 0.25) {
    const auto at = [&](double offset) { return camera_on_path(quarter_turns, place + offset, true).position; };
    const Point_3 bend = at(step) - at(0) - (at(0) - at(-step));
    EXPECT_LT(distance(bend, {}), 1e-5) << place;
  }
}

TEST(Camera_path_3, OppositeViewsAndChangesOfProjectionHaveAWayBetweenThem) {
  Camera_3 back = seen_from({0, 0, -1}, 4);
  back.projection = Camera_3::Projection::orthographic;
  back.height = seen_from({0, 0, 1}, 4).height_at_target();
  const std::vector<Camera_3> two{seen_from({0, 0, 1}, 4), back};
  for (double place = 0.05; place < 1; place += 0.1) {
    const Camera_3 camera = camera_on_path(two, place);
    EXPECT_EQ(camera.projection, Camera_3::Projection::orthographic);
    EXPECT_NEAR(camera.height, back.height, 1e-9);
    EXPECT_NEAR(dot(camera.axes().up, {0, 1, 0}), 1, 1e-9) << "it turns about the upward direction";
  }
}

TEST(Camera_path_3, OneKeyFrameAndNone) {
  const std::vector<Camera_3> one{quarter_turns[2]};
  for (const double place : {-1.0, 0.0, 0.4, 3.0}) {
    EXPECT_EQ(camera_on_path(one, place), one[0]);
    EXPECT_TRUE(is_nearly_equal(camera_on_path(one, place, true), one[0]));
    EXPECT_EQ(camera_on_path({}, place), Camera_3{});
  }
}

TEST(Camera_path_3, JsonReadsBackTheSame) {
  View_3 view;
  view.cutting_plane = Cutting_plane_3{};
  const std::string text = to_json(view, quarter_turns);
  EXPECT_EQ(parse_view_3(text), view);
  const std::vector<Camera_3> path = parse_camera_path_3(text);
  ASSERT_EQ(path.size(), quarter_turns.size());
  // The height of a perspective camera says nothing and is not written.
  for (std::size_t i = 0; i < path.size(); ++i) EXPECT_EQ(path[i], quarter_turns[i]);
  EXPECT_TRUE(parse_camera_path_3(to_json(view)).empty());
  EXPECT_THROW(parse_camera_path_3("{\"camera-path\": 3}"), std::invalid_argument);
  EXPECT_THROW(parse_camera_path_3("{\"camera-path\": [3]}"), std::invalid_argument);
  EXPECT_THROW(parse_camera_path_3("{\"camera-path\": [{}]}"), std::invalid_argument);
  EXPECT_THROW(parse_camera_path_3("nonsense"), std::invalid_argument);
}

}  // namespace
}  // namespace mesecina
