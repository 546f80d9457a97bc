// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QImage>
#include <cmath>
#include <utility>

#include "layers/picture_formats.h"
#include "tests/layers/example_scene.h"

namespace mesecina {
namespace {

using test::layer_of;
using test::pixel_view;
using test::scene_of;

constexpr int width = 200;
constexpr int height = 100;
constexpr Color red{255, 0, 0};

/// Paints one layer in red on white, plane coordinates being pixels from the lower left corner.
class Painted {
 public:
  explicit Painted(Scene_layer layer) {
    layer.style.color = red;
    picture_ = paint_picture(scene_of(std::move(layer)), pixel_view(width, height), width, height);
  }
  /// 0 white ... 1 red, of the pixel around the point.
  double ink(double x, double y) const {
    const QColor color = picture_.pixelColor(int(std::floor(x)), int(std::floor(height - y)));
    return 1 - color.green() / 255.0;
  }
  /// Sum over the picture, in pixels.
  double area() const {
    double sum = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) sum += 1 - picture_.pixelColor(x, y).green() / 255.0;
    return sum;
  }

 private:
  QImage picture_;
};

Primitive_set with_vertices(std::vector<Point_3> vertices) {
  Primitive_set set;
  set.vertices = std::move(vertices);
  return set;
}

TEST(Painter_canvas, points_are_round_dots_of_the_given_diameter) {
  Primitive_set set = with_vertices({{50, 40, 0}});
  set.points = {0};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.point_size = 20;
  const Painted painted(std::move(layer));
  EXPECT_EQ(painted.ink(50, 40), 1);
  EXPECT_EQ(painted.ink(58.5, 40), 1);
  EXPECT_EQ(painted.ink(61.5, 40), 0);
  EXPECT_EQ(painted.ink(58.5, 48.5), 0);
  EXPECT_NEAR(painted.area(), 100 * M_PI, 3);
}

TEST(Painter_canvas, segments_have_the_given_width) {
  Primitive_set set = with_vertices({{20, 50.5, 0}, {120, 50.5, 0}});
  set.segments = {{0, 1}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.line_width = 4;
  const Painted painted(std::move(layer));
  EXPECT_EQ(painted.ink(70, 50.5), 1);
  EXPECT_EQ(painted.ink(70, 51.5), 1);
  EXPECT_EQ(painted.ink(70, 54), 0);
  EXPECT_EQ(painted.ink(15, 50.5), 0);
  EXPECT_NEAR(painted.area(), 400 + 4 * M_PI, 4);
}

TEST(Painter_canvas, rays_reach_the_border_of_the_page) {
  Primitive_set set = with_vertices({{100, 50.5, 0}, {-1e12 + 30.5, -1e12 + 20.5, 0}});
  set.rays = {{0, {1, 0, 0}}, {1, {std::sqrt(0.5), std::sqrt(0.5), 0}}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.line_width = 2;
  const Painted painted(std::move(layer));
  EXPECT_GT(painted.ink(199, 50.5), 0.9);
  EXPECT_EQ(painted.ink(95, 50.5), 0);
  EXPECT_GT(painted.ink(30.5, 20.5), 0.7);
  EXPECT_GT(painted.ink(90.5, 80.5), 0.7);
}

TEST(Painter_canvas, arcs_go_the_right_way_round) {
  Primitive_set set = with_vertices({{130, 50, 0}, {100, 80, 0}});
  set.arcs = {{{100, 50}, 30, 0, 1, true}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.line_width = 2;
  const double side = 30 * std::sqrt(0.5);
  const Painted quarter(layer);
  EXPECT_GT(quarter.ink(100 + side, 50 + side), 0.6);
  EXPECT_EQ(quarter.ink(100 - side, 50 - side), 0);
  Primitive_set other = *layer.primitives;
  other.arcs[0].counterclockwise = false;
  layer.primitives = std::make_shared<const Primitive_set>(other);
  const Painted rest(layer);
  EXPECT_EQ(rest.ink(100 + side, 50 + side), 0);
  EXPECT_GT(rest.ink(100 - side, 50 - side), 0.6);
  EXPECT_GT(rest.ink(100 + side, 50 - side), 0.6);
  other.arcs[0].to = 0;
  layer.primitives = std::make_shared<const Primitive_set>(other);
  EXPECT_NEAR(Painted(layer).area(), 2 * 2 * M_PI * 30, 12);
}

TEST(Painter_canvas, disks_are_filled_or_outlined) {
  Primitive_set set = with_vertices({{100, 50, 0}});
  set.balls = {{0, 40}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.line_width = 2;
  const Painted outline(layer);
  EXPECT_EQ(outline.ink(100, 50), 0);
  EXPECT_GT(outline.ink(139.5, 50.5), 0.8);
  EXPECT_NEAR(outline.area(), 2 * 2 * M_PI * 40, 15);
  layer.style.filled = true;
  const Painted disk(layer);
  EXPECT_EQ(disk.ink(100, 50), 1);
  EXPECT_NEAR(disk.area(), M_PI * 1600, 10);
}

TEST(Painter_canvas, huge_circles_and_disks_cross_the_page_where_they_should) {
  for (const double radius : {3e3, 1e5, 1e9, 1e12}) {
    Primitive_set set = with_vertices({{100, 50.5 - radius, 0}});
    set.balls = {{0, radius}};
    Scene_layer layer = layer_of(std::move(set));
    layer.style.line_width = 2;
    const auto top = [&](double x) { return 50.5 - (x - 100) * (x - 100) / (2 * radius); };
    const Painted circle(layer);
    for (const double x : {2.5, 50.5, 100.5, 150.5, 197.5}) {
      EXPECT_GT(circle.ink(x, top(x)), 0.6) << radius << " at " << x;
      EXPECT_EQ(circle.ink(x, top(x) + 4), 0) << radius << " at " << x;
      EXPECT_EQ(circle.ink(x, top(x) - 4), 0) << radius << " at " << x;
    }
    layer.style.filled = true;
    const Painted disk(layer);
    for (const double x : {2.5, 100.5, 197.5}) {
      EXPECT_EQ(disk.ink(x, top(x) - 2), 1) << radius << " at " << x;
      EXPECT_EQ(disk.ink(x, top(x) + 2), 0) << radius << " at " << x;
    }
    EXPECT_EQ(disk.ink(100, 0.5), 1) << radius;
  }
}

TEST(Painter_canvas, huge_arcs_end_at_their_vertices) {
  const double radius = 1e9;
  Primitive_set set = with_vertices({{50, 50.5, 0}, {150, 50.5, 0}});
  set.arcs = {{{100, 50.5 - radius}, radius, 0, 1, false}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.line_width = 2;
  const Painted painted(layer);
  EXPECT_GT(painted.ink(52.5, 50.5), 0.6);
  EXPECT_GT(painted.ink(147.5, 50.5), 0.6);
  EXPECT_NEAR(painted.area(), 200, 4) << "nothing beyond the ends";
}

TEST(Painter_canvas, a_disk_around_the_whole_page_covers_it) {
  Primitive_set set = with_vertices({{-5e11, 0, 0}});
  set.balls = {{0, 1e12}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.filled = true;
  EXPECT_EQ(Painted(layer).area(), width * height);
}

TEST(Painter_canvas, triangles_and_polygons) {
  Primitive_set set = with_vertices({{20, 10, 0}, {100, 10, 0}, {20, 90, 0}, {100, 90, 0}});
  set.triangles = {{0, 1, 2}, {1, 3, 2}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.filled = true;
  const Painted square(layer);
  EXPECT_EQ(square.area(), 80 * 80) << "no hairline along the common edge";
  layer.style.filled = false;
  layer.style.line_width = 2;
  EXPECT_GT(Painted(layer).ink(60.5, 50.5), 0.5) << "the common edge";
  EXPECT_EQ(Painted(layer).ink(40, 30), 0);

  Primitive_set rings = with_vertices(
      {{20, 10, 0}, {100, 10, 0}, {100, 90, 0}, {20, 90, 0}, {40, 30, 0}, {80, 30, 0}, {80, 70, 0}, {40, 70, 0}});
  rings.polygon_vertices = {0, 1, 2, 3, 4, 5, 6, 7};
  rings.polygon_offsets = {0, 4, 8};
  layer = layer_of(std::move(rings));
  layer.style.filled = true;
  const Painted frame(layer);
  EXPECT_EQ(frame.ink(60, 50), 0) << "the hole";
  EXPECT_EQ(frame.area(), 80 * 80 - 40 * 40);
}

TEST(Painter_canvas, huge_polygons_keep_their_inside) {
  Primitive_set set = with_vertices({{-1e12, 30, 0}, {1e12, 30, 0}, {1e12, 1e12, 0}, {-1e12, 1e12, 0}});
  set.polygon_vertices = {0, 1, 2, 3};
  set.polygon_offsets = {0, 4};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.filled = true;
  EXPECT_EQ(Painted(layer).area(), width * 70);
  layer.style.filled = false;
  layer.style.line_width = 2;
  EXPECT_EQ(Painted(layer).area(), width * 2);
}

TEST(Painter_canvas, images_lie_where_they_say) {
  Primitive_set set;
  auto image = std::make_shared<Image>();
  image->width = 2;
  image->height = 2;
  image->rgba = {255, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 255};
  image->lower_left = {20, 10};
  image->pixel_size = 30;
  set.image = image;
  Scene_layer layer = layer_of(std::move(set));
  const Painted painted(layer);
  EXPECT_EQ(painted.ink(30, 60), 1) << "upper left";
  EXPECT_EQ(painted.ink(70, 20), 1) << "lower right";
  EXPECT_EQ(painted.ink(70, 60), 0);
  EXPECT_EQ(painted.area(), 2 * 30 * 30);
  image->pixel_size = 1e9;
  image->lower_left = {100 - 1e9, 50 - 1e9};
  const Painted enlarged(layer);
  EXPECT_EQ(enlarged.ink(50, 75), 1);
  EXPECT_EQ(enlarged.ink(150, 75), 0);
  EXPECT_NEAR(enlarged.area(), width * height / 2, 2);
}

TEST(Painter_canvas, opacity_blends_each_line) {
  Primitive_set set = with_vertices({{50, 50.5, 0}, {150, 50.5, 0}, {100.5, 10, 0}, {100.5, 90, 0}});
  set.segments = {{0, 1}, {2, 3}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.line_width = 6;
  layer.style.opacity = 0.5;
  const Painted painted(layer);
  EXPECT_NEAR(painted.ink(70.5, 50.5), 0.5, 0.01);
  EXPECT_NEAR(painted.ink(100.5, 50.5), 0.75, 0.01);
}

TEST(Painter_canvas, translucent_disks_have_one_tone) {
  Primitive_set set = with_vertices({{80, 50, 0}, {120, 50, 0}, {160, 50 - 1e9, 0}});
  set.balls = {{0, 30}, {1, 30}, {2, 1e9}};
  Scene_layer layer = layer_of(set);
  layer.style.filled = true;
  layer.style.opacity = 0.5;
  const Painted painted(layer);
  for (const auto& [x, y] : {std::pair(60.0, 55.0), {100.0, 52.0}, {80.0, 40.0}, {100.0, 45.0}, {10.0, 20.0}})
    EXPECT_NEAR(painted.ink(x, y), 0.5, 0.01) << x << " " << y;
  EXPECT_EQ(painted.ink(100, 90), 0);
  set.values.push_back({"number", "", {0, 0, 1}});
  layer.primitives = std::make_shared<const Primitive_set>(set);
  layer.style.value = "number";
  layer.style.color_map = "gray";
  EXPECT_NEAR(Painted(layer).ink(60, 55), 0.5, 0.01);
  EXPECT_NEAR(Painted(layer).ink(100, 52), 0.75, 0.01) << "coloured by value, each by itself";
}

TEST(Painter_canvas, closed_arcs_are_filled_by_the_even_odd_rule) {
  // A ring, and a disk that touches it from outside.
  Primitive_set set = with_vertices({{100, 50, 0}, {80, 50, 0}, {100, 50, 0}, {30, 50, 0}});
  set.arcs = {{{60, 50}, 40, 0, 0, true}, {{60, 50}, 20, 1, 1, false}, {{115, 50}, 15, 0, 0, false}};
  // Half a circle is not closed.
  set.vertices.push_back({150, 20, 0});
  set.vertices.push_back({150, 80, 0});
  set.arcs.push_back({{150, 50}, 30, 4, 5, true});
  Scene_layer layer = layer_of(set);
  layer.style.filled = true;
  layer.style.line_width = 0;
  layer.style.opacity = 0.999;
  const Painted painted(layer);
  EXPECT_GT(painted.ink(30, 50), 0.99);
  EXPECT_EQ(painted.ink(60, 50), 0) << "the hole";
  EXPECT_GT(painted.ink(115, 50), 0.99);
  EXPECT_EQ(painted.ink(160, 50), 0);
  layer.style.line_width = 2;
  layer.style.opacity = 1;
  const double circles = 2 * M_PI * (40 + 20 + 15);
  const double half_circle = M_PI * 30;
  EXPECT_NEAR(Painted(layer).area(), M_PI * (1600 - 400 + 225) + circles + 2 * half_circle, 50)
      << "where outlines touch they overlap";
  layer.style.filled = false;
  EXPECT_NEAR(Painted(layer).area(), 2 * circles + 2 * half_circle, 50);
}

TEST(Painter_canvas, many_arcs_leave_no_seams) {
  // Small circles in a grid between two large ones, more of them than are painted in one piece.
  Primitive_set set = with_vertices({{-100, 50, 0}, {-90, 50, 0}});
  set.arcs = {{{100, 50}, 200, 0, 0, true}, {{100, 50}, 190, 1, 1, false}};
  for (int i = 0; i < 2000; ++i) {
    const Point_2 center{2.0 + 4 * (i % 50), 1.25 + 2.5 * (i / 50)};
    set.vertices.push_back({center.x + 1, center.y, 0});
    set.vertices.push_back({center.x - 1, center.y, 0});
    const int from = static_cast<int>(set.vertices.size()) - 2;
    set.arcs.push_back({center, 1, from, from + 1, true});
    set.arcs.push_back({center, 1, from + 1, from, true});
  }
  Scene_layer layer = layer_of(set);
  layer.style.filled = true;
  layer.style.opacity = 0.999;
  layer.style.line_width = 0.001;
  const auto expect_even_grid = [&] {
    const Painted painted(layer);
    for (int x = 4; x < width - 8; ++x) {
      for (int y = 5; y < height - 10; ++y) {
        ASSERT_NEAR(painted.ink(x + 0.5, y + 0.5), painted.ink(x + 4.5, y + 0.5), 0.08) << x << " " << y;
        ASSERT_NEAR(painted.ink(x + 0.5, y + 0.5), painted.ink(x + 0.5, y + 5.5), 0.08) << x << " " << y;
      }
    }
  };
  // Qt's polygons for circles so small are a few percent smaller.
  EXPECT_NEAR(Painted(layer).area(), 2000 * M_PI, 250);
  expect_even_grid();
  // A circle around them all: the other way about.
  set.arcs[1].to = set.arcs[1].from = set.arcs[0].from;
  set.arcs[1].center.x = -105;
  set.arcs[1].radius = 5;
  layer.primitives = std::make_shared<const Primitive_set>(set);
  EXPECT_NEAR(Painted(layer).area(), width * height - 2000 * M_PI, 250);
  expect_even_grid();

  Primitive_set disks = with_vertices({});
  for (int i = 0; i < 2000; ++i) {
    disks.vertices.push_back({2.0 + 4 * (i % 50), 1.25 + 2.5 * (i / 50), 0});
    disks.balls.push_back({i, 5});
  }
  layer = layer_of(disks);
  layer.style.filled = true;
  layer.style.opacity = 0.5;
  EXPECT_NEAR(Painted(layer).area(), width * height / 2.0, width * height / 400.0);
  const Painted painted(layer);
  for (int x = 10; x < width - 10; ++x)
    for (int y = 10; y < height - 10; ++y) ASSERT_NEAR(painted.ink(x + 0.5, y + 0.5), 0.5, 0.01) << x << " " << y;
}

TEST(Painter_canvas, a_loop_of_many_arcs_keeps_its_inside) {
  // A scalloped disk with a scalloped hole, each one loop of more arcs than are painted in one piece.
  constexpr int count = 1500;
  Primitive_set set;
  for (const double radius : {47.0, 20.0}) {
    const int first = static_cast<int>(set.vertices.size());
    const auto at = [&](double i) {
      return Point_2{100 + radius * std::cos(2 * M_PI * i / count), 50 + radius * std::sin(2 * M_PI * i / count)};
    };
    const double small = distance(at(0), at(1)) / 2;
    for (int i = 0; i < count; ++i) {
      set.vertices.push_back({at(i).x, at(i).y, 0});
      set.arcs.push_back({midpoint(at(i), at(i + 1)), small, first + i, first + (i + 1) % count, true});
    }
  }
  Scene_layer layer = layer_of(std::move(set));
  layer.style.filled = true;
  layer.style.line_width = 0.001;
  layer.style.opacity = 0.999;
  const Painted painted(layer);
  EXPECT_NEAR(painted.area(), M_PI * (47 * 47 - 20 * 20), 30);
  for (const double x : {55.0, 64.5, 75.0, 127.5, 128.5, 145.0}) EXPECT_GT(painted.ink(x, 50.5), 0.99) << x;
  EXPECT_GT(painted.ink(64.5, 64.5), 0.99) << "where tiles meet";
  EXPECT_EQ(painted.ink(100, 50), 0);
  EXPECT_EQ(painted.ink(60, 90), 0);
}

TEST(Painter_canvas, huge_arcs_bound_their_area) {
  for (const double radius : {1e5, 1e9, 1e12}) {
    Primitive_set set = with_vertices({{50, 50, 0}, {150, 50, 0}, {-1e6, 50, 0}, {1e6, 50, 0}});
    set.arcs = {{{100, 50 - radius}, radius, 1, 0, true}, {{100, 50}, 50, 0, 1, true}};
    Scene_layer layer = layer_of(std::move(set));
    layer.style.filled = true;
    layer.style.line_width = 0.01;
    EXPECT_NEAR(Painted(layer).area(), M_PI * 1250 + 2.0 / 3 * 100 * 1250 / radius, 15) << radius;
  }
}

TEST(Painter_canvas, cut_and_thresholds_hide_elements) {
  Primitive_set set = with_vertices({{50, 50, 0}, {100, 50, 0}, {150, 50, 0}});
  set.points = {0, 1, 2};
  set.values.push_back({"scale", "", {1, 2, 3}});
  Scene_layer layer = layer_of(std::move(set));
  layer.style.color_map = "solid";
  layer.style.value = "scale";
  layer.style.threshold_maximum = 2.5;
  layer.cut = Cut{"scale", 2};
  const Painted painted(layer);
  EXPECT_EQ(painted.ink(50, 50), 0);
  EXPECT_EQ(painted.ink(100, 50), 1);
  EXPECT_EQ(painted.ink(150, 50), 0);
}

TEST(Painter_canvas, coordinates_that_are_not_finite_are_left_out) {
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  Primitive_set set = with_vertices({{50, 50, 0}, {nan, 50, 0}, {infinity, 0, 0}, {60, 20, 0}});
  set.points = {1, 2};
  set.segments = {{0, 1}, {0, 2}};
  set.rays = {{1, {1, 0, 0}}, {0, {nan, 0, 0}}};
  set.triangles = {{0, 1, 3}, {0, 3, 2}};
  set.balls = {{1, 3}, {0, nan}, {0, infinity}, {0, -1}};
  set.arcs = {{{nan, 0}, 3, 0, 3, true}};
  for (const bool filled : {false, true}) {
    Scene_layer layer = layer_of(set);
    layer.style.filled = filled;
    EXPECT_EQ(Painted(layer).area(), 0);
  }
}

TEST(Painter_canvas, transparent_background_has_no_color) {
  Primitive_set set = with_vertices({{50, 50, 0}});
  set.points = {0};
  Scene scene = scene_of(layer_of(std::move(set)));
  scene.transparent_background = true;
  const QImage picture = paint_picture(scene, pixel_view(width, height), width, height);
  EXPECT_EQ(qAlpha(picture.pixel(5, 5)), 0);
  EXPECT_EQ(qAlpha(picture.pixel(50, 50)), 255);
}

TEST(Painter_canvas, color_bar_shows_the_map_and_text) {
  Primitive_set set = with_vertices({{-50, 50, 0}, {-40, 50, 0}});
  set.points = {0, 1};
  set.values.push_back({"scale", "", {0, 1}});
  Scene_layer layer = layer_of(std::move(set));
  layer.style.value = "scale";
  layer.style.color_map = "gray";
  const QImage picture = paint_picture(scene_of(layer), pixel_view(400, 300), 400, 300);
  int dark = 0;
  int middle = 0;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      dark += qGray(picture.pixel(x, y)) < 60;
      middle += std::abs(qGray(picture.pixel(x, y)) - 128) < 20;
    }
  }
  EXPECT_GT(dark, 400);
  EXPECT_GT(middle, 180 * 10 / 8);
  Scene dark_scene = scene_of(layer);
  dark_scene.background = {20, 20, 20};
  const QImage dark_picture = paint_picture(dark_scene, pixel_view(400, 300), 400, 300);
  int light = 0;
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x) light += qGray(dark_picture.pixel(x, y)) > 200;
  EXPECT_GT(light, 400) << "text must show on a dark ground";
}

}  // namespace
}  // namespace mesecina
