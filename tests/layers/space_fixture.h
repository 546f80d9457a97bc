// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "layers/egl_context.h"
#include "layers/gl_renderer_3.h"

namespace mesecina::test {

/// RGBA, rows from above.
struct Pixels {
  int width = 0;
  int height = 0;
  std::vector<std::array<std::uint8_t, 4>> data;

  const std::array<std::uint8_t, 4>& at(int column, int row) const {
    return data[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  }
  bool operator==(const Pixels&) const = default;
};

/// A renderer without a window. Tests are skipped where there is no EGL.
class Space_renderer : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// One sample per pixel and no outlines, unless the frame says otherwise.
  Pixels paint(const Scene& scene, const View_3& view, Frame_3 frame) const;
  static Frame_3 plain_frame(int width, int height);

  Gl_renderer_3& renderer() const { return *renderer_; }

 private:
  std::unique_ptr<Egl_context> context_;
  std::unique_ptr<Gl_renderer_3> renderer_;
};

/// From +z on the plane z = 0, which shows this much of it from bottom to top.
View_3 view_along_z(Camera_3::Projection projection, double height = 4);

/// A square with this half side in the plane at z, around the z axis, of two triangles.
Primitive_set square_at(double z, double half_side);
/// With side 2 around the origin, of 12 triangles seen from outside; without its first `missing` ones.
Primitive_set cube(std::size_t missing = 0);

}  // namespace mesecina::test
