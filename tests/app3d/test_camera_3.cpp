// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QClipboard>
#include <cmath>

#include "core/camera_path_3.h"
#include "layers/number_field.h"
#include "tests/app3d/window_fixture_3.h"

namespace mesecina {
namespace {

class Camera_in_window : public Window_3 {
 protected:
  void SetUp() override { open_ball(); }

  void trigger(const char* action) { window_->actions()[action]->trigger(); }
  Point_3 back() { return viewer().view().camera.axes().back; }
  void wheel(const QPointF& at, int notches, Qt::KeyboardModifiers modifiers = {}) {
    QWheelEvent event(at, viewer().mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::NoButton, modifiers,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&viewer(), &event);
  }
  QPointF pixel_of(const Point_3& place) {
    const auto pixel = Sight_3(viewer().view().camera, viewer().width(), viewer().height()).pixel(place);
    return {pixel.value().x, pixel.value().y};
  }
  QPoint end_of_axis(const Point_3& direction) {
    const Axis_gizmo gizmo = viewer().gizmo();
    for (int x = 0; x < viewer().width() / 2; ++x)
      for (int y = viewer().height() / 2; y < viewer().height(); ++y)
        if (gizmo.direction_at(QPointF(x, y)) == direction) return {x + 3, y};
    ADD_FAILURE() << "no end of that axis";
    return {};
  }
  QColor color_at(const QPointF& pixel) {
    const QImage picture = viewer().grab_picture();
    return picture.pixelColor((pixel * viewer().devicePixelRatioF()).toPoint());
  }
};

TEST_F(Camera_in_window, ThePlaceUnderTheCursorStaysWhileZooming) {
  const QPointF pixel(viewer().width() / 2.0 + 60, viewer().height() / 2.0 - 45);
  for (const char* again : {"once", "orthographic"}) {
    const auto hit = viewer().pick(pixel, 0);
    ASSERT_TRUE(hit);
    for (const int notches : {1, 3, -2}) {
      wheel(pixel, notches);
      const QPointF seen = pixel_of(hit->place);
      EXPECT_LT(std::hypot(seen.x() - pixel.x(), seen.y() - pixel.y()), 1) << again << notches;
    }
    trigger("projection");
  }
}

TEST_F(Camera_in_window, ADoubleClickChoosesThePivotWhichStaysWhereItIsWhenTurned) {
  const QPoint pixel(viewer().width() / 2 + 60, viewer().height() / 2 - 45);
  const auto hit = viewer().pick(pixel, 0);
  ASSERT_TRUE(hit);
  QTest::mouseDClick(&viewer(), Qt::LeftButton, {}, pixel);
  const QColor dot = color_at(pixel);
  EXPECT_GT(dot.red() - dot.blue(), 100) << "the pivot is shown: " << dot.name().toStdString();
  const Point_3 before = back();
  const QPoint from(20, 20);
  drag(Qt::LeftButton, from, from + QPoint(90, 40));
  EXPECT_GT(distance(back(), before), 0.1);
  const QPointF seen = pixel_of(hit->place);
  EXPECT_LT(std::hypot(seen.x() - pixel.x(), seen.y() - pixel.y()), 1);
}

TEST_F(Camera_in_window, StandardViewsFollowWhatPointsUpwards) {
  struct Expected {
    const char* action;
    Point_3 with_y;
    Point_3 with_z;
  };
  const double third = 1 / std::sqrt(3);
  for (const Expected& view :
       {Expected{"view-front", {0, 0, 1}, {0, -1, 0}}, Expected{"view-back", {0, 0, -1}, {0, 1, 0}},
        Expected{"view-right", {1, 0, 0}, {1, 0, 0}}, Expected{"view-left", {-1, 0, 0}, {-1, 0, 0}},
        Expected{"view-top", {0, 1, 0}, {0, 0, 1}}, Expected{"view-bottom", {0, -1, 0}, {0, 0, -1}},
        Expected{"view-isometric", {third, third, third}, {third, -third, third}}}) {
    trigger(view.action);
    EXPECT_LT(distance(back(), view.with_y), 1e-6) << view.action;
    trigger("z-up");
    trigger(view.action);
    EXPECT_LT(distance(back(), view.with_z), 1e-6) << view.action;
    EXPECT_GE(viewer().view().camera.axes().up.z, -1e-9);
    trigger("z-up");
  }
  trigger("view-top");
  EXPECT_LT(distance(viewer().view().camera.axes().up, {0, 0, -1}), 1e-6);
}

TEST_F(Camera_in_window, TheNumberPadLooksAlongAxes) {
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  viewer().setFocus();
  const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&viewer(), key, modifiers | Qt::KeypadModifier);
    return back();
  };
  EXPECT_LT(distance(press(Qt::Key_3), {1, 0, 0}), 1e-6);
  EXPECT_LT(distance(press(Qt::Key_1), {0, 0, 1}), 1e-6);
  EXPECT_LT(distance(press(Qt::Key_7), {0, 1, 0}), 1e-6);
  EXPECT_LT(distance(press(Qt::Key_1, Qt::ControlModifier), {0, 0, -1}), 1e-6);
  int count = 0;
  QObject::connect(window_->actions()["projection"], &QAction::triggered, window_.get(), [&] { ++count; });
  press(Qt::Key_5);
  EXPECT_EQ(count, 1);
  // The other one is for the fifth bundle.
  QTest::keyClick(&viewer(), Qt::Key_5);
  EXPECT_EQ(count, 1);
}

TEST_F(Camera_in_window, ATurntableStaysUprightAndABallDoesNot) {
  const QPoint middle = viewer().rect().center();
  const auto turn = [&] {
    for (const QPoint& way : {QPoint(90, 50), QPoint(-40, 70), QPoint(80, -30)})
      drag(Qt::LeftButton, middle, middle + way);
    return std::abs(viewer().view().camera.axes().right.y);
  };
  EXPECT_LT(turn(), 1e-6);
  trigger("free-turning");
  EXPECT_GT(turn(), 0.01);
  trigger("free-turning");
  EXPECT_LT(std::abs(viewer().view().camera.axes().right.y), 1e-6) << "upright again";
  EXPECT_LT(turn(), 1e-6);
}

TEST_F(Camera_in_window, PreviousViewLeadsBackThroughGesturesAndJumps) {
  const View_3 first = viewer().view();
  const QPoint middle = viewer().rect().center();
  drag(Qt::LeftButton, middle, middle + QPoint(60, 20));
  const View_3 turned = viewer().view();
  trigger("view-right");
  trigger("view-right");
  wheel(middle, 1);
  wheel(middle, 1);
  trigger("previous-view");
  EXPECT_LT(distance(back(), {1, 0, 0}), 1e-6) << "both steps of the wheel are one";
  trigger("previous-view");
  EXPECT_TRUE(is_nearly_equal(viewer().view(), turned)) << "the same view twice is one";
  trigger("previous-view");
  EXPECT_TRUE(is_nearly_equal(viewer().view(), first));
  trigger("cutting-plane");
  EXPECT_TRUE(viewer().view().cutting_plane);
  trigger("previous-view");
  EXPECT_TRUE(is_nearly_equal(viewer().view(), first)) << "without the plane";
}

TEST_F(Camera_in_window, AFlightTakesItsTimeAndArrives) {
  viewer().set_flight_time(200);
  QElapsedTimer time;
  time.start();
  trigger("view-right");
  EXPECT_TRUE(viewer().is_flying());
  EXPECT_GT(distance(back(), {1, 0, 0}), 0.1);
  // A second wish counts from where the first one leads.
  trigger("projection");
  ASSERT_TRUE(wait_until([&] { return !viewer().is_flying(); }));
  EXPECT_GE(time.elapsed(), 180);
  EXPECT_LT(distance(back(), {1, 0, 0}), 1e-6);
  EXPECT_EQ(viewer().view().camera.projection, Camera_3::Projection::orthographic);
  trigger("view-left");
  const QPoint middle = viewer().rect().center();
  drag(Qt::LeftButton, middle, middle + QPoint(60, 20));
  EXPECT_FALSE(viewer().is_flying()) << "the mouse takes the camera";
}

TEST_F(Camera_in_window, AViewIsCopiedAndPastedWithPlaneAndKeyFrames) {
  trigger("cutting-plane");
  trigger("add-key-frame");
  trigger("view-isometric");
  trigger("add-key-frame");
  const View_3 copied = viewer().view();
  const std::vector<Camera_3> frames = window_->player()->key_frames();
  trigger("copy-view");
  trigger("view-left");
  trigger("cutting-plane");
  trigger("delete-key-frame");
  EXPECT_EQ(window_->player()->key_frames().size(), 1U);
  trigger("paste-view");
  EXPECT_TRUE(is_nearly_equal(viewer().view(), copied));
  ASSERT_EQ(window_->player()->key_frames().size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(is_nearly_equal(window_->player()->key_frames()[i], frames[i]));
  QApplication::clipboard()->setText("nonsense");
  trigger("paste-view");
  EXPECT_TRUE(is_nearly_equal(viewer().view(), copied));
  EXPECT_EQ(window_->messages().lines().size(), 1);
}

TEST_F(Camera_in_window, MousePresetsSayWhichButtonTurns) {
  const QPoint beside(20, viewer().height() / 2);
  const auto turns = [&](Qt::MouseButton button) {
    const View_3 before = viewer().view();
    drag(button, beside, beside + QPoint(70, 0));
    return distance(before.camera.axes().back, back()) > 0.05;
  };
  EXPECT_TRUE(turns(Qt::LeftButton));
  EXPECT_FALSE(turns(Qt::MiddleButton));
  for (const char* preset : {"mouse-blender", "mouse-cad"}) {
    trigger(preset);
    EXPECT_TRUE(turns(Qt::LeftButton));
    EXPECT_TRUE(turns(Qt::MiddleButton));
    // There the button of the tool that selects is its own.
    trigger("tool-select");
    EXPECT_FALSE(turns(Qt::LeftButton));
    EXPECT_TRUE(turns(Qt::MiddleButton));
    trigger("tool-turn");
  }
  // Another window remembers.
  open_ball();
  EXPECT_TRUE(window_->actions()["mouse-cad"]->isChecked());
  EXPECT_TRUE(turns(Qt::MiddleButton));
  trigger("mouse-standard");
}

TEST_F(Camera_in_window, AClickOnAnAxisLooksAlongItAndAgainFromTheOtherSide) {
  QTest::mouseClick(&viewer(), Qt::LeftButton, {}, end_of_axis({1, 0, 0}));
  EXPECT_LT(distance(back(), {1, 0, 0}), 1e-6);
  QTest::mouseClick(&viewer(), Qt::LeftButton, {}, end_of_axis({1, 0, 0}));
  EXPECT_LT(distance(back(), {-1, 0, 0}), 1e-6);
  QTest::mouseClick(&viewer(), Qt::LeftButton, {}, end_of_axis({0, -1, 0}));
  EXPECT_LT(distance(back(), {0, -1, 0}), 1e-6);
}

TEST_F(Camera_in_window, TheScaleBarIsAsLongAsItSays) {
  trigger("view-front");
  trigger("projection");
  const Scale_bar bar = viewer().scale();
  const QPointF from = pixel_of({0, 0, 0});
  const QPointF to = pixel_of({bar.length, 0, 0});
  EXPECT_NEAR(to.x() - from.x(), bar.pixels, 1e-6);
}

TEST_F(Camera_in_window, KeyFramesArePlayed) {
  trigger("view-front");
  trigger("add-key-frame");
  trigger("view-right");
  trigger("add-key-frame");
  trigger("view-back");
  const View_3 before = viewer().view();
  window_->player()->set_seconds(0.1);
  trigger("play-camera-path");
  EXPECT_TRUE(window_->player()->is_playing());
  EXPECT_LT(distance(back(), {0, 0, 1}), 0.3) << "from the first";
  ASSERT_TRUE(wait_until([&] { return !window_->player()->is_playing(); }));
  EXPECT_LT(distance(back(), {1, 0, 0}), 1e-6);
  trigger("previous-view");
  EXPECT_TRUE(is_nearly_equal(viewer().view(), before));

  trigger("loop-camera-path");
  trigger("play-camera-path");
  QTest::qWait(400);
  EXPECT_TRUE(window_->player()->is_playing()) << "on and on";
  trigger("play-camera-path");
  EXPECT_FALSE(window_->player()->is_playing());
  trigger("play-camera-path");
  const QPoint middle = viewer().rect().center();
  drag(Qt::LeftButton, middle, middle + QPoint(60, 20));
  EXPECT_FALSE(window_->player()->is_playing()) << "the mouse takes the camera";
  trigger("play-camera-path");
  trigger("escape");
  EXPECT_FALSE(window_->player()->is_playing());
}

TEST_F(Camera_in_window, TheCuttingPlaneIsMovedByItsArrow) {
  trigger("view-front");
  trigger("view-isometric");
  trigger("cutting-plane");
  trigger("plane-x");
  const Plane_frame_3 frame = window_->plane()->frame().value();
  EXPECT_LT(distance(frame.normal, {1, 0, 0}), 1e-12);
  EXPECT_NEAR(viewer().view().cutting_plane->point.x, 0, 1e-9);
  const auto seen_on_the_right = [&] { return viewer().pick(pixel_of({0.7, 0.0, 0.7}), 0); };
  EXPECT_FALSE(seen_on_the_right() && seen_on_the_right()->place.x > 0.01);
  const QPointF cut_away = pixel_of({0.95, 0.0, 0.0});
  EXPECT_EQ(color_at(cut_away), QColor(Qt::white)) << "what the plane cut away is not painted";

  const QPoint tip = pixel_of(frame.tip()).toPoint();
  EXPECT_EQ(window_->plane()->part_at(tip), Plane_handle_3::Part::arrow);
  const Camera_3 camera = viewer().view().camera;
  drag(Qt::LeftButton, tip, pixel_of(frame.tip() + Point_3{0.5, 0, 0}).toPoint());
  EXPECT_TRUE(is_nearly_equal(viewer().view().camera, camera)) << "the camera does not follow";
  EXPECT_NEAR(viewer().view().cutting_plane->point.x, 0.5, 0.02);
  EXPECT_LT(distance(viewer().view().cutting_plane->normal, {1, 0, 0}), 1e-9);
  EXPECT_NE(color_at(pixel_of({0.3, 0.3, 0.9})), QColor(Qt::white));
  trigger("previous-view");
  EXPECT_NEAR(viewer().view().cutting_plane->point.x, 0, 1e-9);

  wheel(viewer().rect().center(), 2, Qt::ControlModifier);
  EXPECT_GT(viewer().view().cutting_plane->point.x, 0.01);
  EXPECT_TRUE(is_nearly_equal(viewer().view().camera, camera));
  trigger("previous-view");
  EXPECT_NEAR(viewer().view().cutting_plane->point.x, 0, 1e-9);
}

TEST_F(Camera_in_window, TheCuttingPlaneIsTurnedByItsFrame) {
  trigger("view-isometric");
  trigger("plane-z");
  const Plane_frame_3 frame = window_->plane()->frame().value();
  const QPoint side = pixel_of(frame.center + frame.right - 0.4 * frame.up).toPoint();
  ASSERT_EQ(window_->plane()->part_at(side), Plane_handle_3::Part::frame);
  drag(Qt::LeftButton, side, side + QPoint(60, 0));
  const Cutting_plane_3 plane = viewer().view().cutting_plane.value();
  EXPECT_GT(distance(plane.normal, {0, 0, 1}), 0.1);
  EXPECT_LT(std::abs(dot(plane.normal, plane.point)), 1e-9) << "about its middle";
}

TEST_F(Camera_in_window, PlaneActionsAlignAndFlip) {
  trigger("plane-view");
  EXPECT_LT(distance(viewer().view().cutting_plane->normal, back()), 1e-9);
  EXPECT_TRUE(window_->actions()["cutting-plane"]->isChecked());
  trigger("plane-flip");
  EXPECT_LT(distance(viewer().view().cutting_plane->normal, -1.0 * back()), 1e-9);
  trigger("plane-y");
  EXPECT_LT(distance(viewer().view().cutting_plane->normal, {0, 1, 0}), 1e-9);
  trigger("cutting-plane");
  EXPECT_FALSE(viewer().view().cutting_plane);
  EXPECT_FALSE(window_->actions()["plane-flip"]->isEnabled());
  trigger("cutting-plane");
  EXPECT_LT(distance(viewer().view().cutting_plane->normal, {0, 1, 0}), 1e-9) << "the last one is back";
}

TEST_F(Camera_in_window, ThePlaneByNumbers) {
  trigger("plane-x");
  trigger("plane-settings");
  ASSERT_NE(window_->popover(), nullptr);
  const auto field = [&](const char* name) {
    for (Number_field* candidate : window_->popover()->findChildren<Number_field*>())
      if (candidate->accessibleName() == QLatin1String(name)) return candidate;
    return static_cast<Number_field*>(nullptr);
  };
  const auto type = [&](const char* name, const char* text) {
    Number_field* into = field(name);
    ASSERT_NE(into, nullptr) << name;
    into->selectAll();
    QTest::keyClicks(into, text);
    QTest::keyClick(into, Qt::Key_Return);
  };
  EXPECT_EQ(field("Distance")->value(), 0);
  EXPECT_EQ(field("Normal x")->value(), 1);
  EXPECT_EQ(field("Thickness")->value(), std::nullopt);
  type("Distance", "0.25");
  EXPECT_NEAR(viewer().view().cutting_plane->point.x, 0.25, 1e-9);
  type("Thickness", "0.5");
  EXPECT_EQ(viewer().view().cutting_plane->thickness, 0.5);
  // The slab from 0 to 0.5 only.
  viewer().look_from({0, 0, 1});
  EXPECT_EQ(color_at(pixel_of({-0.2, 0.2, 0})), QColor(Qt::white));
  EXPECT_NE(color_at(pixel_of({0.25, 0.2, 0})), QColor(Qt::white));
  EXPECT_EQ(color_at(pixel_of({0.7, 0.2, 0})), QColor(Qt::white));
  trigger("plane-y");
  EXPECT_EQ(field("Normal y")->value(), 1);
  EXPECT_EQ(viewer().view().cutting_plane->thickness, 0.5) << "the slab stays one";
  trigger("cutting-plane");
  EXPECT_TRUE(wait_until([&] { return window_->popover() == nullptr; })) << "closes with the plane";
}

TEST_F(Camera_in_window, TurningUploadsNothingWithAPlaneToo) {
  trigger("cutting-plane");
  viewer().grab_picture();
  const std::size_t bytes = viewer().uploaded_bytes();
  // Beside arrow and frame.
  const QPoint corner(15, 15);
  const View_3 before = viewer().view();
  for (int i = 0; i < 20; ++i) {
    drag(Qt::LeftButton, corner, corner + QPoint(11, 5));
    viewer().grab_picture();
  }
  EXPECT_FALSE(is_nearly_equal(viewer().view().camera, before.camera));
  EXPECT_EQ(viewer().uploaded_bytes(), bytes);
}

TEST_F(Camera_in_window, AnExportedPictureIsCutAsTheWindowIs) {
  trigger("view-front");
  trigger("plane-x");
  const QString path = folder_.filePath("cut.png");
  window_->files().export_picture(path, {window_->computation().scene({255, 255, 255}), {}, viewer().view()},
                                  {300, 300});
  ASSERT_TRUE(wait_until_idle());
  const QImage picture(path);
  EXPECT_EQ(picture.pixelColor(200, 150), QColor(Qt::white));
  EXPECT_NE(picture.pixelColor(100, 150), QColor(Qt::white));
}

}  // namespace
}  // namespace mesecina
