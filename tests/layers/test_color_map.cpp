// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "layers/color_bars.h"
#include "layers/color_map.h"
#include "tests/layers/example_scene.h"

namespace mesecina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_near(Color found, Color expected, int tolerance, const std::string& what) {
  EXPECT_NEAR(found.red, expected.red, tolerance) << what;
  EXPECT_NEAR(found.green, expected.green, tolerance) << what;
  EXPECT_NEAR(found.blue, expected.blue, tolerance) << what;
}

struct Published {
  const char* map;
  double t;
  Color color;
};

TEST(Color_map, agrees_with_published_tables) {
  for (const auto& [name, t, color] : std::initializer_list<Published>{{"viridis", 0, {68, 1, 84}},
                                                                       {"viridis", 64.0 / 255, {59, 82, 139}},
                                                                       {"viridis", 128.0 / 255, {33, 145, 140}},
                                                                       {"viridis", 191.0 / 255, {92, 200, 99}},
                                                                       {"viridis", 1, {253, 231, 37}},
                                                                       {"magma", 128.0 / 255, {183, 55, 121}},
                                                                       {"magma", 1, {252, 253, 191}},
                                                                       {"inferno", 64.0 / 255, {87, 16, 110}},
                                                                       {"inferno", 230.0 / 255, {246, 215, 70}},
                                                                       {"plasma", 0, {13, 8, 135}},
                                                                       {"plasma", 191.0 / 255, {248, 148, 65}},
                                                                       {"cividis", 0, {0, 34, 78}},
                                                                       {"cividis", 64.0 / 255, {67, 78, 108}},
                                                                       {"cividis", 1, {254, 232, 56}},
                                                                       {"turbo", 64.0 / 255, {40, 188, 235}},
                                                                       {"turbo", 230.0 / 255, {195, 37, 3}},
                                                                       {"coolwarm", 0, {59, 76, 192}},
                                                                       {"coolwarm", 0.5, {221, 220, 220}},
                                                                       {"coolwarm", 1, {180, 4, 38}},
                                                                       {"RdBu", 0, {103, 0, 31}},
                                                                       {"RdBu", 0.5, {247, 247, 247}},
                                                                       {"RdBu", 1, {5, 48, 97}},
                                                                       {"twilight", 0, {226, 217, 226}},
                                                                       {"twilight", 254.0 / 509, {48, 20, 55}},
                                                                       {"twilight", 382.0 / 509, {178, 86, 82}},
                                                                       {"tab10", 0, {31, 119, 180}},
                                                                       {"tab10", 1, {23, 190, 207}},
                                                                       {"okabe-ito", 0, {230, 159, 0}}}) {
    const Color_map* map = find_color_map(name);
    ASSERT_NE(map, nullptr) << name;
    expect_near(map->lookup(t), color, 3, std::string(name) + " at " + std::to_string(t));
  }
}

TEST(Color_map, historical_maps_follow_their_formulas) {
  const auto at = [](const char* name, double t) { return find_color_map(name)->lookup(t); };
  const auto byte = [](double x) { return static_cast<std::uint8_t>(std::lround(255 * std::min(1.0, x))); };
  for (const double t : {0.0, 0.1, 0.3, 0.5, 0.85, 1.0}) {
    expect_near(at("autumn", t), {255, byte(t), 0}, 1, "autumn");
    expect_near(at("cool", t), {byte(t), byte(1 - t), 255}, 1, "cool");
    expect_near(at("copper", t), {byte(1.25 * t), byte(0.7812 * t), byte(0.4975 * t)}, 1, "copper");
    expect_near(at("gray", t), {byte(t), byte(t), byte(t)}, 1, "gray");
    expect_near(at("spring", t), {255, byte(t), byte(1 - t)}, 1, "spring");
    expect_near(at("summer", t), {byte(t), byte(0.5 + t / 2), byte(0.4)}, 1, "summer");
    expect_near(at("winter", t), {0, byte(t), byte(1 - t / 2)}, 1, "winter");
  }
  expect_near(at("jet", 0.5), {128, 255, 128}, 1, "jet");
  expect_near(at("jet", 0), {0, 0, 128}, 1, "jet");
  expect_near(at("hot", 0.375), {255, 0, 0}, 1, "hot");
  expect_near(at("hot", 0.875), {255, 255, 128}, 1, "hot");
  expect_near(at("hsv", 1.0 / 3), {0, 255, 0}, 1, "hsv");
  EXPECT_EQ(at("hsv", 0), at("hsv", 1));
}

TEST(Color_map, has_all_maps_once) {
  std::set<std::string> names;
  int historical = 0;
  for (const Color_map& map : color_maps()) {
    EXPECT_TRUE(names.insert(map.name()).second) << map.name();
    historical += map.kind() == Color_map::Kind::historical;
  }
  EXPECT_EQ(historical, 12);
  for (const char* name : {"viridis", "magma", "inferno", "plasma", "cividis", "turbo", "coolwarm", "RdBu", "twilight",
                           "tab10", "okabe-ito", "solid", "random"})
    EXPECT_TRUE(names.count(name)) << name;
  EXPECT_EQ(find_color_map("no such map"), nullptr);
}

TEST(Color_map, answers_for_numbers_outside_the_range) {
  const Color_map& map = *find_color_map("viridis");
  EXPECT_EQ(map.lookup(std::nan(""), {1, 2, 3}), (Color{1, 2, 3}));
  EXPECT_EQ(map.lookup(infinity), map.lookup(1));
  EXPECT_EQ(map.lookup(-infinity), map.lookup(0));
  EXPECT_EQ(map.lookup(7), map.lookup(1));
}

Scene_layer valued_layer(std::vector<double> data) {
  Primitive_set set;
  for (std::size_t i = 0; i < data.size(); ++i) {
    set.vertices.push_back({static_cast<double>(i), 0, 0});
    set.points.push_back(static_cast<int>(i));
  }
  set.values.push_back({"angle", "degrees", std::move(data)});
  Scene_layer layer = test::layer_of(std::move(set), "crust");
  layer.style.value = "angle";
  return layer;
}

TEST(Color_of, stretches_the_map_over_the_finite_values) {
  const Scene_layer layer = valued_layer({10, 20, 30, infinity, std::nan("")});
  EXPECT_EQ(value_range(layer), (Value_range{10, 30, true}));
  const Color_map& map = *find_color_map("viridis");
  const Layer_colors colors(layer);
  EXPECT_TRUE(colors.is_by_value());
  EXPECT_EQ(colors(0), map.lookup(0));
  EXPECT_EQ(colors(1), map.lookup(0.5));
  EXPECT_EQ(colors(2), map.lookup(1));
  EXPECT_EQ(colors(3), map.lookup(1));
  EXPECT_EQ(colors(4), (Color{128, 128, 128}));
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(color_of(layer.style, colors.values(), colors.range(), i), colors(i)) << i;
}

TEST(Color_of, reversed_map_gives_the_greatest_value_the_first_color) {
  Scene_layer layer = valued_layer({10, 30, infinity});
  layer.style.color_map_reversed = true;
  const Color_map& map = *find_color_map("viridis");
  const Layer_colors colors(layer);
  EXPECT_EQ(colors(0), map.lookup(1));
  EXPECT_EQ(colors(1), map.lookup(0));
  EXPECT_EQ(colors(2), map.lookup(0));
}

TEST(Color_of, own_range_and_hidden_elements_change_the_range) {
  Scene_layer layer = valued_layer({10.5, 20, 30});
  layer.style.threshold_minimum = 15;
  EXPECT_EQ(value_range(layer), (Value_range{20, 30, true}));
  layer.style.range_maximum = 180;
  EXPECT_EQ(value_range(layer), (Value_range{20, 180, true}));
  layer.style.range_minimum = 200;
  layer.style.range_maximum.reset();
  EXPECT_EQ(value_range(layer).minimum, value_range(layer).maximum);
}

TEST(Color_of, classes_keep_their_color_whatever_the_range) {
  Scene_layer layer = valued_layer({3, 4, 13});
  layer.style.color_map = "tab10";
  const Layer_colors colors(layer);
  EXPECT_EQ(colors(0), (Color{214, 39, 40}));
  EXPECT_EQ(colors(1), (Color{148, 103, 189}));
  EXPECT_EQ(colors(2), colors(0));
}

TEST(Color_of, solid_unknown_and_absent_maps_use_the_style) {
  Scene_layer layer = valued_layer({1, 2});
  layer.style.color = {9, 8, 7};
  for (const char* name : {"solid", "no such map"}) {
    layer.style.color_map = name;
    EXPECT_TRUE(Layer_colors(layer).is_uniform()) << name;
    EXPECT_EQ(Layer_colors(layer)(1), layer.style.color) << name;
  }
  layer.style.color_map = "viridis";
  layer.style.value = "no such value";
  EXPECT_EQ(Layer_colors(layer)(1), layer.style.color);
}

TEST(Color_of, random_map_depends_on_the_element_only) {
  Scene_layer layer = valued_layer({1, 1, 1});
  layer.style.color_map = "random";
  const Layer_colors colors(layer);
  EXPECT_FALSE(colors.is_by_value());
  EXPECT_EQ(colors(2), hashed_color(2));
  EXPECT_NE(colors(0), colors(1));
}

TEST(Color_bars, show_title_unit_and_round_ticks) {
  const auto bars = color_bars(test::scene_of(valued_layer({0, 180, 42.5})), 800, 600);
  ASSERT_EQ(bars.size(), 1U);
  EXPECT_EQ(bars[0].title, "crust: angle (degrees)");
  ASSERT_EQ(bars[0].ticks.size(), 4U);
  EXPECT_EQ(bars[0].ticks[1].text, "50");
  EXPECT_NEAR(bars[0].ticks[1].position, 50.0 / 180, 1e-12);
  EXPECT_TRUE((Pixel_box{0, 0, 800, 600}.contains(bars[0].plate)));
  EXPECT_TRUE(bars[0].plate.contains(bars[0].strip));
}

TEST(Color_bars, stack_without_overlap_and_stay_on_the_page) {
  Scene scene;
  for (int i = 0; i < 40; ++i) scene.layers.push_back(valued_layer({0.1, 0.7}));
  const auto bars = color_bars(scene, 400, 300);
  ASSERT_GE(bars.size(), 3U);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    EXPECT_TRUE((Pixel_box{0, 0, 400, 300}.contains(bars[i].plate)));
    EXPECT_EQ(bars[i].strip.left, bars[0].strip.left);
    if (i > 0) {
      EXPECT_LE(bars[i].plate.bottom, bars[i - 1].plate.top);
    }
  }
  EXPECT_TRUE(color_bars(scene, 100, 100).empty());
}

TEST(Color_bars, ticks_are_three_to_six_round_numbers_within_the_range) {
  for (const auto& [low, high] : std::initializer_list<std::pair<double, double>>{
           {0, 1}, {0.1, 0.7}, {-3, 8}, {1e-9, 7e-9}, {99.5, 100.25}, {0, 180}, {1e6, 1.3e7}}) {
    const auto ticks = round_ticks(low, high);
    EXPECT_GE(ticks.size(), 3U) << low << " " << high;
    EXPECT_LE(ticks.size(), 6U) << low << " " << high;
    EXPECT_GE(ticks.front(), low);
    EXPECT_LE(ticks.back(), high);
  }
}

TEST(Color_bars, ticks_of_a_range_of_one_last_digit_are_its_ends) {
  const double high = std::nextafter(33.9, 40.0);
  EXPECT_EQ(round_ticks(33.9, high), (std::vector<double>{33.9, high}));
}

}  // namespace
}  // namespace mesecina
