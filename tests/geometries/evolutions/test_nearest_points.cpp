// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/nearest_points.h"

#include <gtest/gtest.h>

#include "../shapes.h"

namespace mesecina::test {
namespace {

using Neighbor = Nearest_points<Point_2>::Neighbor;

std::array<Neighbor, 2> nearest_by_looking_at_all(const std::vector<Point_2>& points, const Point_2& place) {
  std::vector<Neighbor> all(2);
  for (std::size_t i = 0; i < points.size(); ++i)
    all.push_back({squared_distance(place, points[i]), static_cast<int>(i)});
  std::ranges::sort(all);
  return {all[0], all[1]};
}

TEST(Nearest_points, AreThoseFoundByLookingAtAll) {
  for (const auto& [name, points] : difficult_point_sets()) {
    const Nearest_points<Point_2> tree(points);
    std::vector<Point_2> places = uniform_points(100, 5, 3);
    places.insert(places.end(), points.begin(), points.end());
    for (const Point_2& place : places)
      ASSERT_EQ(tree.nearest_two(place), nearest_by_looking_at_all(points, place)) << name;
  }
}

TEST(Nearest_points, OfNoneAreNone) {
  const auto none = Nearest_points<Point_2>({}).nearest_two({0, 0});
  EXPECT_EQ(none[0].point, -1);
  EXPECT_EQ(none[1].point, -1);
  const auto one = Nearest_points<Point_3>({{1, 2, 3}}).nearest_two({0, 0, 0});
  EXPECT_EQ(one[0].point, 0);
  EXPECT_EQ(one[0].squared_distance, 14);
  EXPECT_EQ(one[1].point, -1);
}

}  // namespace
}  // namespace mesecina::test
