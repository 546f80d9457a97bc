// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QTest>

#include "example_scenes.h"
#include "layers/canvas_2.h"

namespace mesecina {
namespace {

class Gl_upload : public testing::Test {
 protected:
  void SetUp() override {
    canvas_.resize(400, 300);
    canvas_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas_));
    ASSERT_TRUE(canvas_.uses_opengl()) << canvas_.backend_name().toStdString();
    scene_ = example_scene();
    for (Scene_layer& layer : scene_.layers) {
      layer.style.value = "number";
      layer.cut = Cut{"number", 0};
    }
    show({{50, 40}, 3});
    EXPECT_GT(canvas_.uploaded_bytes(), 500U);
  }

  void show(const View_2& view) {
    canvas_.set_scene(scene_);
    canvas_.set_view(view);
    picture_ = canvas_.grab_picture();
  }

  Canvas_2 canvas_{Canvas_2::Backend::opengl};
  Scene scene_;
  QImage picture_;
};

TEST_F(Gl_upload, PanAndZoomSendNothing) {
  const std::size_t before = canvas_.uploaded_bytes();
  QImage last = picture_;
  for (int i = 1; i <= 100; ++i) {
    show({{50 + 0.3 * i, 40}, 3 * (1 + 0.05 * i)});
    EXPECT_NE(picture_, last) << "step " << i << " changed nothing";
    last = picture_;
  }
  EXPECT_EQ(canvas_.uploaded_bytes(), before);
}

TEST_F(Gl_upload, CutThresholdsRangeAndStyleSendNothing) {
  const std::size_t before = canvas_.uploaded_bytes();
  const QImage all = picture_;
  for (int i = 0; i < 100; ++i) {
    for (Scene_layer& layer : scene_.layers) layer.cut->minimum = 0.25 * i;
    show(canvas_.view());
  }
  EXPECT_NE(picture_, all);
  for (int i = 0; i < 100; ++i) {
    for (Scene_layer& layer : scene_.layers) {
      Style& style = layer.style;
      layer.cut->minimum = 0;
      style.range_maximum = 1 + i;
      style.threshold_minimum = 0.05 * i;
      style.threshold_maximum = 30 - 0.1 * i;
      style.color_map_reversed = i % 2 == 0;
      style.line_width = 1 + 0.1 * i;
      style.opacity = 1 - 0.005 * i;
    }
    show(canvas_.view());
  }
  EXPECT_NE(picture_, all);
  EXPECT_EQ(canvas_.uploaded_bytes(), before);
}

TEST_F(Gl_upload, FilledAndOutlinedAreUploadedOnceEach) {
  const auto toggle = [&] {
    for (Scene_layer& layer : scene_.layers) layer.style.filled = !layer.style.filled;
    show(canvas_.view());
  };
  toggle();
  toggle();
  const std::size_t before = canvas_.uploaded_bytes();
  toggle();
  toggle();
  EXPECT_EQ(canvas_.uploaded_bytes(), before);
}

TEST_F(Gl_upload, OnlyTheNewSetIsSent) {
  const std::size_t before = canvas_.uploaded_bytes();
  auto set = std::make_shared<Primitive_set>();
  set->points.push_back(add_vertex(*set, 50, 40));
  scene_.layers.push_back(make_layer("new", set, {}));
  show(canvas_.view());
  EXPECT_EQ(canvas_.uploaded_bytes(), before + 2 * sizeof(float));
}

TEST_F(Gl_upload, PanningNextToAHugeCircleSendsNothing) {
  auto set = std::make_shared<Primitive_set>();
  set->balls.push_back({add_vertex(*set, 50, 40 + 1e9), 1e9});
  set->segments.push_back({add_vertex(*set, -1e9, 40), add_vertex(*set, 1e9, 41)});
  scene_.layers.push_back(make_layer("huge", set, {}));
  show(canvas_.view());
  const std::size_t before = canvas_.uploaded_bytes();
  for (int i = 1; i <= 100; ++i) show({{50 + 2.0 * i, 40}, 3});
  EXPECT_EQ(canvas_.uploaded_bytes(), before);
}

TEST_F(Gl_upload, ASetAtTheAddressOfAnOldOneIsUploaded) {
  const QImage with_nothing_else = picture_;
  for (int i = 0; i < 20; ++i) {
    // Freed before the next is made, which often gets the same address.
    auto set = std::make_shared<Primitive_set>();
    set->balls.push_back({add_vertex(*set, 50, 40), 2.0 + i});
    Scene scene;
    scene.layers.push_back(make_layer("ball", set, {255, 0, 0}));
    scene.layers[0].style.filled = true;
    set.reset();
    canvas_.set_scene(std::move(scene));
    picture_ = canvas_.grab_picture();
    const double ratio = canvas_.devicePixelRatioF();
    const auto at = [&](double x) { return picture_.pixelColor((QPointF(x, 150) * ratio).toPoint()); };
    EXPECT_LT(at(200 + 3 * (1.0 + i)).green(), 5) << i;
    EXPECT_EQ(at(200 + 3 * (2.5 + i)), QColor(Qt::white)) << i;
    canvas_.set_scene({});
  }
}

}  // namespace
}  // namespace mesecina
