// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "example_scene.h"
#include "space_fixture.h"

namespace mesecina::test {
namespace {

constexpr auto orthographic = Camera_3::Projection::orthographic;
constexpr auto perspective = Camera_3::Projection::perspective;
constexpr int side = 100;

Scene_layer square_layer(double z, double half_side, Color color, double opacity) {
  Scene_layer layer = layer_of(square_at(z, half_side));
  layer.style.filled = true;
  layer.style.color = color;
  layer.style.opacity = opacity;
  return layer;
}

/// Faces with a value each, their number.
Primitive_set squares_with_values(int count) {
  Primitive_set set;
  set.dimension = 3;
  Values number{"number", "", {}};
  for (int i = 0; i < count; ++i) {
    const double x = -1.8 + 3.6 * i / count;
    const int first = static_cast<int>(set.vertices.size());
    set.vertices.insert(set.vertices.end(), {{x, -1, 0}, {x + 3.0 / count, -1, 0}, {x, 1, 0}});
    set.triangles.push_back({first, first + 1, first + 2});
    number.data.push_back(i);
  }
  set.values.push_back(std::move(number));
  return set;
}

class Space_pictures : public Space_renderer {
 protected:
  Pixels picture(const Scene& scene, const View_3& view = view_along_z(orthographic)) {
    return paint(scene, view, plain_frame(side, side));
  }
};

using Rgb = std::array<double, 3>;

Rgb middle_of(const Pixels& pixels) {
  const auto& p = pixels.at(side / 2, side / 2);
  return {p[0] / 255.0, p[1] / 255.0, p[2] / 255.0};
}

Rgb over(const Rgb& above, double opacity, const Rgb& below) {
  Rgb result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = opacity * above[i] + (1 - opacity) * below[i];
  return result;
}

void expect_near(const Rgb& found, const Rgb& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << i;
}

TEST_F(Space_pictures, TranslucentSquaresMixAsTheirOrderInSpaceSays) {
  const std::array<Color, 4> colors{{{220, 30, 20}, {20, 190, 60}, {30, 60, 230}, {200, 200, 40}}};
  const std::array opacities{0.5, 0.4, 0.7, 0.3};
  const std::array<double, 4> heights{-0.6, 0.3, 0.9, -0.1};
  // Light makes other colours of them, which a solid square shows.
  std::array<Rgb, 4> lit{};
  std::vector<Scene_layer> layers;
  for (std::size_t i = 0; i < 4; ++i) {
    lit[i] = middle_of(picture(scene_of(square_layer(heights[i], 1, colors[i], 1))));
    layers.push_back(square_layer(heights[i], 1, colors[i], opacities[i]));
  }
  std::vector<std::size_t> order{0, 1, 2, 3};
  for (std::size_t count = 2; count <= 4; ++count) {
    std::vector<std::size_t> from_below(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count));
    std::ranges::sort(from_below, {}, [&](std::size_t i) { return heights[i]; });
    Rgb expected{1, 1, 1};
    for (const std::size_t i : from_below) expected = over(lit[i], opacities[i], expected);
    Scene scene;
    scene.layers.assign(layers.begin(), layers.begin() + static_cast<std::ptrdiff_t>(count));
    const Pixels one = picture(scene);
    expect_near(middle_of(one), expected, 2.5 / 255);
    std::ranges::reverse(scene.layers);
    EXPECT_EQ(picture(scene), one) << "the order of the layers matters";
  }
}

TEST_F(Space_pictures, TranslucentThingsAreHiddenBehindSolidOnes) {
  Scene scene = scene_of(square_layer(0.5, 1, {200, 60, 20}, 1));
  const Rgb alone = middle_of(picture(scene));
  scene.layers.push_back(square_layer(-0.5, 1, {20, 60, 200}, 0.5));
  expect_near(middle_of(picture(scene)), alone, 0.5 / 255);
  scene.layers.push_back(square_layer(0.9, 1, {20, 200, 60}, 0.5));
  const Rgb above = middle_of(picture(scene_of(square_layer(0.9, 1, {20, 200, 60}, 1))));
  expect_near(middle_of(picture(scene)), over(above, 0.5, alone), 2.5 / 255);
}

TEST_F(Space_pictures, OfLayersInOnePlaceTheLaterIsSeen) {
  for (const auto projection : {orthographic, perspective}) {
    Scene scene = scene_of(square_layer(0.2, 1.5, {200, 0, 0}, 1));
    scene.layers.push_back(square_layer(0.2, 1, {0, 200, 0}, 1));
    View_3 view = view_along_z(projection);
    view.camera.position = view.camera.position + Point_3{0.7, 0.9, 0};
    const Pixels pixels = paint(scene, view, plain_frame(side, side));
    for (int column = 30; column < 70; ++column) {
      ASSERT_LT(pixels.at(column, side / 2)[0], 40) << column;
      ASSERT_GT(pixels.at(column, side / 2)[1], 100) << column;
    }
  }
}

TEST_F(Space_pictures, OrbitingUploadsNothing) {
  Scene scene = scene_of(layer_of(squares_with_values(40)));
  scene.layers[0].style.filled = true;
  scene.layers[0].style.edges = true;
  scene.layers[0].style.value = "number";
  scene.layers.push_back(square_layer(0, 1.9, {80, 80, 200}, 0.4));
  Primitive_set balls;
  balls.dimension = 3;
  for (int i = 0; i < 50; ++i) {
    balls.vertices.push_back({std::cos(i), std::sin(i), 0.02 * i});
    balls.balls.push_back({i, 0.1});
    balls.points.push_back(i);
  }
  scene.layers.push_back(layer_of(std::move(balls)));
  scene.layers.back().style.filled = true;
  picture(scene);
  const std::size_t bytes = renderer().uploaded_bytes();
  EXPECT_GT(bytes, 1000U);
  std::size_t most_calls = 0;
  Pixels last;
  for (int i = 0; i < 100; ++i) {
    View_3 view = view_along_z(i % 2 ? perspective : orthographic);
    const double angle = 0.06 * i;
    const double away = view.camera.position.z;
    view.camera.position = {away * std::sin(angle), 0.2, away * std::cos(angle)};
    const std::size_t calls = renderer().draw_calls();
    const Pixels now = paint(scene, view, plain_frame(side, side));
    most_calls = std::max(most_calls, renderer().draw_calls() - calls);
    ASSERT_NE(now, last) << i;
    last = now;
  }
  EXPECT_EQ(renderer().uploaded_bytes(), bytes);
  EXPECT_LT(most_calls, 30U);
}

TEST_F(Space_pictures, ThresholdsAndCutsUploadNothingAndLeaveOutWhatTheyShould) {
  const Primitive_set set = squares_with_values(10);
  Scene scene = scene_of(layer_of(set));
  Scene_layer& layer = scene.layers[0];
  layer.style.filled = true;
  layer.style.value = "number";
  layer.style.color_map = "solid";
  layer.cut = Cut{"number", 0};
  const Pixels all = picture(scene);
  const std::size_t bytes = renderer().uploaded_bytes();
  layer.cut->minimum = 2.5;
  layer.style.threshold_minimum = 4;
  layer.style.threshold_maximum = 7;
  const Pixels some = picture(scene);
  EXPECT_EQ(renderer().uploaded_bytes(), bytes);
  EXPECT_NE(some, all);
  Scene_layer selected = layer_of(select(set, {false, false, false, false, true, true, true, true, false, false}));
  selected.style = layer.style;
  selected.style.value.clear();
  EXPECT_EQ(picture(scene_of(std::move(selected))), some);
}

TEST_F(Space_pictures, LinesAndPointsKeepTheirSizeInPixels) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{-5, 0.011, 0}, {5, 0.011, 0}, {0, 1, 0}};
  set.segments = {{0, 1}};
  set.points = {2};
  Scene scene = scene_of(layer_of(std::move(set)));
  scene.layers[0].style.line_width = 6;
  scene.layers[0].style.point_size = 12;
  for (const double height : {2.5, 4.0, 40.0}) {
    for (const auto projection : {orthographic, perspective}) {
      const Pixels pixels = paint(scene, view_along_z(projection, height), plain_frame(side, side));
      int dark = 0;
      for (int row = 0; row < side; ++row) dark += pixels.at(side / 2 + 10, row)[0] < 128;
      EXPECT_EQ(dark, 6) << height;
      if (height > 10) continue;
      const int row = static_cast<int>(std::floor(side / 2.0 - side / height));
      int wide = 0;
      for (int column = 0; column < side; ++column) wide += pixels.at(column, row)[0] < 128;
      EXPECT_NEAR(wide, 12, 1) << height;
    }
  }
}

TEST_F(Space_pictures, APlaneCutsOpenAndClosedSolidsAreFilledThere) {
  View_3 view = view_along_z(orthographic);
  view.cutting_plane = Cutting_plane_3{{0, 0, 0.25}, {0, 0, 2}, {}};
  const auto middle = [&](const Scene& scene) {
    return renderer().ids(scene, view, plain_frame(side, side)).find(side / 2, side / 2);
  };
  Scene closed = scene_of(layer_of(cube()));
  closed.layers[0].style.filled = true;
  auto found = middle(closed);
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->element) << "the area that was cut belongs to no element";
  EXPECT_NEAR(found->place.z, 0.25, 1e-4);
  // Beside the cube there is nothing.
  EXPECT_FALSE(renderer().ids(closed, view, plain_frame(side, side)).find(2, side / 2));

  // Through an open one its far side is seen.
  Scene open = scene_of(layer_of(cube(1)));
  open.layers[0].style.filled = true;
  found = middle(open);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->element);
  EXPECT_NEAR(found->place.z, -1, 1e-4);

  // An exempt layer is whole.
  closed.layers[0].style.sliced = false;
  EXPECT_NEAR(middle(closed)->place.z, 1, 1e-4);

  // A slab shows its near side, and from behind its other one.
  closed.layers[0].style.sliced = true;
  view.cutting_plane->thickness = 0.2;
  EXPECT_NEAR(middle(closed)->place.z, 0.35, 1e-4);
  view.camera.position = -1.0 * view.camera.position;
  EXPECT_NEAR(middle(closed)->place.z, 0.15, 1e-4);
}

TEST_F(Space_pictures, APlaneCutsBallsOpen) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices.push_back({});
  set.balls.push_back({0, 1.2});
  Scene scene = scene_of(layer_of(std::move(set)));
  scene.layers[0].style.filled = true;
  for (const auto projection : {orthographic, perspective}) {
    View_3 view = view_along_z(projection);
    view.cutting_plane = Cutting_plane_3{{0, 0, 0.3}, {0, 0, 1}, {}};
    const auto found = renderer().ids(scene, view, plain_frame(side, side)).find(side / 2, side / 2);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->element, 0U);
    EXPECT_NEAR(found->place.z, 0.3, 1e-3);
  }
}

TEST_F(Space_pictures, TilesTogetherAreThePicture) {
  Scene scene = scene_of(layer_of(cube()));
  scene.layers[0].style.filled = true;
  scene.layers[0].style.opacity = 0.6;
  scene.layers[0].style.edges = true;
  View_3 view;
  view.camera = fit_camera(drawn_box(scene), side, side);
  const Pixels whole = picture(scene, view);
  int different = 0;
  for (const Tile& tile : {Tile{0, 0, 37, 60}, Tile{37, 0, 63, 60}, Tile{0, 60, 37, 40}, Tile{37, 60, 63, 40}}) {
    Frame_3 frame = plain_frame(side, side);
    frame.tile = tile;
    const Pixels part = paint(scene, view, frame);
    for (int row = 0; row < tile.height; ++row) {
      for (int column = 0; column < tile.width; ++column) {
        const auto& found = part.at(column, row);
        const auto& expected = whole.at(tile.left + column, side - tile.bottom - tile.height + row);
        for (std::size_t i = 0; i < 3; ++i) {
          constexpr int rounding = 2;
          different += std::abs(found[i] - expected[i]) > rounding;
        }
      }
    }
  }
  // Rounding may move an edge over the middle of a pixel.
  EXPECT_LT(different, 20);
}

TEST_F(Space_pictures, CoarsePicturesShowTheSameInSquares) {
  Scene scene = scene_of(square_layer(0.2, 1.17, {200, 60, 20}, 1));
  scene.layers.push_back(square_layer(0.6, 0.83, {20, 60, 200}, 0.5));
  const Pixels fine = picture(scene);
  for (const int coarseness : {2, 4, 8}) {
    Frame_3 frame = plain_frame(side, side);
    frame.coarseness = coarseness;
    const Pixels coarse = paint(scene, view_along_z(orthographic), frame);
    EXPECT_EQ(middle_of(coarse), middle_of(fine));
    int different = 0;
    for (int row = 0; row < side; ++row) {
      for (int column = 0; column < side; ++column) {
        different += coarse.at(column, row) != fine.at(column, row);
        // Rows of OpenGL start below.
        const int row_of_square = side - 1 - (side - 1 - row) / coarseness * coarseness;
        ASSERT_EQ(coarse.at(column, row), coarse.at(column / coarseness * coarseness, row_of_square));
      }
    }
    // Only at the outlines of the two squares.
    EXPECT_GT(different, 0);
    EXPECT_LT(different, 2 * 4 * side * coarseness);
  }
}

TEST_F(Space_pictures, TheBackgroundMayBeTransparent) {
  Scene scene = scene_of(square_layer(0, 1, {200, 40, 40}, 0.5));
  scene.transparent_background = true;
  const Pixels pixels = picture(scene);
  EXPECT_EQ(pixels.at(1, 1), (std::array<std::uint8_t, 4>{0, 0, 0, 0}));
  EXPECT_NEAR(pixels.at(side / 2, side / 2)[3], 128, 1);
}

TEST_F(Space_pictures, BothSidesAreLitAlike) {
  Primitive_set set = square_at(0, 1);
  const Pixels front = picture(scene_of([&] {
    Scene_layer layer = layer_of(set);
    layer.style.filled = true;
    return layer;
  }()));
  for (auto& [a, b, c] : set.triangles) std::swap(b, c);
  Scene_layer layer = layer_of(set);
  layer.style.filled = true;
  EXPECT_EQ(picture(scene_of(std::move(layer))), front);
}

TEST_F(Space_pictures, SmoothShadingHidesTheEdgeOfTwoFaces) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{-1, -1, 0}, {0, -1, 0.5}, {1, -1, 0}, {-1, 1, 0}, {0, 1, 0.5}, {1, 1, 0}};
  set.polygon_vertices = {0, 1, 4, 3, 1, 2, 5, 4};
  set.polygon_offsets = {0, 4, 8};
  Scene scene = scene_of(layer_of(std::move(set)));
  scene.layers[0].style.filled = true;
  scene.layers[0].style.color = {200, 200, 200};
  const auto jump = [&] {
    const Pixels pixels = picture(scene);
    return std::abs(pixels.at(side / 2 - 2, side / 2)[0] - pixels.at(side / 2 + 1, side / 2)[0]);
  };
  EXPECT_GT(jump(), 12);
  scene.layers[0].style.smooth = true;
  EXPECT_LT(jump(), 6);
}

TEST_F(Space_pictures, ASetAtTheAddressOfAnOldOneIsUploaded) {
  for (int i = 0; i < 10; ++i) {
    const double size = 0.3 + 0.1 * i;
    const Pixels pixels = picture(scene_of(square_layer(0, size, {0, 0, 0}, 1)));
    int dark = 0;
    for (int column = 0; column < side; ++column) dark += pixels.at(column, side / 2)[0] < 200;
    EXPECT_NEAR(dark, 2 * size * side / 4, 1.01) << i;
  }
}

}  // namespace
}  // namespace mesecina::test
