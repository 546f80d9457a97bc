// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "core/formats/outline_crossings.h"
#include "core/formats/ring_nesting.h"
#include "tests/growth.h"

namespace mesecina {
namespace {

/// For coordinates that are small integers: solves for the parameters of the common point in integers.
bool interiors_meet(const Point_2& p, const Point_2& p_end, const Point_2& q, const Point_2& q_end) {
  const auto cross = [](std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
    return ax * by - ay * bx;
  };
  const auto integer = [](double x) { return static_cast<std::int64_t>(x); };
  const std::int64_t rx = integer(p_end.x - p.x);
  const std::int64_t ry = integer(p_end.y - p.y);
  const std::int64_t sx = integer(q_end.x - q.x);
  const std::int64_t sy = integer(q_end.y - q.y);
  const std::int64_t wx = integer(q.x - p.x);
  const std::int64_t wy = integer(q.y - p.y);
  std::int64_t denominator = cross(rx, ry, sx, sy);
  if (denominator == 0) {
    if (cross(wx, wy, rx, ry) != 0) return false;
    const std::int64_t begin = wx * rx + wy * ry;
    const std::int64_t end = begin + sx * rx + sy * ry;
    return std::max(begin, end) > 0 && std::min(begin, end) < rx * rx + ry * ry;
  }
  std::int64_t t = cross(wx, wy, sx, sy);
  std::int64_t u = cross(wx, wy, rx, ry);
  if (denominator < 0) {
    denominator = -denominator;
    t = -t;
    u = -u;
  }
  return t > 0 && t < denominator && u > 0 && u < denominator;
}

Outline_crossings brute_force(const Outline_2& outline) {
  Outline_crossings result;
  std::vector<Outline_side> sides;
  for (std::size_t r = 0; r < outline.rings.size(); ++r)
    for (std::size_t i = 0; i < outline.rings[r].size(); ++i) sides.push_back({r, i});
  const auto from = [&](const Outline_side& side) { return outline.rings[side.ring][side.segment]; };
  const auto to = [&](const Outline_side& side) {
    const Ring_2& ring = outline.rings[side.ring];
    return ring[(side.segment + 1) % ring.size()];
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      if (!interiors_meet(from(sides[i]), to(sides[i]), from(sides[j]), to(sides[j]))) continue;
      if (result.count++ == 0) {
        result.first = sides[i];
        result.second = sides[j];
      }
    }
  }
  return result;
}

TEST(Outline_crossings, AgreeWithBruteForceOnSmallGrids) {
  std::mt19937 random(2);
  std::size_t found_some = 0;
  std::size_t found_none = 0;
  for (int round = 0; round < 3000; ++round) {
    const int size = 2 + round % 30;
    std::uniform_int_distribution<int> coordinate(0, size);
    Outline_2 outline;
    for (int r = 0; r < 1 + round % 4; ++r) {
      Ring_2 ring;
      while (ring.size() < 3u + static_cast<std::size_t>(round % 7)) {
        const Point_2 p{double(coordinate(random)), double(coordinate(random))};
        if (ring.empty() || (p != ring.back() && p != ring.front())) ring.push_back(p);
      }
      outline.rings.push_back(ring);
    }
    const Outline_crossings expected = brute_force(outline);
    const Outline_crossings found = find_crossings(outline);
    ASSERT_EQ(found.count, expected.count) << round;
    ASSERT_TRUE(found.is_complete);
    if (expected.count != 0) {
      ASSERT_EQ(found.first, expected.first) << round;
      ASSERT_EQ(found.second, expected.second) << round;
    }
    ++(expected.count == 0 ? found_none : found_some);
  }
  EXPECT_GT(found_some, 500u);
  EXPECT_GT(found_none, 50u);
}

TEST(Outline_crossings, TouchingIsNone) {
  EXPECT_EQ(find_crossings({{{{0, 0}, {2, 0}, {2, 2}}, {{1, 0}, {0, -1}, {2, -1}}}}).count, 0u);
  EXPECT_EQ(find_crossings({{{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}}}).count, 0u);
}

TEST(Outline_crossings, OverlapsAndSpikesAreSome) {
  EXPECT_EQ(find_crossings({{{{0, 0}, {4, 0}, {2, 4}}, {{1, 0}, {3, 0}, {2, -4}}}}).count, 1u);
  EXPECT_EQ(find_crossings({{{{0, 0}, {4, 0}, {2, 0}, {2, 4}}}}).count, 1u);
}

TEST(Outline_crossings, AreExact) {
  // The last vertex is one unit in the last place above and below the line through the others.
  const double up = std::nextafter(0.3, 1);
  const double down = std::nextafter(0.3, 0);
  EXPECT_EQ(find_crossings({{{{0, 0}, {1, 1}, {1, -1}}, {{0.3, up}, {0.2, 5}, {0.1, 5}}}}).count, 0u);
  EXPECT_EQ(find_crossings({{{{0, 0}, {1, 1}, {1, -1}}, {{0.3, down}, {0.2, 5}, {0.1, 5}}}}).count, 2u);
}

TEST(Outline_crossings, GiveTheirPlace) {
  const Outline_crossings found = find_crossings({{{{0, 0}, {10, 0}, {10, 10}}, {{4, -3}, {4, 3}, {5, -3}}}});
  EXPECT_EQ(found.count, 2u);
  EXPECT_EQ(found.first, (Outline_side{0, 0}));
  EXPECT_EQ(found.second, (Outline_side{1, 0}));
  EXPECT_EQ(found.place, (Point_2{4, 0}));
}

TEST(Outline_crossings, TooManyAreNotAllCounted) {
  Ring_2 star;
  constexpr int count = 3001;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i * std::int64_t{count / 2} % count) / count;
    star.push_back({std::cos(angle), std::sin(angle)});
  }
  const Outline_crossings found = find_crossings({{star}});
  EXPECT_FALSE(found.is_complete);
  EXPECT_EQ(found.count, 1000000u);
  EXPECT_LT(std::hypot(found.place.x, found.place.y), 1);
}

TEST(Outline_crossings, TakeLittleTimeOnManyVertices) {
  Outline_2 outline;
  for (int r = 0; r < 62; ++r) {
    Ring_2 ring;
    for (int i = 0; i < 1000; ++i) {
      const double angle = 2 * std::numbers::pi * i / 1000;
      const double radius = 10 + r + 0.4 * std::sin(40 * angle);
      ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    outline.rings.push_back(std::move(ring));
  }
  EXPECT_EQ(find_crossings(outline).count, 0u);
  Outline_2 smaller = outline;
  smaller.rings.resize(6);
  EXPECT_LT(test::growth([&] { find_crossings(smaller); }, [&] { find_crossings(outline); }, 20), 35);
}

Ring_2 square(double x, double y, double half) {
  return {{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}};
}

TEST(Ring_nesting, FollowsDepth) {
  const Outline_2 outline{{square(0, 0, 1), square(0, 0, 4), square(20, 0, 1), square(0, 0, 10), square(0, 0, 3),
                           square(-6, 0, 1), square(20, 0, 5), square(0, 0, 2)}};
  // 3 contains 1 contains 4 contains 7 contains 0; 5 is a second hole of 3; 6 contains 2.
  const std::vector<Polygon_rings> expected = {{0}, {3, 1, 5}, {4, 7}, {6, 2}};
  EXPECT_EQ(nest_rings(outline), expected);
}

TEST(Ring_nesting, TouchingRings) {
  const Outline_2 inside{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 0}, {4, 2}, {2, 4}, {0, 2}}}};
  EXPECT_EQ(nest_rings(inside), (std::vector<Polygon_rings>{{0, 1}}));
  const Outline_2 beside{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{4, 4}, {8, 0}, {8, 8}}}};
  EXPECT_EQ(nest_rings(beside), (std::vector<Polygon_rings>{{0}, {1}}));
}

}  // namespace
}  // namespace mesecina
