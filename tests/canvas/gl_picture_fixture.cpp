// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl_picture_fixture.h"

#include <QPainter>
#include <QTest>

#include "layers/painter_canvas.h"
#include "picture_comparison.h"

namespace mesecina {

void Gl_picture::SetUp() {
  canvas_.resize(width, height);
  canvas_.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas_));
  ASSERT_TRUE(canvas_.uses_opengl()) << canvas_.backend_name().toStdString();
}

QImage Gl_picture::painted(const Scene& scene, const View_2& view, double ratio) {
  QImage image((QSizeF(width, height) * ratio).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  QPainter painter(&image);
  paint_scene(painter, scene, view, width, height);
  paint_color_bars(painter, scene, width, height);
  return image;
}

QImage Gl_picture::drawn(const Scene& scene, const View_2& view) {
  canvas_.set_scene(scene);
  canvas_.set_view(view);
  return canvas_.grab_picture();
}

void Gl_picture::compare(const Scene& scene, const View_2& view, const std::string& name) {
  const QImage out = drawn(scene, view);
  const QImage expected = painted(scene, view, canvas_.devicePixelRatioF());
  EXPECT_TRUE(same_picture(out, expected, name));
  QImage blank(expected.size(), QImage::Format_RGB32);
  blank.fill(Qt::white);
  EXPECT_NE(expected, blank) << name << " shows nothing";
}

}  // namespace mesecina
