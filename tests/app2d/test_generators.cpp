// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app2d/generators_2.h"
#include "shell/document.h"

namespace mesecina {
namespace {

const Generator_2& generator(std::string_view id) {
  const auto it = std::ranges::find(generators_2(), id, &Generator_2::id);
  EXPECT_NE(it, generators_2().end()) << id;
  return *it;
}

Generator_order_2 order(std::size_t count) {
  Generator_order_2 order;
  order.count = count;
  order.box.add(Point_2{-3.7, 11.1});
  order.box.add(Point_2{96.3, 91.9});
  order.inputs = Inputs().with(outline_input, Outline_2{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}});
  return order;
}

TEST(Generators2, GiveAsManyPointsAsAskedWithinTheBox) {
  for (const Generator_2& each : generators_2()) {
    if (!each.has_count) continue;
    const Inputs made = generated(each, order(97));
    std::vector<Point_2> points;
    if (const auto given = made.get(points_input)) points = *given;
    if (const auto disks = made.get(disks_input))
      for (const Disk_2& disk : *disks) points.push_back(disk.center);
    EXPECT_EQ(points.size(), 97u) << each.id;
    EXPECT_EQ(made.get(disks_input) != nullptr, each.radii != Radii_2::none) << each.id;
    if (each.id == "on-outline") continue;
    for (const Point_2& p : points) {
      EXPECT_GT(p.x, -30) << each.id;
      EXPECT_LT(p.x, 120) << each.id;
      EXPECT_GT(p.y, -10) << each.id;
      EXPECT_LT(p.y, 110) << each.id;
    }
  }
}

TEST(Generators2, AreRepeatableAndDependOnTheSeed) {
  for (const Generator_2& each : generators_2()) {
    Generator_order_2 other = order(50);
    other.seed = 2;
    EXPECT_TRUE(same_data(generated(each, order(50)), generated(each, order(50)))) << each.id;
    EXPECT_EQ(!same_data(generated(each, order(50)), generated(each, other)), each.has_seed) << each.id;
  }
}

TEST(Generators2, CocircularPointsAreExactlySo) {
  const auto points = generator("cocircular").make(order(324));
  ASSERT_EQ(points.size(), 324u);
  // All coordinates are whole multiples of one power of two, so this arithmetic has no rounding.
  double low_x = points[0].x;
  double high_x = points[0].x;
  double low_y = points[0].y;
  double high_y = points[0].y;
  for (const Point_2& p : points) {
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
  }
  const Point_2 center{(low_x + high_x) / 2, (low_y + high_y) / 2};
  std::set<double> squared;
  for (const Point_2& p : points) squared.insert(squared_distance(p, center));
  EXPECT_EQ(squared.size(), 1u);
}

TEST(Generators2, CollinearPointsAreExactlySo) {
  const auto points = generator("collinear").make(order(100));
  for (std::size_t i = 2; i < points.size(); ++i) {
    const double a = (points[1].x - points[0].x) * (points[i].y - points[0].y);
    const double b = (points[1].y - points[0].y) * (points[i].x - points[0].x);
    EXPECT_EQ(a, b) << i;
  }
}

TEST(Generators2, DuplicatesComeThreeTimes) {
  auto points = generator("duplicates").make(order(99));
  std::set<std::pair<double, double>> distinct;
  for (const Point_2& p : points) distinct.insert({p.x, p.y});
  EXPECT_EQ(distinct.size(), 33u);
}

TEST(Generators2, OutlineIsWalkedEvenly) {
  const auto points = generator("on-outline").make(order(16));
  ASSERT_EQ(points.size(), 16u);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(distance(points[i], points[(i + 1) % points.size()]), 1, 1e-12) << i;
}

TEST(Generators2, NoiseHasTheAmountAskedFor) {
  Generator_order_2 noisy = order(0);
  std::vector<Point_2> many(5000, Point_2{0, 0});
  many.back() = {3, 4};
  noisy.inputs = Inputs().with(points_input, many);
  noisy.amount = 0.02;
  const auto points = generator("noisy-copy").make(noisy);
  double squares = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) squares += squared_distance(points[i], {0, 0});
  EXPECT_NEAR(std::sqrt(squares / 2 / static_cast<double>(points.size() - 1)), 0.02 * 5, 0.005);
}

TEST(Generators2, RadiiOfRandomDisksAreInTheirRange) {
  Generator_order_2 wanted = order(2000);
  wanted.least_radius = 3;
  wanted.greatest_radius = 4;
  double least = 4;
  double greatest = 3;
  for (const Disk_2& disk : generator("random-disks").make_disks(wanted)) {
    EXPECT_GE(disk.radius, 3);
    EXPECT_LE(disk.radius, 4);
    least = std::min(least, disk.radius);
    greatest = std::max(greatest, disk.radius);
  }
  EXPECT_LT(least, 3.01);
  EXPECT_GT(greatest, 3.99);
  // The order of the two does not matter.
  std::swap(wanted.least_radius, wanted.greatest_radius);
  for (const Disk_2& disk : generator("random-disks").make_disks(wanted)) EXPECT_TRUE(disk.radius >= 3);
}

TEST(Generators2, GridDisksOfHalfTheStepTouchExactly) {
  const auto disks = generator("grid-of-disks").make_disks(order(25));
  ASSERT_EQ(disks.size(), 25u);
  EXPECT_EQ(disks[1].center.x - disks[0].center.x, disks[0].radius + disks[1].radius);
  EXPECT_EQ(disks[0].center.y, disks[1].center.y);
}

TEST(Generators2, ARingOfDisksHasAHole) {
  Generator_order_2 wanted = order(12);
  wanted.relative_radius = 0.6;
  const auto disks = generator("ring-of-disks").make_disks(wanted);
  ASSERT_EQ(disks.size(), 12u);
  const Point_2 center{46.3, 51.5};
  for (std::size_t i = 0; i < disks.size(); ++i) {
    EXPECT_LT(distance(disks[i].center, disks[(i + 1) % 12].center), 2 * disks[i].radius);
    EXPECT_GT(distance(disks[i].center, center), disks[i].radius);
  }
}

TEST(Generators2, HaveNothingToStartFromInAnEmptyPlane) {
  Generator_order_2 empty = order(10);
  empty.inputs = {};
  EXPECT_TRUE(generator("on-outline").make(empty).empty());
  EXPECT_TRUE(generator("noisy-copy").make(empty).empty());
}

}  // namespace
}  // namespace mesecina
