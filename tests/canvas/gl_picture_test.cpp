// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QOpenGLWidget>
#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>

#include "example_scenes.h"
#include "gl_picture_fixture.h"
#include "layers/canvas_surface.h"
#include "picture_comparison.h"

namespace mesecina {
namespace {

TEST_F(Gl_picture, EveryKindOfPrimitive) { compare(example_scene(), whole, "every_kind"); }

TEST(Software_renderer, IsKnownByItsName) {
  for (const char* name : {"llvmpipe (LLVM 15.0.6, 256 bits)", "softpipe", "Google SwiftShader"})
    EXPECT_TRUE(is_software_renderer(name)) << name;
  for (const char* name : {"Mesa Intel(R) UHD Graphics 620 (KBL GT2)", "NVIDIA H100 PCIe/PCIe/SSE2", ""})
    EXPECT_FALSE(is_software_renderer(name)) << name;
}

TEST_F(Gl_picture, DarkBackground) {
  Scene scene = example_scene();
  scene.background = {30, 30, 40};
  compare(scene, whole, "dark_background");
}

TEST_F(Gl_picture, ThinTranslucentLines) {
  Scene scene;
  scene.layers.push_back(make_layer("lines", every_kind(), {150, 0, 0}, 0.5));
  scene.layers.back().style.line_width = 0.75;
  compare(scene, whole, "thin_lines");
}

TEST_F(Gl_picture, WideLinesHaveTheEndsOfThePainter) {
  Scene scene;
  scene.layers.push_back(make_layer("lines", every_kind(), {0, 120, 0}));
  scene.layers.back().style.line_width = 9;
  compare(scene, whole, "wide_lines");
  // Translucent lines have flat ends, so that they do not show as dots where lines meet.
  auto open_lines = std::make_shared<Primitive_set>(*every_kind());
  open_lines->triangles.clear();
  open_lines->polygon_offsets.clear();
  open_lines->values.clear();
  scene.layers.back().primitives = open_lines;
  scene.layers.back().style.opacity = 0.6;
  compare(scene, whole, "wide_flat_lines");
}

TEST_F(Gl_picture, ColorMaps) {
  for (const char* name : {"viridis", "tab10", "random", "solid", "no such map"}) {
    Scene scene;
    for (const auto& set : {every_kind(), areas()}) {
      scene.layers.push_back(make_layer("lines", set, {90, 90, 90}));
      scene.layers.back().style.value = "number";
      scene.layers.back().style.color_map = name;
      scene.layers.back().style.color_map_reversed = true;
      scene.layers.back().style.range_maximum = 20;
    }
    scene.layers.back().style.filled = true;
    compare(scene, whole, std::string("color_map_") + name);
  }
}

TEST_F(Gl_picture, InfiniteAndMissingValues) {
  auto set = std::make_shared<Primitive_set>();
  set->values.push_back({"time", "", {}});
  const double infinity = std::numeric_limits<double>::infinity();
  for (double value : {0.0, 1.0, 2.0, 3.0, infinity, -infinity, std::nan("")}) {
    set->balls.push_back({add_vertex(*set, 10 + 13.0 * static_cast<double>(set->balls.size()), 40), 5});
    set->values[0].data.push_back(value);
  }
  Scene scene;
  scene.layers.push_back(make_layer("balls", set, {}));
  Style& style = scene.layers[0].style;
  style.filled = true;
  style.value = "time";
  compare(scene, whole, "special_values");
  style.threshold_minimum = 1.5;
  compare(scene, whole, "special_values_at_least");
  const auto shown = [&](std::size_t ball) {
    const Point_2 pixel = whole.to_pixel({10 + 13.0 * static_cast<double>(ball), 40}, width, height);
    const double ratio = canvas_.devicePixelRatioF();
    return canvas_.grab_picture().pixelColor((QPointF(pixel.x, pixel.y) * ratio).toPoint()) != QColor(Qt::white);
  };
  EXPECT_FALSE(shown(1));
  EXPECT_TRUE(shown(2));
  EXPECT_TRUE(shown(4)) << "+infinity passes every minimum";
  EXPECT_FALSE(shown(6)) << "nan passes no threshold";
  style.threshold_minimum.reset();
  style.threshold_maximum = 2;
  compare(scene, whole, "special_values_at_most");
  style.threshold_maximum.reset();
  scene.layers[0].cut = Cut{"time", 3};
  compare(scene, whole, "special_values_cut");
}

TEST_F(Gl_picture, ThresholdsTellNeighbouringDoublesApart) {
  auto set = std::make_shared<Primitive_set>();
  double value = 1;
  set->values.push_back({"x", "", {}});
  for (int i = 0; i < 4; ++i) {
    set->points.push_back(add_vertex(*set, 20 + 20 * i, 40));
    set->values[0].data.push_back(value);
    value = std::nextafter(value, 2);
  }
  Scene scene;
  scene.layers.push_back(make_layer("points", set, {200, 0, 0}));
  scene.layers[0].style.point_size = 20;
  for (std::size_t i = 0; i < 4; ++i) {
    scene.layers[0].cut = Cut{"x", set->values[0].data[i]};
    compare(scene, whole, "neighbouring_doubles_" + std::to_string(i));
  }
}

TEST_F(Gl_picture, ClassesOfWholeNumbers) {
  auto set = std::make_shared<Primitive_set>();
  set->values.push_back({"class", "", {}});
  for (int i = -3; i < 12; ++i) {
    set->points.push_back(add_vertex(*set, 25 + 5 * i, 40));
    set->values[0].data.push_back(i);
  }
  Scene scene;
  scene.layers.push_back(make_layer("points", set, {}));
  scene.layers[0].style.point_size = 20;
  scene.layers[0].style.value = "class";
  scene.layers[0].style.color_map = "tab10";
  compare(scene, whole, "classes");
}

TEST_F(Gl_picture, CircleOfHugeRadius) {
  for (double radius : {1e4, 1e6, 1e9, 1e12}) {
    for (bool filled : {false, true}) {
      auto set = std::make_shared<Primitive_set>();
      const double angle = 0.7;
      set->balls.push_back({add_vertex(*set, 50 + radius * std::cos(angle), 40 + radius * std::sin(angle)), radius});
      set->balls.push_back({add_vertex(*set, 50, 30 - 3 * radius), 3 * radius});
      set->balls.push_back({add_vertex(*set, 80, 60), 8});
      // An arc that ends in the picture, one way round and the other.
      const Point_2 center{50, 50 + radius};
      const int from = add_vertex(*set, 20, center.y - std::sqrt(radius * radius - 900));
      const int to = add_vertex(*set, 70, center.y - std::sqrt(radius * radius - 400));
      set->arcs.push_back({center, radius, from, to, true});
      set->arcs.push_back(
          {{center.x, center.y + 10}, radius, add_vertex(*set, 20, 60), add_vertex(*set, 70, 60), false});
      Scene scene;
      scene.layers.push_back(make_layer("circles", set, {180, 30, 90}, filled ? 0.5 : 1));
      scene.layers[0].style.filled = filled;
      scene.layers[0].style.line_width = 3;
      compare(scene, whole, "radius_" + std::to_string(static_cast<long long>(radius)) + (filled ? "_filled" : ""));
    }
  }
}

TEST_F(Gl_picture, DeepZoom) {
  const Point_2 place{1000.123, 2000.456};
  const double unit = 1e-7;
  auto lines = std::make_shared<Primitive_set>();
  const auto add = [&](double x, double y) { return add_vertex(*lines, place.x + x * unit, place.y + y * unit); };
  lines->points.push_back(add(1, 0.5));
  lines->segments.push_back({add(-2, -1), add(2, 1.5)});
  lines->segments.push_back({add_vertex(*lines, 0, 2000.456), add_vertex(*lines, 2000.246, 2000.456)});
  lines->rays.push_back({add(-1, -1), {0.6, 0.8, 0}});
  lines->arcs.push_back({{place.x + unit, place.y}, 100, add_vertex(*lines, 0, 0), 0, true});
  lines->arcs.back().from = lines->arcs.back().to = add_vertex(*lines, place.x + unit + 100, place.y);
  lines->arcs.push_back({{place.x + 100 - unit, place.y}, 100, add(0, 0), add(0, 0), true});
  lines->arcs.back().to = lines->arcs.back().from;
  lines->balls.push_back({add(0, -1), unit});
  auto filled = std::make_shared<Primitive_set>();
  add_polygon(*filled, {{0, 0}, {5000, 0}, {5000, 2000.456}, {0, 2000.456}});
  add_polygon(*filled, {{place.x - unit, 0}, {place.x + unit, 0}, {place.x, 5000}});
  filled->triangles.push_back({add_vertex(*filled, -3000, 0), add_vertex(*filled, 0, -3000),
                               add_vertex(*filled, place.x - 2 * unit, place.y + 2 * unit)});
  Scene scene;
  scene.layers.push_back(make_layer("filled", filled, {90, 160, 220}, 0.7));
  scene.layers.back().style.filled = true;
  scene.layers.push_back(make_layer("lines", lines, {120, 0, 60}));
  scene.layers.push_back(make_layer("picture", picture(), {}, 0.5));
  for (double scale : {1e3, 1e6, 1e9})
    compare(scene, {place, scale}, "deep_zoom_" + std::to_string(static_cast<long long>(scale)));
  compare(scene, {{place.x + unit, place.y - unit}, 1.5e9}, "deep_zoom_moved");
}

TEST_F(Gl_picture, FarVerticesDoNotSpoilNearOnes) {
  auto set = std::make_shared<Primitive_set>();
  set->segments.push_back({add_vertex(*set, 20, 20), add_vertex(*set, 1e12, 3e11)});
  set->segments.push_back({add_vertex(*set, 20, 20), add_vertex(*set, 80, 60)});
  set->segments.push_back({add_vertex(*set, -1e12, -1e12 + 10), add_vertex(*set, 1e12, 1e12 + 10)});
  set->rays.push_back({add_vertex(*set, -1e9, 30), {1, 0, 0}});
  add_polygon(*set, {{10, 70}, {1e11, 50}, {30, 60}});
  Scene scene;
  scene.layers.push_back(make_layer("far", set, {0, 100, 100}));
  compare(scene, whole, "far_vertices");
  scene.layers[0].style.filled = true;
  compare(scene, whole, "far_vertices_filled");
}

TEST_F(Gl_picture, ImageReducedAndEnlarged) {
  Scene scene;
  scene.layers.push_back(make_layer("picture", picture(), {}));
  compare(scene, {{75, 60}, 30}, "image_enlarged");
  auto fine = std::make_shared<Primitive_set>();
  auto image = std::make_shared<Image>();
  image->width = image->height = 512;
  for (int i = 0; i < 512 * 512; ++i)
    for (int component : {i % 512 / 2, i / 1024, 128, 255}) image->rgba.push_back(static_cast<std::uint8_t>(component));
  fine->image = image;
  scene.layers[0].primitives = fine;
  compare(scene, {{256, 256}, 0.6}, "image_reduced");
}

TEST_F(Gl_picture, OverlayIsAboveAllLayers) {
  auto set = std::make_shared<Primitive_set>();
  set->balls.push_back({add_vertex(*set, 50, 40), 30});
  Scene_layer above = make_layer("above", set, {255, 0, 0}, 0.5);
  above.style.filled = true;
  canvas_.set_overlay({above});
  const QImage out = drawn(example_scene(), whole);
  Scene scene = example_scene();
  scene.layers.push_back(above);
  EXPECT_TRUE(same_picture(out, painted(scene, whole, canvas_.devicePixelRatioF()), "overlay"));
}

TEST_F(Gl_picture, EmptySetsAndHiddenLayersShowNothing) {
  Scene scene = example_scene();
  for (Scene_layer& layer : scene.layers) layer.style.visible = false;
  scene.layers.push_back(make_layer("nothing", nullptr, {}));
  scene.layers.push_back(make_layer("empty", std::make_shared<Primitive_set>(), {}));
  QImage blank((QSizeF(width, height) * canvas_.devicePixelRatioF()).toSize(), QImage::Format_RGB32);
  blank.fill(Qt::white);
  EXPECT_EQ(drawn(scene, whole), blank);
}

}  // namespace
}  // namespace mesecina
