// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "example_scenes.h"
#include "layers/canvas_2.h"
#include "layers/painter_canvas.h"
#include "picture_comparison.h"

namespace mesecina {
namespace {

QImage painted(const Canvas_2& canvas) {
  QImage image(canvas.size(), QImage::Format_RGB32);
  QPainter painter(&image);
  paint_scene(painter, canvas.scene(), canvas.view(), canvas.width(), canvas.height());
  paint_color_bars(painter, canvas.scene(), canvas.width(), canvas.height());
  return image;
}

TEST(Painter_canvas, TakesOverWhereThereIsNoOpengl) {
  for (auto backend : {Canvas_2::Backend::automatic, Canvas_2::Backend::opengl}) {
    Canvas_2 canvas(backend);
    QSignalSpy failed(&canvas, &Canvas_2::backend_failed);
    EXPECT_FALSE(canvas.uses_opengl());
    EXPECT_TRUE(canvas.backend_name().startsWith("QPainter (no OpenGL: ")) << canvas.backend_name().toStdString();
    ASSERT_TRUE(failed.count() == 1 || failed.wait());
    EXPECT_FALSE(failed[0][0].toString().isEmpty());
    canvas.resize(320, 240);
    canvas.set_scene(example_scene());
    canvas.fit(every_kind()->bounding_box());
    EXPECT_TRUE(same_picture(canvas.grab_picture(), painted(canvas), "painter_canvas", 0, 0));
    EXPECT_EQ(canvas.uploaded_bytes(), 0U);
  }
}

TEST(Painter_canvas, TheEnvironmentChoosesQuietly) {
  qputenv("MESECINA_CANVAS", "painter");
  Canvas_2 canvas;
  qunsetenv("MESECINA_CANVAS");
  QSignalSpy failed(&canvas, &Canvas_2::backend_failed);
  EXPECT_EQ(canvas.backend_name(), QString("QPainter"));
  EXPECT_FALSE(failed.wait(50));
}

TEST(Painter_canvas, LargeScenesAreExactAgainWhenTheViewRests) {
  auto set = std::make_shared<Primitive_set>();
  for (int i = 0; i < 30000; ++i) set->points.push_back(add_vertex(*set, i % 300, i / 300));
  Scene scene;
  scene.layers.push_back(make_layer("points", set, {0, 0, 120}));
  scene.layers[0].style.point_size = 2;
  Canvas_2 canvas(Canvas_2::Backend::painter);
  canvas.resize(320, 240);
  canvas.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
  canvas.set_scene(scene);
  canvas.fit(set->bounding_box());
  canvas.grab_picture();
  QWidget* surface = canvas.findChildren<QWidget*>().first();
  canvas.zoom(1.7);
  const QImage moving = surface->grab().toImage().convertToFormat(QImage::Format_RGB32);
  const QImage exact = painted(canvas);
  EXPECT_NE(moving, exact) << "painted exactly while moving";
  EXPECT_TRUE(
      QTest::qWaitFor([&] { return surface->grab().toImage().convertToFormat(QImage::Format_RGB32) == exact; }));
}

/// Points in rows of 400.
Scene scene_of_points(int count, Color color) {
  auto set = std::make_shared<Primitive_set>();
  for (int i = 0; i < count; ++i) set->points.push_back(add_vertex(*set, i % 400, i / 400));
  Scene scene;
  scene.layers.push_back(make_layer("points", set, color));
  scene.layers[0].style.point_size = 2;
  return scene;
}

TEST(Painter_canvas, VeryLargeScenesArePaintedWhileTheWindowGoesOn) {
  constexpr int many = 100000;
  Canvas_2 canvas(Canvas_2::Backend::painter);
  canvas.resize(320, 240);
  canvas.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
  QWidget* surface = canvas.findChildren<QWidget*>().first();
  const auto shown = [&] { return surface->grab().toImage().convertToFormat(QImage::Format_RGB32); };
  const Scene blue = scene_of_points(many, {0, 0, 120});
  const Scene red = scene_of_points(many, {200, 0, 0});
  canvas.set_scene(blue);
  canvas.fit(blue.layers[0].primitives->bounding_box());
  // The first time there is nothing but paper to show.
  const QImage before = shown();
  EXPECT_EQ(before.pixelColor(160, 120), QColor(Qt::white));
  const auto middle = [&] { return shown().pixelColor(160, 120); };
  EXPECT_TRUE(QTest::qWaitFor([&] { return middle().blue() > middle().red() + 50; }));
  // Then the last picture, until the new one is there.
  canvas.set_scene(red);
  EXPECT_GT(middle().blue(), middle().red() + 50);
  EXPECT_TRUE(QTest::qWaitFor([&] { return middle().red() > middle().blue() + 50; }));
  const QImage finished = shown();
  EXPECT_EQ(finished, canvas.grab_picture());
  // Who asks for the picture gets that of the newest scene, and nothing older comes after it.
  canvas.set_scene(blue);
  shown();
  canvas.set_scene(red);
  EXPECT_EQ(canvas.grab_picture(), finished);
  QTest::qWait(300);
  EXPECT_EQ(shown(), finished);
}

TEST(Painter_canvas, GoesWhileItPaintsInTheBackground) {
  Canvas_2 canvas(Canvas_2::Backend::painter);
  canvas.resize(320, 240);
  canvas.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas));
  const Scene scene = scene_of_points(200000, {0, 0, 120});
  canvas.set_scene(scene);
  canvas.fit(scene.layers[0].primitives->bounding_box());
  canvas.findChildren<QWidget*>().first()->grab();
}

}  // namespace
}  // namespace mesecina
