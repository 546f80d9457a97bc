// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "tests/geometries/results.h"
#include "tests/geometries/scale_axis/scale_stages.h"
#include "tests/geometries/union/disk_sets.h"

namespace mesecina::test {
namespace {

/// Of two equal disks each through the center of the other halving makes some that meet at 150 degrees exactly; at this
/// angle nothing is decided by rounding.
constexpr double sampling_min_angle = 140;

/// Coordinates and radii rounded to 2^-20 of the units: moving them by powers of two loses nothing.
std::vector<Disk_2> short_numbers(std::vector<Disk_2> disks) {
  const auto rounded = [](double value) { return std::ldexp(std::nearbyint(std::ldexp(value, 20)), -20); };
  for (Disk_2& disk : disks) disk = {{rounded(disk.center.x), rounded(disk.center.y)}, rounded(disk.radius)};
  return disks;
}

struct Similarity {
  std::string name;
  std::function<Point_2(const Point_2&)> move;
  double factor = 1;
};

std::vector<Similarity> similarities() {
  return {
      {"translation",
       [](const Point_2& p) {
         return Point_2{p.x + 1024, p.y - 512};
       },
       1},
      {"doubling",
       [](const Point_2& p) {
         return Point_2{2 * p.x, 2 * p.y};
       },
       2},
      {"shrinking",
       [](const Point_2& p) {
         return Point_2{std::ldexp(p.x, -30), std::ldexp(p.y, -30)};
       },
       std::ldexp(1, -30)},
      {"reflection",
       [](const Point_2& p) {
         return Point_2{-p.x, p.y};
       },
       1},
      {"quarter turn",
       [](const Point_2& p) {
         return Point_2{-p.y, p.x};
       },
       1},
      {"all",
       [](const Point_2& p) {
         return Point_2{4 * p.y + 64, 4 * p.x - 256};
       },
       4},
  };
}

/// The disks of a scale axis, and its edges by the disks at their ends.
struct Parts {
  std::vector<Disk_2> disks;
  std::vector<std::array<Disk_2, 2>> edges;
};
Parts parts_of(const Scale_axis_2& axis) {
  Parts result;
  for (std::size_t b = 0; b < axis.centers.size(); ++b) result.disks.push_back({axis.centers[b], axis.radii[b]});
  for (const auto& [a, b] : axis.edges) result.edges.push_back({result.disks[a], result.disks[b]});
  return result;
}

bool are_near(const Disk_2& a, const Disk_2& b, double tolerance) {
  return std::abs(a.center.x - b.center.x) <= tolerance && std::abs(a.center.y - b.center.y) <= tolerance &&
         std::abs(a.radius - b.radius) <= tolerance;
}

/// Every part of one has one of the other near it.
testing::AssertionResult are_within(const Parts& parts, const Parts& others, double tolerance) {
  for (const Disk_2& disk : parts.disks)
    if (std::ranges::none_of(others.disks, [&](const Disk_2& other) { return are_near(disk, other, tolerance); }))
      return failure() << "a disk at " << disk.center.x << ", " << disk.center.y << " of radius " << disk.radius
                       << " has no partner";
  for (const auto& [a, b] : parts.edges) {
    // Where more than three circles pass through a point, edges without length come and go.
    if (are_near(a, b, tolerance)) continue;
    const auto is_partner = [&](const std::array<Disk_2, 2>& other) {
      return (are_near(a, other[0], tolerance) && are_near(b, other[1], tolerance)) ||
             (are_near(a, other[1], tolerance) && are_near(b, other[0], tolerance));
    };
    if (std::ranges::none_of(others.edges, is_partner)) return failure() << "an edge has no partner";
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult are_equal(const Parts& found, const Parts& expected, double tolerance) {
  if (auto result = are_within(found, expected, tolerance); !result) return result << " among those expected";
  if (auto result = are_within(expected, found, tolerance); !result) return result << " among those found";
  return testing::AssertionSuccess();
}

double distance_to_segment(const Point_2& point, const Point_2& a, const Point_2& b) {
  const double square = squared_distance(a, b);
  const double along = (point.x - a.x) * (b.x - a.x) + (point.y - a.y) * (b.y - a.y);
  const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
  return distance(point, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
}

/// As a set, without what lies between vertices that are one but for rounding.
testing::AssertionResult is_within(const Union_medial_axis_2& axis, const Union_medial_axis_2& other,
                                   const Similarity& similarity, double tolerance) {
  constexpr double negligible_angle = 1e-3;
  const std::vector<double> angles = angle_of_edges(axis);
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    if (angles[e] < negligible_angle) continue;
    const Point_2& a = axis.centers[axis.edges[e][0]];
    const Point_2& b = axis.centers[axis.edges[e][1]];
    for (const double t : {0.0, 0.3, 0.5, 0.9, 1.0}) {
      const Point_2 point = similarity.move({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& [c, d] : other.edges)
        nearest = std::min(nearest, distance_to_segment(point, other.centers[c], other.centers[d]));
      if (!(nearest <= tolerance * similarity.factor))
        return failure() << "an edge of " << angles[e] << " degrees is " << nearest << " off";
    }
  }
  return testing::AssertionSuccess();
}

Parts scale_axis_of(const std::vector<Disk_2>& disks, double scale, double min_angle) {
  return parts_of(scale_stages(std::make_shared<const Balls_2>(given_balls(disks)), scale)
                      .scale_axis(min_angle, sampling_min_angle));
}

const std::vector<std::string> general_families{"sparse", "dense", "nested", "equal radii", "ring", "tiny in large"};

std::shared_ptr<const Balls_2> with_short_numbers(const Balls_2& balls) {
  std::vector<Disk_2> disks;
  for (std::size_t b = 0; b < balls.size(); ++b) disks.push_back({balls.centers[b], balls.radii[b]});
  return std::make_shared<const Balls_2>(given_balls(short_numbers(disks)));
}

std::shared_ptr<const Balls_2> moved_balls(const Balls_2& balls, const Similarity& similarity) {
  Balls_2 result;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    result.centers.push_back(similarity.move(balls.centers[b]));
    result.radii.push_back(balls.radii[b] * similarity.factor);
  }
  return std::make_shared<const Balls_2>(result);
}

/// Disks in general position.
testing::AssertionResult moves_with_its_disks(const Balls_2& balls) {
  const auto disks = with_short_numbers(balls);
  const Scale_stages stages = scale_stages(disks, 1);
  for (const Similarity& similarity : similarities()) {
    const Scale_stages others = scale_stages(moved_balls(*disks, similarity), 1);
    for (const double scale : {1.0, 1.25}) {
      Parts expected = parts_of(at_scale(stages, scale).scale_axis(30, sampling_min_angle));
      const auto move = [&](Disk_2& disk) { disk = {similarity.move(disk.center), disk.radius * similarity.factor}; };
      std::ranges::for_each(expected.disks, move);
      for (auto& [a, b] : expected.edges) {
        move(a);
        move(b);
      }
      const Parts found = parts_of(at_scale(others, scale).scale_axis(30, sampling_min_angle));
      if (auto result = are_equal(found, expected, 1e-8 * similarity.factor); !result)
        return result << ", scale " << scale << ", " << similarity.name;
    }
  }
  return testing::AssertionSuccess();
}

/// Disks in special position: once they have grown, rounding decides which edges are complete, but not where edges
/// are.
testing::AssertionResult axis_moves_with_its_disks(const std::shared_ptr<const Balls_2>& balls) {
  const auto disks = with_short_numbers(*balls);
  // Moves must lose nothing.
  for (std::size_t b = 0; b < disks->size(); ++b)
    if (std::abs(disks->centers[b].x) > 1e6 || disks->radii[b] > 1e6) return testing::AssertionSuccess();
  const Scale_stages stages = scale_stages(disks, 1);
  for (const Similarity& similarity : similarities()) {
    const Scale_stages others = scale_stages(moved_balls(*disks, similarity), 1);
    for (const double scale : {1.0, 1.25, 2.0}) {
      const Scale_stages grown = at_scale(stages, scale);
      if (auto result = is_within(grown.grown_axis, at_scale(others, scale).grown_axis, similarity, 1e-6); !result)
        return result << ", scale " << scale << ", " << similarity.name;
    }
  }
  return testing::AssertionSuccess();
}

TEST(Scale_axis_2, moves_with_its_disks) {
  for (const Disk_family& family : disk_families()) {
    if (std::ranges::count(general_families, family.name) == 0) continue;
    for (std::uint64_t seed = 0; seed < repetitions(3); ++seed) {
      SCOPED_TRACE(family.name + " " + std::to_string(seed));
      EXPECT_TRUE(moves_with_its_disks(given_balls(family.make(seed))));
    }
  }
  expect_of_given_balls(repetitions(2), axis_moves_with_its_disks);
}

std::shared_ptr<const Balls_2> in_another_order(const Balls_2& balls) {
  const int count = static_cast<int>(balls.size());
  return std::make_shared<const Balls_2>(subset(balls, random_permutation(count, static_cast<std::uint64_t>(count))));
}

testing::AssertionResult axis_is_the_same_in_another_order(const std::shared_ptr<const Balls_2>& balls) {
  const Scale_stages stages = scale_stages(balls, 1);
  const Scale_stages others = scale_stages(in_another_order(*balls), 1);
  const Similarity none{"", [](const Point_2& p) { return p; }, 1};
  for (const double scale : {1.0, 1.25, 2.0}) {
    const Scale_stages grown = at_scale(stages, scale);
    if (auto result = is_within(grown.grown_axis, at_scale(others, scale).grown_axis, none, 1e-6 * grown.extent());
        !result)
      return result << ", scale " << scale;
  }
  return testing::AssertionSuccess();
}

TEST(Scale_axis_2, does_not_depend_on_the_order_of_the_disks) {
  for (const Disk_family& family : disk_families()) {
    if (std::ranges::count(general_families, family.name) == 0) continue;
    for (std::uint64_t seed = 0; seed < repetitions(8); ++seed) {
      SCOPED_TRACE(family.name + " " + std::to_string(seed));
      const Balls_2 balls = given_balls(family.make(seed));
      const Scale_stages stages = scale_stages(std::make_shared<const Balls_2>(balls), 1);
      const Scale_stages others = scale_stages(in_another_order(balls), 1);
      for (const double scale : {1.0, 1.25, 2.0}) {
        const Scale_stages grown = at_scale(stages, scale);
        EXPECT_TRUE(are_equal(parts_of(at_scale(others, scale).scale_axis(30, sampling_min_angle)),
                              parts_of(grown.scale_axis(30, sampling_min_angle)), 1e-9 * grown.extent()))
            << scale;
      }
    }
  }
  expect_of_given_balls(repetitions(4), axis_is_the_same_in_another_order);
  expect_of_circumscribed_balls(repetitions(2), axis_is_the_same_in_another_order);
}

TEST(Scale_axis_2, is_the_same_to_the_last_digit_when_scaled_by_a_power_of_two) {
  for (const Disk_family& family : disk_families()) {
    if (family.name == "extreme scale") continue;
    for (std::uint64_t seed = 0; seed < repetitions(5); ++seed) {
      SCOPED_TRACE(family.name + " " + std::to_string(seed));
      const std::vector<Disk_2> disks = family.make(seed);
      for (const double scale : {1.0, 1.3}) {
        const Parts original = scale_axis_of(disks, scale, 30);
        const Parts found = scale_axis_of(scaled(disks, 12), scale, 30);
        EXPECT_EQ(found.disks, scaled(original.disks, 12));
        EXPECT_EQ(found.edges.size(), original.edges.size());
      }
    }
  }
}

}  // namespace
}  // namespace mesecina::test
