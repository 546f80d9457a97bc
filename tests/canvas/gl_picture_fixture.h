// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <string>

#include "layers/canvas_2.h"

namespace mesecina {

/// An OpenGL canvas in a window, whose pictures are compared with those of the painter.
class Gl_picture : public testing::Test {
 protected:
  static constexpr int width = 640;
  static constexpr int height = 480;
  static inline const View_2 whole{{50, 40}, 5.5};

  void SetUp() override;

  /// The painter's picture, `ratio` device pixels per logical one.
  static QImage painted(const Scene& scene, const View_2& view, double ratio = 1);
  QImage drawn(const Scene& scene, const View_2& view);
  /// That OpenGL and the painter agree, and that there is something to see.
  void compare(const Scene& scene, const View_2& view, const std::string& name);

  Canvas_2 canvas_{Canvas_2::Backend::opengl};
};

}  // namespace mesecina
