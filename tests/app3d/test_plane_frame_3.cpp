// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app3d/mouse_preset_3.h"
#include "app3d/plane_frame_3.h"
#include "app3d/view_history_3.h"
#include "app3d/view_marks_3.h"

namespace mesecina {
namespace {

Box box_of(const Point_3& lower, const Point_3& upper) {
  Box box;
  box.add(lower);
  box.add(upper);
  return box;
}

const Box oblong = box_of({-1, 0, 2}, {3, 1, 4});

TEST(Plane_frame_3, LiesInThePlaneAroundWhatItCuts) {
  for (const Point_3& normal : {Point_3{0, 0, 2}, Point_3{1, 2, 3}, Point_3{-0.1, 5, 0.2}, Point_3{1, 0, 0}}) {
    const Cutting_plane_3 plane{{0.5, 0.5, 2.5}, normal, 0.5};
    const Plane_frame_3 frame = frame_of(plane, oblong);
    EXPECT_NEAR(dot(frame.normal, frame.normal), 1, 1e-12);
    EXPECT_NEAR(dot(cross(frame.normal, normal), cross(frame.normal, normal)), 0, 1e-12);
    for (const Point_3& corner : frame.corners(0)) EXPECT_NEAR(dot(corner - plane.point, frame.normal), 0, 1e-9);
    for (const Point_3& corner : frame.corners(0.25)) EXPECT_NEAR(dot(corner - plane.point, frame.normal), 0.25, 1e-9);
    // The rectangle holds the shadow of every corner of the box.
    for (unsigned i = 0; i < 8; ++i) {
      const Point_3 corner{i & 1U ? 3.0 : -1.0, i & 2U ? 1.0 : 0.0, i & 4U ? 4.0 : 2.0};
      EXPECT_LT(std::abs(dot(corner - frame.center, frame.right)), dot(frame.right, frame.right));
      EXPECT_LT(std::abs(dot(corner - frame.center, frame.up)), dot(frame.up, frame.up));
    }
    EXPECT_EQ(outline_of(frame)->segments.size(), 8U);
    EXPECT_GT(distance(frame.tip(), frame.center), 0.25);
  }
}

TEST(Plane_frame_3, HasASizeWhateverTheBox) {
  for (const Box& box : {sized({}), sized(box_of({5, 5, 5}, {5, 5, 5}))}) {
    const Plane_frame_3 frame = frame_of({{5, 5, 5}, {0, 1, 0}, {}}, box);
    EXPECT_GT(dot(frame.right, frame.right) * dot(frame.up, frame.up) * frame.arrow, 0.01);
  }
  EXPECT_EQ(midpoint(sized(box_of({5, 6, 7}, {5, 6, 7})).lower, sized(box_of({5, 6, 7}, {5, 6, 7})).upper),
            (Point_3{5, 6, 7}));
}

TEST(Plane_frame_3, FacesTheViewerAlongAnAxis) {
  EXPECT_EQ(plane_facing({0.3, -0.9, 0.1}, oblong).normal, (Point_3{0, -1, 0}));
  EXPECT_EQ(plane_facing({0.3, 0.1, 0.9}, oblong).normal, (Point_3{0, 0, 1}));
  EXPECT_EQ(plane_facing({-3, 0.1, 0.9}, oblong).normal, (Point_3{-1, 0, 0}));
  EXPECT_EQ(plane_facing({0.3, 0.1, 0.9}, oblong).point, (Point_3{1, 0.5, 3}));
}

TEST(Plane_frame_3, MovesAndTurns) {
  const Cutting_plane_3 plane{{1, 2, 3}, {0, 0, 2}, 0.5};
  const Cutting_plane_3 moved = shifted(plane, 0.5);
  EXPECT_EQ(moved.point, (Point_3{1, 2, 3.5}));
  EXPECT_EQ(moved.thickness, 0.5);
  const Cutting_plane_3 quarter = turned(plane, {1, 2, 3}, {1, 0, 0}, std::numbers::pi / 2);
  EXPECT_LT(distance(quarter.normal, {0, -1, 0}), 1e-12);
  EXPECT_EQ(quarter.thickness, 0.5);
}

TEST(View_marks_3, ScaleBarsAreRoundAndFit) {
  for (const double unit : {1e-9, 0.037, 1.0, 2.0, 49.99, 50.0, 99.0, 1e12}) {
    const Scale_bar bar = scale_bar(unit, 100);
    EXPECT_LE(bar.pixels, 100 * (1 + 1e-12)) << unit;
    EXPECT_GE(bar.pixels, 39) << unit;
    EXPECT_NEAR(bar.pixels, bar.length * unit, 1e-9);
    const double digit = bar.length / std::pow(10, std::floor(std::log10(bar.length) + 1e-9));
    EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9) << bar.length;
  }
}

TEST(View_marks_3, EndsOfAxesAreWhereTheCameraSeesThem) {
  Camera_3 camera;  // from the front
  const Axis_gizmo gizmo(camera, {100, 100});
  EXPECT_EQ(gizmo.direction_at({100 + Axis_gizmo::radius, 100}), (Point_3{1, 0, 0}));
  EXPECT_EQ(gizmo.direction_at({100, 100 - Axis_gizmo::radius}), (Point_3{0, 1, 0}));
  EXPECT_EQ(gizmo.direction_at({100, 100 + Axis_gizmo::radius}), (Point_3{0, -1, 0}));
  EXPECT_EQ(gizmo.direction_at({100, 100}), (Point_3{0, 0, 1})) << "the nearest of two in one place";
  EXPECT_EQ(gizmo.direction_at({120, 115}), std::nullopt);
}

TEST(View_history_3, HasTheNewestHundredAndNoneTwice) {
  View_history_3 history;
  View_3 view;
  EXPECT_EQ(history.take(view), std::nullopt);
  for (int i = 0; i < 150; ++i) {
    view.camera.position = {0, 0, 1.0 + i};
    history.remember(view);
    history.remember(view);
  }
  for (int i = 148; i >= 50; --i) {
    const auto taken = history.take(view);
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->camera.position.z, 1.0 + i);
    view = *taken;
  }
  EXPECT_EQ(history.take(view), std::nullopt);
}

TEST(Mouse_preset_3, NamesReadBackAndGesturesAreInWords) {
  for (const auto preset : {Mouse_preset::standard, Mouse_preset::blender, Mouse_preset::cad}) {
    EXPECT_EQ(preset_named(preset_name(preset)), preset);
    EXPECT_EQ(camera_gestures(preset).size(), selects_by_drag(preset) ? 4U : 3U);
    for (const Gesture& gesture : camera_gestures(preset)) EXPECT_FALSE(gesture.first.isEmpty());
  }
  EXPECT_EQ(preset_named("unheard-of"), Mouse_preset::standard);
  EXPECT_EQ(camera_gestures(Mouse_preset::blender)[1].first, "Shift + middle");
}

}  // namespace
}  // namespace mesecina
