// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/balls_2/balls_2.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/outcome.h"
#include "tests/geometries/union/disk_sets.h"
#include "tests/geometries/union/power_oracle.h"

namespace mesecina::test {
namespace {

TEST(Balls_2, are_those_given) {
  const std::vector<Disk_2> disks{{{1, 2}, 3}, {{0.1, -0.0}, 0}};
  const Balls_2 balls = given_balls(disks);
  EXPECT_EQ(balls.centers, (std::vector<Point_2>{{1, 2}, {0.1, -0.0}}));
  EXPECT_EQ(balls.radii, (std::vector<double>{3, 0}));
  EXPECT_FALSE(balls.is_circumscribed());
  EXPECT_TRUE(balls.contacts_of(0).empty());
  EXPECT_EQ(balls.common_contact(std::array{0, 1}), -1);
  EXPECT_EQ(given_balls({}).size(), 0U);
}

TEST(Balls_2, must_be_disks) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  for (const Disk_2& disk : {Disk_2{{0, 0}, -1}, Disk_2{{0, 0}, infinity}, Disk_2{{0, 0}, nothing},
                             Disk_2{{infinity, 0}, 1}, Disk_2{{0, nothing}, 1}})
    EXPECT_THROW(given_balls(std::array{Disk_2{{0, 0}, 1}, disk}), Unavailable);
}

/// Disks of the chosen triangles by trying all samples, exactly.
void expect_circumscribed(std::span<const Point_2> samples, const std::vector<std::uint8_t>& pattern) {
  Progress progress;
  const Delaunay_2 d = delaunay(samples, progress);
  const Voronoi_2 v = voronoi(d, progress);
  std::vector<std::uint8_t> is_chosen(d.triangles.size());
  for (std::size_t t = 0; t < is_chosen.size(); ++t) is_chosen[t] = pattern[t % pattern.size()];
  const Circumscribed_balls_2 result = circumscribed_balls(d, v, is_chosen, progress);

  std::map<std::vector<int>, std::vector<int>> triangles_of_contacts;
  for (int t = 0; t < static_cast<int>(d.triangles.size()); ++t) {
    const auto& [a, b, c] = d.triangles[t];
    std::vector<int> contacts;
    for (int s = 0; s < static_cast<int>(samples.size()); ++s)
      if (d.site[s] == s && in_circle_by_rationals(samples[a], samples[b], samples[c], samples[s]) == 0)
        contacts.push_back(s);
    triangles_of_contacts[contacts].push_back(t);
  }
  struct Expected_ball {
    std::vector<int> contacts;
    std::vector<int> triangles;
  };
  std::map<int, Expected_ball> expected;  // by the least of the chosen triangles
  for (const auto& [contacts, triangles] : triangles_of_contacts) {
    const auto least = std::ranges::find_if(triangles, [&](int t) { return is_chosen[t] != 0; });
    if (least != triangles.end()) expected[*least] = {contacts, triangles};
  }
  const Balls_2& balls = result.balls;
  ASSERT_EQ(balls.size(), expected.size());
  ASSERT_EQ(balls.radii.size(), expected.size());
  ASSERT_EQ(result.triangles.size(), expected.size());
  ASSERT_EQ(result.ball_of_triangle.size(), d.triangles.size());
  std::vector<int> ball_of_triangle(d.triangles.size(), -1);
  std::set<int> seen;
  for (int ball = 0; ball < static_cast<int>(balls.size()); ++ball) {
    ASSERT_TRUE(expected.contains(result.triangles[ball])) << ball;
    EXPECT_TRUE(seen.insert(result.triangles[ball]).second) << ball;
    const auto& [contacts, triangles] = expected.at(result.triangles[ball]);
    EXPECT_TRUE(std::ranges::equal(balls.contacts_of(ball), contacts));
    for (const int t : triangles) ball_of_triangle[t] = ball;
    const Exact_point c = exact_circumcenter(samples[contacts[0]], samples[contacts[1]], samples[contacts[2]]);
    const Point_2 center{CGAL::to_double(c.x), CGAL::to_double(c.y)};
    const double radius = distance(center, samples[contacts[0]]);
    const double tolerance = 1e-6 * radius + 1e-15 * (std::abs(center.x) + std::abs(center.y));
    EXPECT_NEAR(distance(balls.centers[ball], center), 0, tolerance);
    EXPECT_NEAR(balls.radii[ball], radius, tolerance);
  }
  EXPECT_EQ(result.ball_of_triangle, ball_of_triangle);
}

TEST(Balls_2, are_circumscribed_to_the_chosen_triangles) {
  for (const auto& [name, points] : difficult_point_sets()) {
    if (points.size() > 160) continue;
    SCOPED_TRACE(name);
    // Beyond what the centers, as doubles, can hold.
    if (name == "mixed scales") continue;
    expect_circumscribed(points, {1});
    expect_circumscribed(points, {0, 1, 0, 0, 1});
    expect_circumscribed(points, {0});
  }
}

TEST(Balls_2, know_their_common_contacts) {
  const Sampled_family grid_family = sampled_families().back();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Balls_2 balls = grid_family.make(seed).balls;
    const auto expected = [&](std::vector<int> disks) {
      for (int s = 0; s < static_cast<int>(balls.samples->size()); ++s) {
        if (std::ranges::all_of(disks, [&](int i) {
              const auto contacts = balls.contacts_of(i);
              return std::ranges::find(contacts, s) != contacts.end();
            }))
          return s;
      }
      return -1;
    };
    for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
      for (int j = 0; j < static_cast<int>(balls.size()); ++j) {
        EXPECT_EQ(balls.common_contact(std::array{i, j}), expected({i, j}));
        for (int k = 0; k < j; ++k) EXPECT_EQ(balls.common_contact(std::array{i, j, k}), expected({i, j, k}));
      }
    }
  }
}

TEST(Balls_2, keep_what_is_known_of_a_part) {
  const Balls_2 balls = sampled_families().back().make(4).balls;
  ASSERT_GT(balls.size(), 3U);
  const Balls_2 part = subset(balls, std::array{3, 0, 2});
  ASSERT_EQ(part.size(), 3U);
  EXPECT_EQ(part.samples, balls.samples);
  for (const auto& [mine, old] : std::array<std::array<int, 2>, 3>{{{0, 3}, {1, 0}, {2, 2}}}) {
    EXPECT_EQ(part.centers[mine], balls.centers[old]);
    EXPECT_EQ(part.radii[mine], balls.radii[old]);
    EXPECT_TRUE(std::ranges::equal(part.contacts_of(mine), balls.contacts_of(old)));
  }
  const Balls_2 given = subset(given_balls(std::array{Disk_2{{0, 0}, 1}, Disk_2{{1, 0}, 2}}), std::array{1});
  EXPECT_EQ(given.radii, (std::vector<double>{2}));
  EXPECT_FALSE(given.is_circumscribed());
}

TEST(Balls_2, grow) {
  const Balls_2 balls = sampled_families().back().make(4).balls;
  const Balls_2 same = grown(balls, 1);
  EXPECT_EQ(same.samples, balls.samples);
  EXPECT_EQ(same.radii, balls.radii);
  EXPECT_EQ(same.contacts, balls.contacts);
  const Balls_2 larger = grown(balls, 1.5);
  EXPECT_FALSE(larger.is_circumscribed());
  EXPECT_TRUE(larger.contacts_of(0).empty());
  EXPECT_EQ(larger.centers, balls.centers);
  for (std::size_t i = 0; i < balls.size(); ++i) EXPECT_EQ(larger.radii[i], 1.5 * balls.radii[i]);
}

}  // namespace
}  // namespace mesecina::test
