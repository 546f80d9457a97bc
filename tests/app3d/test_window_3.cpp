// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QLabel>
#include <cmath>

#include "core/view_3.h"
#include "tests/app3d/window_fixture_3.h"

namespace mesecina {
namespace {

TEST_F(Window_3, StartsWithALiveExample) {
  ASSERT_TRUE(wait_until_idle());
  EXPECT_TRUE(window_->windowTitle().contains("Example"));
  ASSERT_NE(window_->computation().primitives("scale-axis"), nullptr);
  const QImage picture = viewer().grab_picture();
  int painted = 0;
  for (int x = 0; x < picture.width(); x += 4)
    for (int y = 0; y < picture.height(); y += 4) painted += picture.pixelColor(x, y) != QColor(Qt::white);
  EXPECT_GT(painted, picture.width() * picture.height() / 16 / 8);
  EXPECT_TRUE(window_->messages().lines().isEmpty()) << window_->messages().lines().join("\n").toStdString();
}

TEST_F(Window_3, ActionsHaveNamesTipsAndKeysOfTheirOwn) {
  EXPECT_TRUE(window_->actions().faults().isEmpty()) << window_->actions().faults().join("\n").toStdString();
}

TEST_F(Window_3, StartsWithTheViewThatWasAskedFor) {
  Startup startup{{write("one.cin", "0 0 0 1\n")}, {"given-balls"}, {}};
  View_3 wanted;
  wanted.camera.position = {3, 4, 0};
  wanted.camera.target = {0, 1, 0};
  wanted.cutting_plane = Cutting_plane_3{{0, 0.25, 0}, {0, 1, 0}, std::nullopt};
  startup.seen_3 = Seen_3{wanted, {wanted.camera, wanted.camera}};
  open(startup);
  ASSERT_TRUE(wait_until_idle());
  ASSERT_TRUE(wait_until([&] { return window_->computation().primitives("given-balls") != nullptr; }));
  const View_3 seen = viewer().view();
  EXPECT_LT(distance(seen.camera.position, wanted.camera.position), 1e-5);
  EXPECT_LT(distance(seen.camera.target, wanted.camera.target), 1e-5);
  EXPECT_EQ(seen.cutting_plane, wanted.cutting_plane);
  EXPECT_EQ(window_->player()->key_frames().size(), 2U);

  // Other data is shown as a whole again.
  window_->files().open({QString::fromStdString(write("far.cin", "90 0 0 1\n").string())}, false);
  ASSERT_TRUE(wait_until_idle());
  EXPECT_LT(distance(viewer().view().camera.target, {90, 0, 0}), 1);
}

TEST_F(Window_3, OrbitPanAndZoomUploadNothing) {
  open_ball();
  const std::size_t bytes = viewer().uploaded_bytes();
  EXPECT_GT(bytes, 0U);
  const QPoint middle = viewer().rect().center();
  const View_3 before = viewer().view();
  drag(Qt::LeftButton, middle, middle + QPoint(60, 20));
  viewer().grab_picture();
  const View_3 turned = viewer().view();
  EXPECT_GT(distance(turned.camera.position, before.camera.position), 0.1);
  EXPECT_NEAR(distance(turned.camera.position, turned.camera.target),
              distance(before.camera.position, before.camera.target), 1e-6);
  drag(Qt::MiddleButton, middle, middle + QPoint(50, 0));
  viewer().grab_picture();
  EXPECT_GT(distance(viewer().view().camera.target, turned.camera.target), 0.05);
  viewer().zoom(2);
  viewer().grab_picture();
  EXPECT_EQ(viewer().uploaded_bytes(), bytes);
}

TEST_F(Window_3, TheWheelZoomsAboutTheCursor) {
  open_ball();
  for (const auto projection : {Camera_3::Projection::perspective, Camera_3::Projection::orthographic}) {
    viewer().set_projection(projection);
    viewer().grab_picture();
    const QPointF pixel(viewer().width() / 2.0 + 40, viewer().height() / 2.0 - 30);
    const auto before = viewer().pick(pixel, 0);
    ASSERT_TRUE(before);
    const double height = viewer().view().camera.height_at_target();
    QWheelEvent wheel(pixel, viewer().mapToGlobal(pixel), {}, QPoint(0, 120), Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&viewer(), &wheel);
    EXPECT_LT(viewer().view().camera.height_at_target(), 0.95 * height);
    const auto after = viewer().pick(pixel, 0);
    ASSERT_TRUE(after);
    EXPECT_LT(distance(before->place, after->place), 0.02);
  }
}

TEST_F(Window_3, ProjectionsShowTheSameAroundThePivot) {
  open_ball();
  const double height = viewer().view().camera.height_at_target();
  viewer().set_projection(Camera_3::Projection::orthographic);
  EXPECT_NEAR(viewer().view().camera.height, height, 1e-6 * height);
  viewer().set_projection(Camera_3::Projection::perspective);
  EXPECT_NEAR(viewer().view().camera.height_at_target(), height, 1e-6 * height);
}

TEST_F(Window_3, AViewIsSetAsItWasRead) {
  open_ball();
  for (const auto projection : {Camera_3::Projection::perspective, Camera_3::Projection::orthographic}) {
    View_3 view;
    view.camera = fit_camera(bounding_box(window_->document().inputs()), 400, 300, {1, 2, 3}, {0, 0, 1}, projection);
    view.cutting_plane = Cutting_plane_3{{0, 0, 0.1}, {0, 1, 0}, 0.5};
    viewer().set_view(view);
    const View_3 set = viewer().view();
    EXPECT_LT(distance(set.camera.target, view.camera.target), 1e-6);
    EXPECT_NEAR(set.camera.height_at_target(), view.camera.height_at_target(), 1e-6);
    EXPECT_LT(distance(set.camera.axes().up, view.camera.axes().up), 1e-6);
    EXPECT_LT(distance(set.camera.axes().back, view.camera.axes().back), 1e-6);
    EXPECT_EQ(set.cutting_plane, view.cutting_plane);
  }
}

TEST_F(Window_3, RestingOnABallTellsWhatItIs) {
  open_ball();
  hover(viewer().rect().center());
  ASSERT_TRUE(wait_until([&] { return window_->hover()->hovered().has_value(); }));
  EXPECT_TRUE(window_->hover()->text().contains("radius: 1")) << window_->hover()->text().toStdString();
  auto* facts = viewer().findChild<QLabel*>("facts");
  ASSERT_NE(facts, nullptr);
  EXPECT_TRUE(facts->isVisible());
  hover({3, 3});
  EXPECT_TRUE(wait_until([&] { return !window_->hover()->hovered(); }));
  EXPECT_FALSE(facts->isVisible());
}

TEST_F(Window_3, StandardViewsLookFromWhereTheySay) {
  open_ball();
  window_->actions()["view-right"]->trigger();
  EXPECT_LT(distance(viewer().view().camera.axes().back, {1, 0, 0}), 1e-6);
  window_->actions()["view-top"]->trigger();
  EXPECT_LT(distance(viewer().view().camera.axes().back, {0, 1, 0}), 1e-6);
  EXPECT_LT(distance(viewer().view().camera.axes().up, {0, 0, -1}), 1e-6);
}

TEST_F(Window_3, ABadFileChangesNothingAndIsTold) {
  ASSERT_TRUE(wait_until_idle());
  const Inputs before = window_->document().inputs();
  window_->files().open({QString::fromStdString(write("bad.off", "OFF\n3 1 0\n0 0 0\n"))}, false);
  ASSERT_TRUE(wait_until_idle());
  EXPECT_TRUE(window_->document().inputs() == before);
  EXPECT_EQ(window_->messages().lines().size(), 1);
}

TEST_F(Window_3, ExportsThePictureThatIsShown) {
  open_ball();
  const QString path = folder_.filePath("ball.png");
  window_->files().export_picture(path, {window_->computation().scene({255, 255, 255}), {}, viewer().view()},
                                  {200, 150});
  ASSERT_TRUE(wait_until_idle());
  const QImage picture(path);
  ASSERT_EQ(picture.size(), QSize(200, 150)) << window_->messages().lines().join("\n").toStdString();
  EXPECT_EQ(picture.pixelColor(2, 2), QColor(Qt::white));
  EXPECT_NE(picture.pixelColor(100, 75), QColor(Qt::white));
}

TEST_F(Window_3, ClosesAtOnceWhileComputing) {
  Settings settings;
  window_->document().edit_settings(settings.with("delta", 0.004), "Sampling distance");
  ASSERT_TRUE(window_->computation().is_busy());
  QElapsedTimer time;
  time.start();
  window_->close();
  window_.reset();
  EXPECT_LT(time.elapsed(), 3000);
}

}  // namespace
}  // namespace mesecina
