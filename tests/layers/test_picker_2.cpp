// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <random>

#include "layers/picker_2.h"
#include "tests/layers/example_scene.h"

namespace mesecina {
namespace {

using test::layer_of;
using test::pixel_view;
using test::scene_of;

constexpr double view_width = 400;
constexpr double view_height = 300;

/// Distance to a curve by walking along it.
double walked_distance(const Point_2& p, const std::function<Point_2(double)>& curve) {
  double nearest = 1e300;
  for (int i = 0; i <= 4000; ++i) nearest = std::min(nearest, distance(p, curve(i / 4000.0)));
  return nearest;
}

/// Random elements of all kinds that are curves or points, with few of each so that walking is affordable.
Primitive_set random_curves(std::mt19937& random) {
  std::uniform_real_distribution<double> x(0, view_width);
  std::uniform_real_distribution<double> y(0, view_height);
  std::uniform_real_distribution<double> angle(0, 2 * M_PI);
  Primitive_set set;
  const auto vertex = [&](const Point_2& p) {
    set.vertices.push_back({p.x, p.y, 0});
    return static_cast<int>(set.vertices.size()) - 1;
  };
  const auto any = [&] { return vertex({x(random), y(random)}); };
  for (int i = 0; i < 5; ++i) {
    const int a = any();
    const int b = any();
    set.segments.push_back({a, b});
    const double direction = angle(random);
    set.rays.push_back({any(), {std::cos(direction), std::sin(direction), 0}});
    const Point_2 center{x(random), y(random)};
    const double radius = 10 + x(random) / 4;
    const auto on_circle = [&](double t) {
      return Point_2{center.x + radius * std::cos(t), center.y + radius * std::sin(t)};
    };
    const int from = vertex(on_circle(angle(random)));
    const int to = i == 4 ? from : vertex(on_circle(angle(random)));
    set.arcs.push_back({center, radius, from, to, i % 2 == 0});
    set.balls.push_back({any(), 5 + x(random) / 8});
  }
  return set;
}

/// Distance of one element, found without the picker's formulas.
double brute_force_distance(const Primitive_set& set, std::size_t element, const Point_2& p) {
  const auto at = [&](int v) { return Point_2{set.vertices[std::size_t(v)].x, set.vertices[std::size_t(v)].y}; };
  if (element < set.segments.size()) {
    const Point_2 a = at(set.segments[element][0]);
    const Point_2 b = at(set.segments[element][1]);
    return walked_distance(p, [&](double t) { return Point_2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; });
  }
  element -= set.segments.size();
  if (element < set.rays.size()) {
    const Point_2 a = at(set.rays[element].from);
    const Point_3 d = set.rays[element].direction;
    return walked_distance(p, [&](double t) { return Point_2{a.x + 600 * t * d.x, a.y + 600 * t * d.y}; });
  }
  element -= set.rays.size();
  if (element < set.arcs.size()) {
    const Arc& arc = set.arcs[element];
    const Point_2 from = at(arc.from);
    const Point_2 to = at(arc.to);
    const double start = std::atan2(from.y - arc.center.y, from.x - arc.center.x);
    double sweep = std::atan2(to.y - arc.center.y, to.x - arc.center.x) - start;
    if (arc.counterclockwise && sweep <= 0) sweep += 2 * M_PI;
    if (!arc.counterclockwise && sweep >= 0) sweep -= 2 * M_PI;
    return walked_distance(p, [&](double t) {
      return Point_2{arc.center.x + arc.radius * std::cos(start + t * sweep),
                     arc.center.y + arc.radius * std::sin(start + t * sweep)};
    });
  }
  element -= set.arcs.size();
  const Ball& ball = set.balls[element];
  const Point_2 c = at(ball.center);
  return walked_distance(p, [&](double t) {
    return Point_2{c.x + ball.radius * std::cos(2 * M_PI * t), c.y + ball.radius * std::sin(2 * M_PI * t)};
  });
}

TEST(Picker_2, finds_the_nearest_curve_as_brute_force_does) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> x(0, view_width);
  std::uniform_real_distribution<double> y(0, view_height);
  int hits = 0;
  for (int round = 0; round < 6; ++round) {
    Picker_2 picker;
    const Scene scene = scene_of(layer_of(random_curves(random)));
    const Primitive_set& set = *scene.layers[0].primitives;
    for (int i = 0; i < 40; ++i) {
      const Point_2 p{x(random), y(random)};
      const Point_2 pixel = pixel_view(view_width, view_height).to_pixel(p, view_width, view_height);
      const double tolerance = 8;
      const double half_line = scene.layers[0].style.line_width / 2;
      double nearest = 1e300;
      for (std::size_t e = 0; e < set.element_count(); ++e)
        nearest = std::min(nearest, brute_force_distance(set, e, p));
      const auto hit =
          picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, pixel, tolerance);
      if (std::abs(nearest - tolerance - half_line) < 0.3) continue;
      ASSERT_EQ(hit.has_value(), nearest < tolerance + half_line) << "round " << round << " query " << i;
      if (!hit) continue;
      ++hits;
      EXPECT_NEAR(hit->distance, std::max(0.0, nearest - half_line), 0.2);
      EXPECT_NEAR(brute_force_distance(set, hit->element, p), nearest, 0.2);
    }
  }
  EXPECT_GT(hits, 50);
}

TEST(Picker_2, points_come_before_curves_before_areas) {
  Primitive_set set;
  set.vertices = {{100, 100, 0}, {100, 120, 0}, {200, 120, 0}};
  set.points = {0};
  set.segments = {{1, 2}};
  set.balls = {{0, 60}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.filled = true;
  layer.style.point_size = 6;
  const Scene scene = scene_of(std::move(layer));
  Picker_2 picker;
  const auto pick = [&](double x, double y) {
    return picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {x, view_height - y}, 5);
  };
  EXPECT_EQ(pick(105, 100)->element, 0U);
  EXPECT_NEAR(pick(105, 100)->distance, 2, 1e-9);
  EXPECT_EQ(pick(130, 122)->element, 1U);
  EXPECT_EQ(pick(80, 80)->element, 2U);
  EXPECT_EQ(pick(80, 80)->distance, 0);
  EXPECT_EQ(pick(162, 100)->element, 2U) << "just outside";
  EXPECT_NEAR(pick(162, 100)->distance, 2, 1e-9);
  EXPECT_FALSE(pick(170, 100));
}

TEST(Picker_2, equal_hits_go_to_the_layer_on_top) {
  Primitive_set set;
  set.vertices = {{100, 100, 0}};
  set.points = {0};
  Scene scene;
  scene.layers = {layer_of(set, "below"), layer_of(set, "above"), layer_of(set, "hidden")};
  scene.layers[2].style.visible = false;
  Picker_2 picker;
  EXPECT_EQ(picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {100, 200}, 5)->layer, 1U);
}

TEST(Picker_2, tolerance_is_in_pixels_whatever_the_scale) {
  Primitive_set set;
  set.vertices = {{1e-3, 2e-3, 0}};
  set.points = {0};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.point_size = 2;
  const Scene scene = scene_of(std::move(layer));
  const View_2 view{{1e-3, 2e-3}, 1e6};
  Picker_2 picker;
  EXPECT_TRUE(picker.pick(scene, view, view_width, view_height, {view_width / 2 + 5.5, view_height / 2}, 5));
  EXPECT_FALSE(picker.pick(scene, view, view_width, view_height, {view_width / 2 + 6.5, view_height / 2}, 5));
}

TEST(Picker_2, follows_cut_and_thresholds) {
  Primitive_set set;
  set.vertices = {{100, 100, 0}};
  set.points = {0};
  set.values.push_back({"scale", "", {2}});
  Scene scene = scene_of(layer_of(std::move(set)));
  Picker_2 picker;
  const auto is_hit = [&] {
    return picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {100, 200}, 5).has_value();
  };
  EXPECT_TRUE(is_hit());
  scene.layers[0].cut = Cut{"scale", 3};
  EXPECT_FALSE(is_hit());
  scene.layers[0].cut->minimum = 1;
  EXPECT_TRUE(is_hit());
  scene.layers[0].style.value = "scale";
  scene.layers[0].style.threshold_maximum = 1;
  EXPECT_FALSE(is_hit());
}

TEST(Picker_2, polygons_are_filled_together) {
  Primitive_set set;
  for (const double inset : {0.0, 50.0, 80.0})
    for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(1.0, 1.0), std::pair(0.0, 1.0)})
      set.vertices.push_back({20 + inset + x * (240 - 2 * inset), 20 + inset + y * (240 - 2 * inset), 0});
  set.polygon_vertices = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  set.polygon_offsets = {0, 4, 8, 12};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.filled = true;
  Scene scene = scene_of(layer);
  Picker_2 picker;
  const auto pick = [&](double x, double y) {
    return picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {x, view_height - y}, 5);
  };
  EXPECT_EQ(pick(45, 140)->element, 0U);
  EXPECT_FALSE(pick(85, 140)) << "the hole";
  EXPECT_EQ(pick(140, 140)->element, 2U) << "the island";
  scene.layers[0].style.filled = false;
  EXPECT_FALSE(pick(45, 140));
  EXPECT_EQ(pick(72, 140)->element, 1U);
}

TEST(Picker_2, triangles_by_area_or_outline) {
  Primitive_set set;
  set.vertices = {{100, 100, 0}, {200, 100, 0}, {100, 200, 0}};
  set.triangles = {{0, 1, 2}};
  Scene scene = scene_of(layer_of(std::move(set)));
  Picker_2 picker;
  const auto pick = [&](double x, double y) {
    return picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {x, view_height - y}, 3);
  };
  EXPECT_FALSE(pick(125, 125));
  EXPECT_TRUE(pick(150, 98));
  scene.layers[0].style.filled = true;
  EXPECT_TRUE(pick(125, 125));
  EXPECT_FALSE(pick(180, 180));
}

TEST(Picker_2, arcs_are_hit_on_their_line_only) {
  // Half a circle and its diameter's other half: a filled region, with a point far inside.
  Primitive_set set;
  set.vertices = {{100, 100, 0}, {300, 100, 0}};
  set.arcs = {{{200, 100}, 100, 1, 0, true}, {{200, -100}, std::sqrt(50000.0), 1, 0, true}};
  Scene_layer layer = layer_of(std::move(set));
  layer.style.filled = true;
  Scene scene = scene_of(layer);
  Picker_2 picker;
  const auto pick = [&](double x, double y) {
    return picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {x, view_height - y}, 5);
  };
  for (const bool filled : {true, false}) {
    scene.layers[0].style.filled = filled;
    ASSERT_TRUE(pick(200, 197));
    EXPECT_EQ(pick(200, 197)->element, 0U);
    ASSERT_TRUE(pick(200, 121));
    EXPECT_EQ(pick(200, 121)->element, 1U);
    EXPECT_FALSE(pick(200, 160)) << "the inside belongs to no arc";
    EXPECT_FALSE(pick(200, 3)) << "the part of the circle that is not drawn";
    EXPECT_FALSE(pick(100, 60)) << "within the circle's box but not the arc's";
  }
  // What lies below shows through, and is hit through, the inside.
  Primitive_set below;
  below.vertices = {{150, 150, 0}, {250, 150, 0}};
  below.segments = {{0, 1}};
  scene.layers.insert(scene.layers.begin(), layer_of(std::move(below), "below"));
  ASSERT_TRUE(pick(200, 151));
  EXPECT_EQ(pick(200, 151)->layer, 0U);
}

TEST(Picker_2, a_new_set_at_the_address_of_an_old_one_is_indexed_anew) {
  Picker_2 picker;
  for (int i = 0; i < 50; ++i) {
    Primitive_set set;
    set.vertices = {{10.0 + 5 * i, 100, 0}};
    set.points = {0};
    const Scene scene = scene_of(layer_of(std::move(set)));
    EXPECT_TRUE(
        picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {10.0 + 5 * i, 200}, 2))
        << i;
  }
}

TEST(Picker_2, stays_quick_with_many_segments) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(0, view_width);
  std::uniform_real_distribution<double> y(0, view_height);
  Primitive_set set;
  for (int i = 0; i < 300000; ++i) {
    const Point_2 p{x(random), y(random)};
    set.vertices.push_back({p.x, p.y, 0});
    set.vertices.push_back({p.x + 1, p.y + 1, 0});
    set.segments.push_back({2 * i, 2 * i + 1});
  }
  const Scene scene = scene_of(layer_of(std::move(set)));
  Picker_2 picker;
  const auto start = std::chrono::steady_clock::now();
  picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {1, 1}, 4);
  const auto built = std::chrono::steady_clock::now();
  for (int i = 0; i < 200; ++i)
    EXPECT_TRUE(
        picker.pick(scene, pixel_view(view_width, view_height), view_width, view_height, {x(random), y(random)}, 4));
  const auto end = std::chrono::steady_clock::now();
  const auto milliseconds = [](auto d) { return std::chrono::duration<double, std::milli>(d).count(); };
  // Ten times what is promised, for machines that do other things meanwhile.
  EXPECT_LT(milliseconds(built - start), 1500);
  EXPECT_LT(milliseconds(end - built) / 200, 10);
}

}  // namespace
}  // namespace mesecina
