// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shell/picture_cache.h"

namespace mesecina {
namespace {

Inputs some_points() { return Inputs().with(points_input, std::vector<Point_2>{{0, 0}}); }

Layer_picture picture(std::size_t vertices) {
  Primitive_set set;
  set.vertices.resize(vertices);
  return {std::make_shared<const Primitive_set>(std::move(set)), {}, {}, {}, 0};
}

TEST(PictureCache, FindsByIdentityOfInputsSettingsAndLayer) {
  Picture_cache cache(1 << 20);
  const Inputs first = some_points();
  const Inputs second = some_points();
  const Settings changed = Settings().with("step", 2.0);
  cache.put(first, {}, "axis", picture(10));
  ASSERT_NE(cache.find(first, {}, "axis"), nullptr);
  EXPECT_EQ(cache.find(first, {}, "axis")->primitives->vertices.size(), 10u);
  EXPECT_EQ(cache.find(second, {}, "axis"), nullptr);
  EXPECT_EQ(cache.find(first, changed, "axis"), nullptr);
  EXPECT_EQ(cache.find(first, {}, "points"), nullptr);
  cache.put(first, changed, "axis", picture(20));
  EXPECT_EQ(cache.find(first, {}, "axis")->primitives->vertices.size(), 10u);
  EXPECT_EQ(cache.find(first, changed, "axis")->primitives->vertices.size(), 20u);
}

TEST(PictureCache, WhatWasNotLookedAtForLongestGoesFirst) {
  const std::size_t large = 3 * sizeof(Point_3) * 1000;
  Picture_cache cache(large);
  std::vector<Inputs> inputs;
  for (int i = 0; i < 3; ++i) inputs.push_back(some_points());
  cache.put(inputs[0], {}, "axis", picture(1000));
  cache.put(inputs[1], {}, "axis", picture(1000));
  ASSERT_NE(cache.find(inputs[0], {}, "axis"), nullptr);
  cache.put(inputs[2], {}, "axis", picture(1000));
  EXPECT_LE(cache.bytes(), large);
  EXPECT_NE(cache.find(inputs[0], {}, "axis"), nullptr);
  EXPECT_EQ(cache.find(inputs[1], {}, "axis"), nullptr);
  EXPECT_NE(cache.find(inputs[2], {}, "axis"), nullptr);
}

TEST(PictureCache, CountsBytesAndKeepsToASmallerBudget) {
  Picture_cache cache(1 << 20);
  const Inputs inputs = some_points();
  cache.put(inputs, {}, "axis", picture(1000));
  const std::size_t one = cache.bytes();
  EXPECT_GE(one, 1000 * sizeof(Point_3));
  EXPECT_LT(one, 1000 * sizeof(Point_3) + 2000);
  cache.put(inputs, {}, "axis", picture(1000));
  EXPECT_EQ(cache.bytes(), one);
  cache.put(inputs, {}, "points", picture(1000));
  EXPECT_EQ(cache.bytes(), 2 * one);
  cache.set_budget(one);
  EXPECT_EQ(cache.bytes(), one);
  EXPECT_EQ(cache.find(inputs, {}, "axis"), nullptr);
  cache.set_budget(0);
  EXPECT_EQ(cache.bytes(), 0u);
  cache.put(inputs, {}, "axis", picture(1000));
  EXPECT_EQ(cache.bytes(), 0u);
}

TEST(PictureCache, ReasonsAreKeptToo) {
  Picture_cache cache(1 << 20);
  const Inputs inputs = some_points();
  cache.put(inputs, {}, "axis", {nullptr, "needs 3 points", {"a duplicate"}, {}, 0.5});
  ASSERT_NE(cache.find(inputs, {}, "axis"), nullptr);
  EXPECT_EQ(cache.find(inputs, {}, "axis")->reason, "needs 3 points");
  EXPECT_EQ(cache.find(inputs, {}, "axis")->warnings, QStringList("a duplicate"));
}

TEST(PictureCache, BytesCountEveryArray) {
  Primitive_set set;
  const std::size_t empty = bytes_of(set);
  set.balls.resize(100);
  set.values.push_back({"radius", "", std::vector<double>(100)});
  set.ids.resize(50);
  EXPECT_GE(bytes_of(set), empty + 100 * sizeof(Ball) + 100 * sizeof(double) + 50 * sizeof(std::int64_t));
}

}  // namespace
}  // namespace mesecina
