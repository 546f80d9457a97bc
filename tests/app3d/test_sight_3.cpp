// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "app3d/sight_3.h"

namespace mesecina {
namespace {

constexpr double width = 800;
constexpr double height = 600;

Camera_3 camera(Camera_3::Projection projection) {
  Camera_3 seen;
  seen.position = {3, 4, 5};
  seen.target = {0, 1, 0};
  seen.up = {0, 1, 0};
  seen.projection = projection;
  seen.height = 7;
  return seen;
}

class Sight_3_test : public testing::TestWithParam<Camera_3::Projection> {};

TEST_P(Sight_3_test, APlaceIsSeenInItsPixel) {
  const Sight_3 sight(camera(GetParam()), width, height);
  for (const Point_3& place : {Point_3{0, 1, 0}, Point_3{1, 0, -2}, Point_3{-0.5, 2, 1}}) {
    const auto pixel = sight.pixel(place);
    ASSERT_TRUE(pixel);
    const Sight_line line = sight.line(*pixel);
    const Point_3 off = place - line.from;
    EXPECT_NEAR(distance(dot(off, line.direction) * line.direction, off), 0, 1e-12);
    EXPECT_LT(distance(sight.across(*pixel, place), place), 1e-12);
    const auto on_plane = sight.on_plane(*pixel, place, {1, 2, 3});
    ASSERT_TRUE(on_plane);
    EXPECT_LT(distance(*on_plane, place), 1e-10);
    EXPECT_NEAR(sight.along(*pixel, place, {0, 0, 1}), 0, 1e-10);
    EXPECT_NEAR(sight.along(*pixel, place - Point_3{0, 0, 0.25}, {0, 0, 1}), 0.25, 1e-10);
  }
  const auto middle = sight.pixel({0, 1, 0});
  EXPECT_NEAR(middle->x, width / 2, 1e-9);
  EXPECT_NEAR(middle->y, height / 2, 1e-9);
}

TEST_P(Sight_3_test, APixelHasItsSizeAndUpIsUp) {
  const Sight_3 sight(camera(GetParam()), width, height);
  const Point_3 place{0, 1, 0};
  const Point_3 higher = place + (10 * sight.pixel_size(place)) * sight.axes().up;
  EXPECT_NEAR(sight.pixel(higher)->y, height / 2 - 10, 1e-9);
  EXPECT_NEAR(sight.pixel_size(place), camera(GetParam()).height_at_target() / height, 1e-12);
}

TEST_P(Sight_3_test, OutlinesTouchTheBall) {
  const Sight_3 sight(camera(GetParam()), width, height);
  const Point_3 center{0, 1, 0};
  const double radius = sight.outline_radius(center, 1);
  const auto is_hit = [&](double away) {
    const Sight_line line = sight.line({width / 2 + away, height / 2});
    const Point_3 off = center - line.from;
    return std::sqrt(dot(off, off) - dot(off, line.direction) * dot(off, line.direction)) < 1;
  };
  EXPECT_TRUE(is_hit(0.999 * radius));
  EXPECT_FALSE(is_hit(1.001 * radius));
}

INSTANTIATE_TEST_SUITE_P(Projections, Sight_3_test,
                         testing::Values(Camera_3::Projection::perspective, Camera_3::Projection::orthographic));

TEST(Sight_3, SeesNothingBehindTheViewer) {
  const Sight_3 sight(camera(Camera_3::Projection::perspective), width, height);
  const Point_3 behind{6, 7, 10};
  EXPECT_FALSE(sight.pixel(behind));
  EXPECT_EQ(sight.pixel_size(behind), 0);
  EXPECT_FALSE(sight.on_plane({400, 300}, behind, sight.axes().back));
  EXPECT_EQ(sight.across({400, 300}, behind), behind);
}

TEST(Sight_3, CuttingPlanesLeaveAHalfOrASlab) {
  EXPECT_TRUE(is_left(std::nullopt, {9, 9, 9}));
  Cutting_plane_3 plane{{0, 0, 1}, {0, 0, 2}, {}};
  EXPECT_TRUE(is_left(plane, {5, 5, 0.9}));
  EXPECT_FALSE(is_left(plane, {5, 5, 1.1}));
  plane.thickness = 0.5;
  EXPECT_TRUE(is_left(plane, {0, 0, 1.2}));
  EXPECT_FALSE(is_left(plane, {0, 0, 0.7}));
}

}  // namespace
}  // namespace mesecina
