// SPDX-License-Identifier: GPL-3.0-or-later
#include "space_fixture.h"

#include <epoxy/gl.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "layers/gl_objects.h"

namespace mesecina::test {

void Space_renderer::SetUp() {
  try {
    context_ = std::make_unique<Egl_context>();
  } catch (const std::runtime_error& error) {
    GTEST_SKIP() << error.what();
  }
  context_->make_current();
  renderer_ = std::make_unique<Gl_renderer_3>();
}

void Space_renderer::TearDown() {
  renderer_.reset();
  if (!context_) return;
  EXPECT_EQ(glGetError(), static_cast<unsigned>(GL_NO_ERROR));
  context_->release();
}

Frame_3 Space_renderer::plain_frame(int width, int height) {
  Frame_3 frame;
  frame.width = width;
  frame.height = height;
  frame.outlines = 0;
  return frame;
}

Pixels Space_renderer::paint(const Scene& scene, const View_3& view, Frame_3 frame) const {
  const Tile tile = frame.whole_tile();
  const Gl_target target(tile.width, tile.height);
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glViewport(0, 0, tile.width, tile.height);
  renderer_->draw(scene, {}, view, frame);
  Pixels pixels{tile.width, tile.height, {}};
  std::vector<std::array<std::uint8_t, 4>> rows(static_cast<std::size_t>(tile.width) *
                                                static_cast<std::size_t>(tile.height));
  glReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
  for (int row = tile.height - 1; row >= 0; --row)
    pixels.data.insert(pixels.data.end(), rows.begin() + std::ptrdiff_t{row} * tile.width,
                       rows.begin() + std::ptrdiff_t{row + 1} * tile.width);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return pixels;
}

View_3 view_along_z(Camera_3::Projection projection, double height) {
  View_3 view;
  view.camera.projection = projection;
  view.camera.height = height;
  const double half_angle = view.camera.field_of_view * std::numbers::pi / 360;
  view.camera.position = {0, 0, height / 2 / std::tan(half_angle)};
  return view;
}

Primitive_set square_at(double z, double half_side) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {
      {-half_side, -half_side, z}, {half_side, -half_side, z}, {half_side, half_side, z}, {-half_side, half_side, z}};
  set.triangles = {{0, 1, 2}, {0, 2, 3}};
  return set;
}

Primitive_set cube(std::size_t missing) {
  Primitive_set set;
  set.dimension = 3;
  for (int i = 0; i < 8; ++i) set.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                   std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
    set.triangles.push_back({a, b, c});
    set.triangles.push_back({a, c, d});
  }
  set.triangles.erase(set.triangles.begin(), set.triangles.begin() + static_cast<std::ptrdiff_t>(missing));
  return set;
}

}  // namespace mesecina::test
