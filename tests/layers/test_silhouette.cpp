// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "layers/silhouette.h"

namespace mesecina {
namespace {

/// Gray picture whose darkness (0 white ... 1 black) at a pixel is the mean of `inside` over it.
Image antialiased(int width, int height, const std::function<bool(double, double)>& inside) {
  constexpr int samples = 32;
  Image image;
  image.width = width;
  image.height = height;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      int count = 0;
      for (int i = 0; i < samples; ++i)
        for (int j = 0; j < samples; ++j)
          count += inside(column + (i + 0.5) / samples, height - row - (j + 0.5) / samples);
      const auto gray = static_cast<std::uint8_t>(std::lround(255.0 * (1 - double(count) / (samples * samples))));
      image.rgba.insert(image.rgba.end(), {gray, gray, gray, 255});
    }
  }
  return image;
}

double signed_area(const Ring_2& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point_2& p = ring[i];
    const Point_2& q = ring[(i + 1) % ring.size()];
    twice += p.x * q.y - q.x * p.y;
  }
  return twice / 2;
}

/// Gray picture that darkens evenly from 1 to 0 over the pixel around the circle.
Image soft_disk(int width, int height, const Point_2& center, double radius) {
  Image image;
  image.width = width;
  image.height = height;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double depth = radius - distance({column + 0.5, height - row - 0.5}, center);
      const auto gray = static_cast<std::uint8_t>(std::lround(255 * std::clamp(0.5 - depth / 2, 0.0, 1.0)));
      image.rgba.insert(image.rgba.end(), {gray, gray, gray, 255});
    }
  }
  return image;
}

TEST(Silhouette, smooth_disk_within_a_twentieth_of_a_pixel) {
  const Point_2 center{21.3, 17.8};
  const double radius = 12.4;
  const Outline_2 outline = silhouette(soft_disk(40, 36, center, radius));
  ASSERT_EQ(outline.rings.size(), 1U);
  for (const Point_2& p : outline.rings[0]) EXPECT_NEAR(distance(p, center), radius, 0.05);
  EXPECT_NEAR(signed_area(outline.rings[0]), M_PI * radius * radius, 2) << "counterclockwise";
}

TEST(Silhouette, disk_of_covered_pixels_within_a_tenth_of_a_pixel) {
  // Coverage is no linear function across an oblique edge, and interpolation is off by up to 0.08 pixels there.
  const Point_2 center{21.3, 17.8};
  const double radius = 12.4;
  const Outline_2 outline = silhouette(antialiased(40, 36, [&](double x, double y) {
    return distance({x, y}, center) < radius;
  }));
  ASSERT_EQ(outline.rings.size(), 1U);
  double sum = 0;
  for (const Point_2& p : outline.rings[0]) {
    EXPECT_NEAR(distance(p, center), radius, 0.1);
    sum += std::abs(distance(p, center) - radius);
  }
  EXPECT_LT(sum / static_cast<double>(outline.rings[0].size()), 0.04);
}

TEST(Silhouette, a_ring_has_a_hole) {
  const Outline_2 outline = silhouette(antialiased(50, 50, [&](double x, double y) {
    const double r = distance(Point_2{x, y}, Point_2{25, 25});
    return r < 20 && r > 10;
  }));
  ASSERT_EQ(outline.rings.size(), 2U);
  EXPECT_NEAR(signed_area(outline.rings[0]), M_PI * 400, 3);
  EXPECT_NEAR(signed_area(outline.rings[1]), -M_PI * 100, 3) << "holes run clockwise";
}

TEST(Silhouette, a_black_image_is_its_rectangle) {
  const Outline_2 outline = silhouette(antialiased(7, 4, [](double, double) { return true; }));
  ASSERT_EQ(outline.rings.size(), 1U);
  double left = 9, right = -9, bottom = 9, top = -9;
  for (const Point_2& p : outline.rings[0]) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
    bottom = std::min(bottom, p.y);
    top = std::max(top, p.y);
  }
  EXPECT_NEAR(left, 0, 1e-9);
  EXPECT_NEAR(right, 7, 1e-9);
  EXPECT_NEAR(bottom, 0, 1e-9);
  EXPECT_NEAR(top, 4, 1e-9);
  EXPECT_NEAR(signed_area(outline.rings[0]), 28, 0.51) << "less the four corners";
}

TEST(Silhouette, rows_run_downwards) {
  const Outline_2 outline = silhouette(antialiased(10, 20, [](double, double y) { return y > 15; }));
  ASSERT_EQ(outline.rings.size(), 1U);
  for (const Point_2& p : outline.rings[0]) EXPECT_GE(p.y, 15 - 1e-9);
}

TEST(Silhouette, white_and_transparent_images_have_no_ring) {
  EXPECT_TRUE(silhouette(antialiased(5, 5, [](double, double) { return false; })).rings.empty());
  Image image;
  image.width = image.height = 3;
  image.rgba.assign(36, 0);
  EXPECT_TRUE(silhouette(image).rings.empty()) << "transparent black on white paper is white";
  EXPECT_TRUE(silhouette(Image{}).rings.empty());
}

TEST(Silhouette, diagonal_neighbours_join_where_the_middle_is_dark) {
  const auto two_pixels = [](std::uint8_t dark, std::uint8_t light) {
    Image image;
    image.width = image.height = 4;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) {
        const bool center = row >= 1 && row <= 2 && column >= 1 && column <= 2;
        const std::uint8_t gray = !center ? 255 : row == column ? dark : light;
        image.rgba.insert(image.rgba.end(), {gray, gray, gray, 255});
      }
    return silhouette(image).rings.size();
  };
  EXPECT_EQ(two_pixels(0, 140), 1U);
  EXPECT_EQ(two_pixels(120, 255), 2U);
}

TEST(Silhouette, every_ring_of_noise_is_simple_and_closed) {
  std::uint32_t state = 1;
  Image image;
  image.width = 60;
  image.height = 45;
  for (int i = 0; i < 60 * 45; ++i) {
    state = state * 1664525U + 1013904223U;
    const auto gray = static_cast<std::uint8_t>(state >> 24);
    image.rgba.insert(image.rgba.end(), {gray, gray, gray, 255});
  }
  const Outline_2 outline = silhouette(image);
  EXPECT_GT(outline.rings.size(), 50U);
  const auto is_inside = [&](double x, double y) {
    bool inside = false;
    for (const Ring_2& ring : outline.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point_2& p = ring[i];
        const Point_2& q = ring[(i + 1) % ring.size()];
        EXPECT_LE(distance(p, q), 1.5);
        if ((p.y > y) != (q.y > y) && x < p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x)) inside = !inside;
      }
    return inside;
  };
  for (int row = 0; row < 45; ++row)
    for (int column = 0; column < 60; column += 7) {
      const int gray = image.rgba[4 * static_cast<std::size_t>(row * 60 + column)];
      // A single pixel near the level has a ring too small to be kept.
      if (std::abs(gray - 127.5) < 8) continue;
      EXPECT_EQ(is_inside(column + 0.5, 45 - row - 0.5), gray < 127.5) << column << " " << row;
    }
}

}  // namespace
}  // namespace mesecina
