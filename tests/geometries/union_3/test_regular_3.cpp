// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/outcome.h"
#include "geometries/scatter.h"
#include "geometries/union_3/regular_3.h"
#include "geometries/union_3/union_3.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"
#include "tests/geometries/union_3/ball_sets.h"
#include "tests/geometries/union_3/power_oracle_3.h"

namespace mesecina::test {
namespace {

/// In every respect that the header promises.
testing::AssertionResult is_regular_triangulation(const std::vector<Ball_3>& balls) {
  Progress progress;
  const Regular_3 regular = regular_triangulation(balls, progress);
  if (regular.balls != balls) return failure() << "other balls";
  const std::vector<std::uint8_t> is_concentric = are_concentric_with_another(balls);
  std::vector<std::uint8_t> is_used(balls.size());
  std::vector<int> shown;
  for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
    if (is_concentric[i] && regular.cell_of_ball[i] != -1) return failure() << "ball " << i << " is not hidden";
    if (regular.cell_of_ball[i] != -1) shown.push_back(i);
  }
  const bool is_spatial = std::ranges::any_of(shown, [&](int d) {
    return std::ranges::any_of(shown, [&](int c) {
      return std::ranges::any_of(
          shown, [&](int b) { return orientation(balls[shown[0]], balls[b], balls[c], balls[d]) != 0; });
    });
  });
  for (int i = 0; i < static_cast<int>(regular.cells.size()); ++i) {
    const auto& cell = regular.cells[i];
    const auto infinite = std::ranges::count(cell, -1);
    if (regular.is_infinite(i) != (infinite > 0)) return failure() << "is_infinite is wrong";
    if (is_spatial && infinite > 1) return failure() << "an infinite cell in space has less than three balls";
    for (const int ball : cell)
      if (ball >= 0) is_used[ball] = 1;
    for (int place = 0; place < 4; ++place) {
      const int other = regular.neighbors[i][place];
      if (other < 0) {
        if (is_spatial) return failure() << "a cell has no neighbor";
        continue;
      }
      const auto& neighbors = regular.neighbors[other];
      if (is_spatial && std::ranges::count(neighbors, i) == 0) return failure() << "a neighbor does not know it";
      for (int k = 0; k < 4; ++k)
        if (k != place && std::ranges::find(regular.cells[other], cell[k]) == regular.cells[other].end())
          return failure() << "a neighbor lacks a ball";
    }
    if (!is_spatial) continue;
    if (infinite == 0) {
      if (orientation(balls[cell[0]], balls[cell[1]], balls[cell[2]], balls[cell[3]]) != 1)
        return failure() << "a cell is not positive";
      for (int k = 0; k < static_cast<int>(balls.size()); ++k)
        if (power_sign(balls, cell, k) < 0) return failure() << "ball " << k << " conflicts with a cell";
    } else {
      // No center beyond the hull.
      std::vector<int> facet;
      for (const int ball : cell)
        if (ball >= 0) facet.push_back(ball);
      bool is_above = false;
      bool is_below = false;
      for (const int k : shown) {
        const int side = orientation(balls[facet[0]], balls[facet[1]], balls[facet[2]], balls[k]);
        is_above = is_above || side > 0;
        is_below = is_below || side < 0;
      }
      if (is_above && is_below) return failure() << "the hull is not convex";
    }
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const int cell = regular.cell_of_ball[i];
    if (is_used[i] != (cell >= 0)) return failure() << "ball " << i << " is hidden and in a cell, or neither";
    if (cell >= 0 && std::ranges::find(regular.cells[cell], static_cast<int>(i)) == regular.cells[cell].end())
      return failure() << "the cell of ball " << i << " lacks it";
  }
  return testing::AssertionSuccess();
}

TEST(Regular_3, is_what_the_header_promises) { expect_of_balls(repetitions(100), is_regular_triangulation); }

testing::AssertionResult is_same(const Regular_3& a, const Regular_3& b) {
  if (a.balls != b.balls) return failure() << "other balls";
  if (a.cell_of_ball != b.cell_of_ball) return failure() << "other cells of balls";
  if (a.cells != b.cells || a.neighbors != b.neighbors) return failure() << "other cells";
  return testing::AssertionSuccess();
}

/// Of sets that become larger, or other ones, as if each were triangulated alone.
testing::AssertionResult grows(const std::vector<Ball_3>& balls, int threads) {
  Progress progress({}, {}, threads);
  Growing_regular_3 growing;
  Random random(balls.size());
  const auto part = [&](int all, int wanted) {
    std::vector<Ball_3> some;
    for (const Ball_3& ball : balls)
      if (random.index(all) < wanted) some.push_back(ball);
    if (some.empty()) some.push_back(balls.front());
    return some;
  };
  // Parts of each other, which is seldom so by chance, and then others.
  std::vector<std::vector<Ball_3>> sets{part(3, 2)};
  for (const std::size_t left : {balls.size() / 8, std::size_t{0}}) {
    std::vector<Ball_3> larger;
    std::size_t at = 0;
    std::size_t missing = balls.size() - sets.back().size();
    for (const Ball_3& ball : balls) {
      const bool is_there = at < sets.back().size() && sets.back()[at] == ball;
      if (is_there) ++at;
      if (!is_there && missing-- <= left) continue;
      larger.push_back(ball);
    }
    sets.push_back(std::move(larger));
  }
  sets.push_back(sets.back());
  sets.push_back(part(2, 1));
  sets.push_back(balls);
  for (std::size_t i = 0; i < sets.size(); ++i)
    if (const auto result = is_same(growing.triangulate(sets[i], progress), regular_triangulation(sets[i], progress));
        !result)
      return failure() << "set " << i << " of " << sets[i].size() << " balls: " << result.message();
  return testing::AssertionSuccess();
}

TEST(Growing_regular_3, is_the_triangulation_of_each_set) {
  expect_of_balls(repetitions(60), [](const std::vector<Ball_3>& balls) { return grows(balls, 1); });
  for (const int threads : {1, 2}) EXPECT_TRUE(grows(many_balls(20'000, 6, 9), threads));
}

TEST(Growing_regular_3, goes_on_after_it_was_cancelled) {
  const std::vector<Ball_3> balls = many_balls(3000, 6, 2);
  const std::vector<Ball_3> first(balls.begin(), balls.begin() + 2500);
  Growing_regular_3 growing;
  Progress progress;
  growing.triangulate(first, progress);
  std::stop_source stop;
  Progress cancelled(stop.get_token(), {}, 1);
  stop.request_stop();
  EXPECT_THROW(growing.triangulate(balls, cancelled), Cancelled);
  EXPECT_TRUE(is_same(growing.triangulate(balls, progress), regular_triangulation(balls, progress)));
}

TEST(Regular_3, of_tiny_balls_far_from_the_origin_is_complete) {
  EXPECT_TRUE(is_regular_triangulation({{{1e9, 1e9, 1e9}, 1e-12}}));
  EXPECT_TRUE(is_regular_triangulation({{{1e9, 1e9, 1e9}, 1e-12}, {{1e9, 1e9, 1e9 + 1e-6}, 1e-12}}));
}

/// In a cell the weights are convex; outside there is none.
testing::AssertionResult locates(const std::vector<Ball_3>& balls) {
  Progress progress;
  const Regular_3 regular = regular_triangulation(balls, progress);
  const auto count = static_cast<int>(regular.cells.size());
  Random random(balls.size());
  std::vector<Ball_3> queries = balls;
  for (int i = 0; i < 10; ++i) {
    const Point_3 p = balls[random.index(static_cast<int>(balls.size()))].center;
    const Point_3 q = balls[random.index(static_cast<int>(balls.size()))].center;
    queries.push_back({midpoint(p, q), 0});
    const double x = random.uniform(-5, 5);
    const double y = random.uniform(-5, 5);
    const double z = random.uniform(-5, 5);
    queries.push_back({p + Point_3{x, y, z}, 0});
  }
  for (const Ball_3& query : queries) {
    const auto holds = [&](int cell) {
      if (regular.is_infinite(cell)) return false;
      for (int place = 0; place < 4; ++place) {
        std::array<Ball_3, 4> corners;
        for (int k = 0; k < 4; ++k) corners[k] = balls[regular.cells[cell][k]];
        corners[place] = query;
        if (orientation(corners[0], corners[1], corners[2], corners[3]) < 0) return false;
      }
      return true;
    };
    bool is_in_hull = false;
    for (int cell = 0; cell < count; ++cell) is_in_hull = is_in_hull || holds(cell);
    if (count == 0) continue;
    for (const int start : {0, random.index(count), random.index(count)}) {
      const int found = locate(regular, query.center, start);
      if (is_in_hull ? found < 0 || !holds(found) : found != -1)
        return failure() << "located in " << found << ": " << to_text({query});
    }
  }
  return testing::AssertionSuccess();
}

/// Stops when it hears of the middle of a stage; says which one that was.
std::string stage_stopped_midway(const std::vector<Ball_3>& balls, std::string_view wanted) {
  std::stop_source stop;
  std::string stopped_at;
  Progress progress(stop.get_token(), [&](std::string_view stage, double fraction) {
    constexpr double early = 0.3;
    constexpr double late = 0.7;
    if (stage != wanted || fraction < early || fraction > late) return;
    stopped_at = stage;
    stop.request_stop();
  });
  try {
    const auto regular = std::make_shared<const Regular_3>(regular_triangulation(balls, progress));
    const auto dual = std::make_shared<const Dual_3>(dual_complex(regular, progress));
    union_medial_axis(union_vertices(dual, progress), progress);
  } catch (const Cancelled&) {
    return stopped_at;
  }
  return {};
}

TEST(Regular_3, and_what_is_made_of_it_stops_midway) {
  std::vector<Ball_3> balls;
  for (int i = 0; i < 8000; ++i)
    balls.push_back({{scattered(3 * i), scattered(3 * i + 1), scattered(3 * i + 2)}, 0.08 + 0.02 * scattered(-i)});
  for (const char* stage : {"regular triangulation", "Voronoi diagram of the vertices of the union"})
    EXPECT_EQ(stage_stopped_midway(balls, stage), stage);
}

TEST(Regular_3, locates_points) { expect_of_balls(repetitions(40), locates); }

}  // namespace
}  // namespace mesecina::test
