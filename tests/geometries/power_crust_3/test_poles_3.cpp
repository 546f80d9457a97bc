// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/outcome.h"
#include "geometries/power_crust_3/power_crust_3.h"
#include "tests/geometries/power_crust_3/delaunay_oracle_3.h"

namespace mesecina::test {
namespace {

Poles_3 poles_of(const Cloud& cloud, int threads = 1) {
  Progress progress({}, {}, threads);
  return find_poles(cloud, progress);
}

std::string reason_without_poles(const Cloud& cloud) {
  try {
    poles_of(cloud);
  } catch (const Unavailable& unavailable) {
    return unavailable.what();
  }
  return {};
}

Contacts contacts_of(const Poles_3& poles, int pole) {
  const auto span = poles.contacts_of(pole);
  return {span.begin(), span.end()};
}

std::vector<Cloud> clouds_with_poles() {
  std::vector<Cloud> clouds{lattice(3), joined(random_cloud(20, 3), random_cloud(20, 3))};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) clouds.push_back(random_cloud(30, seed));
  for (std::uint64_t seed = 1; seed <= 8; ++seed) clouds.push_back(integer_cloud(30, 4, seed));
  return clouds;
}

/// Checks one sample inside of the hull by the definition; `spheres` are those through it.
void expect_poles(const Cloud& cloud, const Poles_3& poles, int sample, const std::vector<Contacts>& spheres) {
  const int first = poles.first[sample];
  ASSERT_GE(first, 0);
  ASSERT_FALSE(poles.is_infinite(first));
  const Contacts first_sphere = contacts_of(poles, first);
  EXPECT_EQ(std::ranges::count(spheres, first_sphere), 1);
  for (const Contacts& sphere : spheres) EXPECT_FALSE(has_larger_radius(cloud, sphere, first_sphere));

  std::vector<Contacts> opposite;
  for (const Contacts& sphere : spheres)
    if (are_opposite(cloud, sample, first_sphere, sphere)) opposite.push_back(sphere);
  const int second = poles.second[sample];
  ASSERT_EQ(second >= 0, !opposite.empty());
  if (second < 0) return;
  const Contacts second_sphere = contacts_of(poles, second);
  EXPECT_EQ(std::ranges::count(opposite, second_sphere), 1);
  for (const Contacts& sphere : opposite) EXPECT_FALSE(has_larger_radius(cloud, sphere, second_sphere));
}

TEST(Poles_3, AreTheFarthestVoronoiVerticesOnTwoSides) {
  int checked = 0;
  for (const Cloud& cloud : clouds_with_poles()) {
    const Poles_3 poles = poles_of(cloud);
    const std::set<Contacts> all = empty_spheres(cloud);
    for (int s = 0; s < static_cast<int>(cloud.size()); ++s) {
      if (std::ranges::find(cloud, cloud[s]) - cloud.begin() != s) {
        EXPECT_EQ(poles.first[s], -1);
        EXPECT_EQ(poles.second[s], -1);
        continue;
      }
      std::vector<Contacts> spheres;
      for (const Contacts& sphere : all)
        if (std::ranges::binary_search(sphere, s)) spheres.push_back(sphere);
      constexpr double far = 100;
      if (is_on_hull(cloud, s, s)) {
        ASSERT_GE(poles.first[s], 0);
        EXPECT_TRUE(poles.is_infinite(poles.first[s]));
        if (const int second = poles.second[s]; second >= 0) {
          EXPECT_FALSE(poles.is_infinite(second));
          EXPECT_EQ(std::ranges::count(spheres, contacts_of(poles, second)), 1);
        }
      } else if (std::ranges::all_of(spheres, [&](const Contacts& c) { return radius_of(cloud, c) < far; })) {
        ++checked;
        expect_poles(cloud, poles, s, spheres);
      }
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(Poles_3, KnowTheirSamples) {
  const Cloud cloud = joined(torus_cloud(1, 0.4, 600, 1), {{1.4, 0, 0}, {1.4, 0, 0}});
  const Poles_3 poles = poles_of(cloud);
  EXPECT_EQ(poles.sample_count, cloud.size());
  EXPECT_EQ(std::ranges::count(poles.first, -1), 1);
  std::size_t listed = 0;
  for (int p = 0; p < static_cast<int>(poles.size()); ++p) {
    EXPECT_TRUE(std::ranges::is_sorted(poles.contacts_of(p)));
    for (const int contact : poles.contacts_of(p))
      EXPECT_NEAR(distance(poles.points[contact], poles.balls[p].center), poles.balls[p].radius,
                  1e-9 * poles.balls[p].radius);
    const bool has_far = poles.contacts_of(p).back() >= static_cast<int>(cloud.size());
    EXPECT_EQ(poles.is_infinite(p), has_far);
    for (const int sample : poles.samples_of(p)) {
      ++listed;
      EXPECT_TRUE(poles.first[sample] == p || poles.second[sample] == p);
      EXPECT_TRUE(std::ranges::binary_search(poles.contacts_of(p), sample));
      const int other = poles.opposite(p, sample);
      EXPECT_EQ(other, poles.first[sample] == p ? poles.second[sample] : poles.first[sample]);
    }
    if (!has_far) {
      EXPECT_FALSE(poles.samples_of(p).empty());
    }
  }
  const auto has_pole = [](int pole) { return pole >= 0; };
  EXPECT_EQ(listed, std::ranges::count_if(poles.first, has_pole) + std::ranges::count_if(poles.second, has_pole));
}

TEST(Poles_3, OfAHullPointInwardAtSharpCorners) {
  // A long needle: the tip's cell is much more than half of space.
  const Cloud needle{{0, 0, 0}, {0.1, 0, 1}, {-0.1, 0.1, 1}, {-0.1, -0.1, 1}, {0, 0, 0.8}};
  const Poles_3 poles = poles_of(needle);
  EXPECT_TRUE(poles.is_infinite(poles.first[0]));
  ASSERT_GE(poles.second[0], 0);
  EXPECT_FALSE(poles.is_infinite(poles.second[0]));
  EXPECT_GT(poles.balls[poles.second[0]].center.z, 0.1);
  const Poles_3 of_cube = poles_of(lattice(2));
  EXPECT_EQ(of_cube.finite_count, 1u);
  EXPECT_EQ(of_cube.samples_of(0).size(), 8u);
}

TEST(Poles_3, SaysWhyThereAreNone) {
  EXPECT_EQ(reason_without_poles({}), "needs at least 4 distinct points that are not in one plane; there are 0");
  EXPECT_EQ(reason_without_poles(Cloud(9, Point_3{1, 2, 3})),
            "needs at least 4 distinct points that are not in one plane; there is 1");
  EXPECT_EQ(reason_without_poles(joined({{1, 2, 3}, {1, 2, 4}, {1, 3, 3}}, {{1, 2, 3}, {1, 2, 4}, {1, 3, 3}})),
            "needs at least 4 distinct points that are not in one plane; there are 3");
  EXPECT_EQ(reason_without_poles({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {9, 9, 9}}),
            "all points lie on one line");
  EXPECT_EQ(reason_without_poles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {5, 4, 0}}),
            "all points lie in one plane");
  EXPECT_EQ(reason_without_poles({{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {2, 1, 1e-9}}),
            "all points lie nearly in one plane");
  EXPECT_EQ(reason_without_poles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), "");
}

TEST(Poles_3, OneThreadAndTwoGiveTheSame) {
  const Cloud cloud = ellipsoid_cloud(12000, 4);
  const Poles_3 a = poles_of(cloud, 1);
  const Poles_3 b = poles_of(cloud, 2);
  EXPECT_EQ(a.balls, b.balls);
  EXPECT_EQ(a.contacts, b.contacts);
  EXPECT_EQ(a.first, b.first);
  EXPECT_EQ(a.second, b.second);
}

TEST(Poles_3, StopsWhenCancelled) {
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  EXPECT_THROW(find_poles(random_cloud(100, 1), progress), Cancelled);
}

TEST(Intersection_cosine_3, IsThatOfTheBalls) {
  const Poles_3 poles = poles_of(torus_cloud(1, 0.4, 300, 7));
  int shared = 0;
  for (int a = 0; a < static_cast<int>(poles.finite_count); a += 3) {
    for (int b = 1; b < static_cast<int>(poles.finite_count); b += 5) {
      const auto& [p, r] = poles.balls[a];
      const auto& [q, s] = poles.balls[b];
      const double cosine = (r * r + s * s - squared_distance(p, q)) / (2 * r * s);
      EXPECT_NEAR(intersection_cosine(poles, a, b), cosine, 1e-6 * (1 + std::abs(cosine)));
      if (std::ranges::find_first_of(poles.contacts_of(a), poles.contacts_of(b)) != poles.contacts_of(a).end())
        ++shared;
    }
  }
  EXPECT_GT(shared, 10);
}

}  // namespace
}  // namespace mesecina::test
