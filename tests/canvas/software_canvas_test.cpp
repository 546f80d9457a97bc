// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QOpenGLWidget>
#include <QPainter>
#include <QTest>

#include "example_scenes.h"
#include "layers/canvas_2.h"
#include "layers/painter_canvas.h"
#include "layers/software_pictures.h"
#include "picture_comparison.h"

namespace mesecina {
namespace {

/// Squares of two triangles each, with gaps between them, or their edges.
Scene squares(int count, bool is_filled) {
  auto set = std::make_shared<Primitive_set>();
  for (int i = 0; i < count; ++i) {
    const double x = 10 * (i % 20);
    const double y = 10 * (i / 20);
    const int first = add_vertex(*set, x, y);
    add_vertex(*set, x + 8, y);
    add_vertex(*set, x + 8, y + 8);
    add_vertex(*set, x, y + 8);
    set->triangles.push_back({first, first + 1, first + 2});
    set->triangles.push_back({first, first + 2, first + 3});
  }
  Scene scene;
  scene.layers.push_back(make_layer("squares", set, {0, 0, 120}));
  scene.layers[0].style.filled = is_filled;
  return scene;
}

class Software_canvas : public testing::Test {
 protected:
  void SetUp() override {
    if (!canvas_.backend_name().startsWith("QPainter, OpenGL in software: "))
      GTEST_SKIP() << "drawn by " << canvas_.backend_name().toStdString();
    canvas_.resize(400, 300);
    canvas_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas_));
    canvas_.fit({{0, 0, 0}, {200, 100, 0}});
  }

  QImage painted() const {
    const double ratio = canvas_.devicePixelRatioF();
    QImage image((QSizeF(canvas_.size()) * ratio).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    QPainter painter(&image);
    paint_scene(painter, canvas_.scene(), canvas_.view(), canvas_.width(), canvas_.height());
    return image;
  }

  QImage shown() {
    return canvas_.findChildren<QWidget*>().first()->grab().toImage().convertToFormat(QImage::Format_RGB32);
  }

  Canvas_2 canvas_;
};

TEST_F(Software_canvas, LinesArePaintedWithoutOpengl) {
  EXPECT_EQ(canvas_.findChild<QOpenGLWidget*>(), nullptr);
  canvas_.set_scene(squares(200, false));
  EXPECT_TRUE(same_picture(canvas_.grab_picture(), painted(), "software_lines", 0, 0));
  EXPECT_EQ(canvas_.uploaded_bytes(), 0U);
}

TEST_F(Software_canvas, ManyFilledTrianglesArePaintedByOpenglAndLookTheSame) {
  canvas_.set_scene(squares(200, true));
  const QImage picture = canvas_.grab_picture();
  EXPECT_GT(canvas_.uploaded_bytes(), 0U) << "OpenGL was not used";
  EXPECT_TRUE(same_picture(picture, painted(), "software_triangles"));
  canvas_.set_scene(squares(10, true));
  const std::size_t before = canvas_.uploaded_bytes();
  EXPECT_TRUE(same_picture(canvas_.grab_picture(), painted(), "software_few_triangles", 0, 0));
  EXPECT_EQ(canvas_.uploaded_bytes(), before) << "few triangles are sooner painted by QPainter";
}

TEST_F(Software_canvas, AnotherSizeIsPaintedWhole) {
  canvas_.set_scene(squares(200, true));
  canvas_.grab_picture();
  canvas_.resize(520, 360);
  EXPECT_TRUE(same_picture(canvas_.grab_picture(), painted(), "software_resized"));
}

TEST_F(Software_canvas, HoveringPaintsOnlyWhatIsAbove) {
  canvas_.set_scene(squares(200, true));
  const QImage without = canvas_.grab_picture();
  const std::size_t before = canvas_.uploaded_bytes();
  auto overlay = std::make_shared<Primitive_set>();
  overlay->points.push_back(add_vertex(*overlay, 100, 50));
  canvas_.set_overlay({make_layer("overlay", overlay, {255, 0, 0})});
  EXPECT_NE(canvas_.grab_picture(), without);
  EXPECT_EQ(canvas_.uploaded_bytes(), before);
}

TEST_F(Software_canvas, AVeryLargeSceneFollowsTheViewAndIsExactAtRest) {
  auto set = std::make_shared<Primitive_set>();
  for (int i = 0; i < 60000; ++i) set->points.push_back(add_vertex(*set, (i % 300) / 1.5, (i * 7 % 1000) / 10.0));
  Scene scene;
  scene.layers.push_back(make_layer("points", set, {0, 0, 120}));
  canvas_.set_scene(scene);
  canvas_.grab_picture();
  canvas_.zoom(1.7);
  const QImage exact = painted();
  EXPECT_NE(shown(), exact) << "painted exactly while moving";
  EXPECT_TRUE(QTest::qWaitFor([&] { return shown() == exact; }));
}

TEST(Sooner_by_opengl, IsSaidOfWhatQpainterFillsSlowly) {
  EXPECT_TRUE(is_sooner_by_opengl(squares(200, true)));
  EXPECT_FALSE(is_sooner_by_opengl(squares(200, false)));
  EXPECT_FALSE(is_sooner_by_opengl(squares(10, true)));
  Scene hidden = squares(200, true);
  hidden.layers[0].style.visible = false;
  EXPECT_FALSE(is_sooner_by_opengl(hidden));
  auto disks = std::make_shared<Primitive_set>();
  for (int i = 0; i < 500; ++i) disks->balls.push_back({add_vertex(*disks, i, i), 1});
  Scene scene;
  scene.layers.push_back(make_layer("disks", disks, {0, 0, 120}));
  scene.layers[0].style.filled = true;
  EXPECT_FALSE(is_sooner_by_opengl(scene));
  scene.layers[0].style.opacity = 0.5;
  EXPECT_TRUE(is_sooner_by_opengl(scene));
}

}  // namespace
}  // namespace mesecina
