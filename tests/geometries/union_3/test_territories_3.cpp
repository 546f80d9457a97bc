// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <thread>

#include "core/point.h"
#include "geometries/territories_3.h"

namespace mesecina {
namespace {

using Reach = Territories_3::Reach;

std::vector<Reach> things(int count, double reach, const Point_3& size) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> number(0, 1);
  std::vector<Reach> result;
  for (int i = 0; i < count; ++i) {
    const double x = size.x * number(engine);
    const double y = size.y * number(engine);
    const double z = size.z * number(engine);
    result.push_back({{x - reach, y - reach, z - reach}, {x + reach, y + reach, z + reach}});
  }
  return result;
}

/// How many lie in each box with all of them; -1: in none.
std::map<int, int> counts(const Territories_3& territories, const std::vector<Reach>& things) {
  std::map<int, int> result;
  for (const Reach& thing : things) {
    const int box = territories.box_of(thing.lower[0], thing.lower[1], thing.lower[2]);
    bool is_whole = true;
    for (int corner = 1; corner < 8; ++corner)
      is_whole = is_whole && box == territories.box_of((corner & 1 ? thing.upper : thing.lower)[0],
                                                       (corner & 2 ? thing.upper : thing.lower)[1],
                                                       (corner & 4 ? thing.upper : thing.lower)[2]);
    ++result[is_whole ? box : -1];
  }
  return result;
}

TEST(Territories_3, have_about_equally_many_things) {
  const std::vector<Reach> all = things(4000, 0.01, {10, 1, 1});
  for (const int most : {2, 3, 4, 8}) {
    const Territories_3 territories = Territories_3::around(all, most);
    ASSERT_EQ(territories.box_count(), most);
    const auto found = counts(territories, all);
    for (int box = 0; box < most; ++box) {
      EXPECT_GT(found.at(box), 4000 / most * 0.4) << most;
      EXPECT_LT(found.at(box), 4000 / most * 1.6) << most;
    }
    EXPECT_LT(found.contains(-1) ? found.at(-1) : 0, 200) << most;
  }
}

TEST(Territories_3, are_cut_where_little_crosses) {
  // Two heaps, and the middle of all things lies in the larger one.
  std::vector<Reach> all = things(2400, 0.3, {1, 1, 1});
  for (Reach thing : things(1600, 0.3, {1, 1, 1})) {
    thing.lower[1] += 5;
    thing.upper[1] += 5;
    all.push_back(thing);
  }
  const Territories_3 territories = Territories_3::around(all, 2);
  ASSERT_EQ(territories.box_count(), 2);
  auto found = counts(territories, all);
  EXPECT_LE(found[-1], 4000 / 64) << "cuts are tried at so many places";
  EXPECT_GE(std::min(found[0], found[1]), 1600 - 4000 / 64);
}

TEST(Territories_3, are_one_where_cuts_are_of_no_use) {
  EXPECT_EQ(Territories_3().box_count(), 1);
  EXPECT_EQ(Territories_3().box_of(1, 2, 3), 0);
  EXPECT_EQ(Territories_3::around({}, 4).box_count(), 1);
  EXPECT_EQ(Territories_3::around(things(3, 0, {1, 1, 1}), 4).box_count(), 1);
  EXPECT_EQ(Territories_3::around(things(4000, 0, {1, 1, 1}), 1).box_count(), 1);
  EXPECT_EQ(Territories_3::around(things(4000, 1, {1, 1, 1}), 4).box_count(), 1) << "all are everywhere";
  EXPECT_EQ(Territories_3::around(things(4000, 0, {0, 0, 0}), 4).box_count(), 1) << "all at one place";
  EXPECT_EQ(Territories_3::around(things(4000, std::numeric_limits<double>::infinity(), {1, 1, 1}), 4).box_count(), 1);
}

struct Place {
  double x_, y_, z_;
  double x() const { return x_; }
  double y() const { return y_; }
  double z() const { return z_; }
};

TEST(Territory_locks_3, let_a_thread_have_what_is_its_own_only) {
  Territory_locks_3 locks(Territories_3::around(things(4000, 0.01, {10, 1, 1}), 2));
  ASSERT_EQ(locks.territories().box_count(), 2);
  const Place low{0, 0.5, 0.5};
  const Place high{10, 0.5, 0.5};
  constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(locks.try_lock(low));
  const int box = locks.territories().box_of(0, 0.5, 0.5);
  locks.take(box);
  EXPECT_TRUE(locks.try_lock(low));
  EXPECT_FALSE(locks.try_lock(high));
  EXPECT_FALSE(locks.try_lock(Place{nowhere, nowhere, nowhere}));
  std::thread([&] {
    EXPECT_FALSE(locks.try_lock(low));
    locks.take(1 - box);
    EXPECT_TRUE(locks.try_lock(high));
  }).join();
  EXPECT_TRUE(locks.try_lock(low));
  locks.leave(box);
  EXPECT_FALSE(locks.try_lock(low));
}

}  // namespace
}  // namespace mesecina
