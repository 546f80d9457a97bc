// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "geometries/delaunay_2/delaunay_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

using Points = std::vector<Point_2>;

Delaunay_2 triangulate(const Points& points) {
  Progress progress;
  return delaunay(points, progress);
}

/// A triangulation that follows its points, checked after each step.
class Follower {
 public:
  explicit Follower(Points points) : points_(std::move(points)), triangulation_(triangulate(points_)) {}

  bool change(Points points) {
    Progress progress;
    points_ = std::move(points);
    return update(triangulation_, points_, progress);
  }
  const Points& points() const { return points_; }
  const Delaunay_2& triangulation() const { return triangulation_; }
  testing::AssertionResult is_right() const { return is_delaunay(triangulation_, points_); }
  bool has_triangles_of_a_fresh_one() const {
    return normalized(triangulation_.triangles) == normalized(triangulate(points_).triangles);
  }

 private:
  Points points_;
  Delaunay_2 triangulation_;
};

struct Change {
  std::string name;
  std::function<void(Points&, Random&)> apply;
};

Point_2 somewhere(Random& random) {
  const double x = random.uniform(-1.5, 1.5);
  return {x, random.uniform(-1.5, 1.5)};
}

int any(const Points& points, Random& random) { return random.index(static_cast<int>(points.size())); }

/// Changes that need at least two points.
std::vector<Change> changes() {
  return {
      {"small move",
       [](Points& points, Random& random) {
         Point_2& p = points[any(points, random)];
         p = {p.x + random.uniform(-0.01, 0.01), p.y + random.uniform(-0.01, 0.01)};
       }},
      {"large move", [](Points& points, Random& random) { points[any(points, random)] = somewhere(random); }},
      {"move out of the hull",
       [](Points& points, Random& random) {
         Point_2& p = points[any(points, random)];
         p = {3 * p.x + 1, 3 * p.y - 1};
       }},
      {"onto another",
       [](Points& points, Random& random) {
         const int target = any(points, random);
         points[any(points, random)] = points[target];
       }},
      {"site leaves its duplicates",
       [](Points& points, Random& random) {
         const int i = any(points, random);
         points[any(points, random)] = points[i];
         points[i] = somewhere(random);
       }},
      {"several moves",
       [](Points& points, Random& random) {
         for (int i = 0; i < 5; ++i) points[any(points, random)] = somewhere(random);
       }},
      {"swap",
       [](Points& points, Random& random) {
         const int i = any(points, random);
         std::swap(points[i], points[any(points, random)]);
       }},
      {"append",
       [](Points& points, Random& random) {
         for (int i = random.index(3); i >= 0; --i) points.push_back(somewhere(random));
       }},
      {"insert",
       [](Points& points, Random& random) {
         const Point_2 p = somewhere(random);
         points.insert(points.begin() + any(points, random), p);
       }},
      {"insert a duplicate in front",
       [](Points& points, Random& random) {
         const Point_2 p = points[any(points, random)];
         points.insert(points.begin(), p);
       }},
      {"erase",
       [](Points& points, Random& random) {
         if (points.size() > 2) points.erase(points.begin() + any(points, random));
       }},
      {"erase a run",
       [](Points& points, Random& random) {
         if (points.size() < 12) return;
         const int first = random.index(static_cast<int>(points.size()) - 8);
         points.erase(points.begin() + first, points.begin() + first + 1 + random.index(6));
       }},
      {"insert and erase at once",
       [](Points& points, Random& random) {
         points.erase(points.begin() + any(points, random));
         points.insert(points.begin() + random.index(static_cast<int>(points.size()) + 1), somewhere(random));
       }},
      {"nothing", [](Points&, Random&) {}},
  };
}

void follow_random_changes(const Points& start, int steps, std::uint64_t seed, bool in_general_position) {
  Random random(seed);
  Follower follower(start);
  const std::vector<Change> all = changes();
  for (int step = 0; step < steps; ++step) {
    Points points = follower.points();
    const Change& change = all[random.index(static_cast<int>(all.size()))];
    if (points.size() < 2) points.resize(2);
    change.apply(points, random);
    follower.change(points);
    ASSERT_TRUE(follower.is_right()) << "seed " << seed << ", step " << step << ", " << change.name;
    if (in_general_position) {
      ASSERT_TRUE(follower.has_triangles_of_a_fresh_one())
          << "seed " << seed << ", step " << step << ", " << change.name;
    }
  }
}

TEST(Delaunay_update_2, follows_random_changes) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) follow_random_changes(uniform_points(120, seed), 120, seed, true);
}

TEST(Delaunay_update_2, follows_random_changes_of_few_points) {
  for (std::uint64_t seed = 100; seed < 140; ++seed)
    follow_random_changes(uniform_points(static_cast<int>(seed % 7), seed), 60, seed, true);
}

TEST(Delaunay_update_2, follows_random_changes_of_degenerate_points) {
  for (std::uint64_t seed = 200; seed < 203; ++seed) {
    follow_random_changes(with_duplicates(grid_points(9, 9), 30, seed), 60, seed, false);
    follow_random_changes(collinear_points(40, seed), 40, seed, false);
    follow_random_changes(Points(20, Point_2{0.5, 0.5}), 40, seed, false);
  }
  follow_random_changes(cocircular_points(), 25, 205, false);
}

TEST(Delaunay_update_2, follows_moves_on_a_small_integer_grid) {
  // Duplicates, collinear and cocircular points appear and disappear all the time.
  for (std::uint64_t seed = 300; seed < 340; ++seed) {
    Random random(seed);
    const auto lattice_point = [&] {
      const double x = random.index(4);
      return Point_2{x, static_cast<double>(random.index(3))};
    };
    Follower follower({});
    for (int step = 0; step < 80; ++step) {
      Points points = follower.points();
      const int kind = random.index(5);
      if (kind <= 1 && points.size() < 12) {
        points.insert(points.begin() + random.index(static_cast<int>(points.size()) + 1), lattice_point());
      } else if (kind == 2 && !points.empty()) {
        points.erase(points.begin() + any(points, random));
      } else if (!points.empty()) {
        points[any(points, random)] = lattice_point();
      }
      follower.change(points);
      ASSERT_TRUE(follower.is_right()) << "seed " << seed << ", step " << step;
    }
  }
}

TEST(Delaunay_update_2, goes_to_a_line_and_back) {
  const Points plane = uniform_points(30, 51);
  Points line;
  for (const Point_2& p : plane) line.push_back({p.x, 1});
  Follower follower(plane);
  for (int round = 0; round < 2; ++round) {
    // One point after another, the last one takes the triangulation to the line.
    Points points = plane;
    for (std::size_t i = 0; i < plane.size(); ++i) {
      points[i] = line[i];
      follower.change(points);
      ASSERT_TRUE(follower.is_right()) << i;
    }
    EXPECT_EQ(follower.triangulation().dimension, 1);
    for (std::size_t i = 0; i < plane.size(); ++i) {
      points[i] = plane[i];
      follower.change(points);
      ASSERT_TRUE(follower.is_right()) << i;
      ASSERT_TRUE(follower.has_triangles_of_a_fresh_one()) << i;
    }
  }
}

TEST(Delaunay_update_2, goes_to_nothing_and_back) {
  const Points all = uniform_points(12, 52);
  Follower follower(all);
  Points points = all;
  while (!points.empty()) {
    points.pop_back();
    follower.change(points);
    ASSERT_TRUE(follower.is_right()) << points.size();
  }
  EXPECT_EQ(follower.triangulation().dimension, -1);
  for (const Point_2& p : all) {
    points.push_back(p);
    follower.change(points);
    ASSERT_TRUE(follower.is_right()) << points.size();
  }
  follower.change({});
  ASSERT_TRUE(follower.is_right());
  follower.change(all);
  ASSERT_TRUE(follower.is_right());
  EXPECT_TRUE(follower.has_triangles_of_a_fresh_one());
}

TEST(Delaunay_update_2, everything_changes) {
  Follower follower(uniform_points(300, 53));
  for (const auto& [name, points] : difficult_point_sets()) {
    follower.change(points);
    ASSERT_TRUE(follower.is_right()) << name;
  }
}

TEST(Delaunay_update_2, last_point_of_few_hundred_duplicates_decides_the_site) {
  Points points = uniform_points(50, 54);
  const Point_2 place{0.25, 0.75};
  points.insert(points.begin() + 10, 300, place);
  Follower follower(points);
  for (int i = 10; i < 40; ++i) {
    points[i].x += 1 + i;
    follower.change(points);
    ASSERT_TRUE(follower.is_right()) << i;
    EXPECT_EQ(follower.triangulation().site[309], i + 1);
  }
}

TEST(Delaunay_update_2, single_edits_of_many_points_are_local) {
  Points points = uniform_points(10000, 55);
  Random random(56);
  Follower follower(points);
  for (int step = 0; step < 20; ++step) {
    points[any(points, random)] = {random.uniform(-1, 1), random.uniform(-1, 1)};
    EXPECT_TRUE(follower.change(points)) << "move, step " << step;
  }
  points.push_back({0.123, 0.456});
  EXPECT_TRUE(follower.change(points)) << "append";
  points.insert(points.begin() + 5000, Point_2{-0.123, 0.456});
  EXPECT_TRUE(follower.change(points)) << "insert";
  points.erase(points.begin() + 3000);
  EXPECT_TRUE(follower.change(points)) << "erase";
  EXPECT_TRUE(follower.change(points)) << "nothing";
  EXPECT_TRUE(follower.is_right());
  EXPECT_TRUE(follower.has_triangles_of_a_fresh_one());
}

TEST(Delaunay_update_2, removing_a_site_with_most_others_around_it_starts_afresh) {
  Points points = ellipse(1, 1, 3000);
  points.push_back({0, 0});
  Follower follower(points);
  points.back() = {0.001, 0};
  EXPECT_FALSE(follower.change(points));
  EXPECT_TRUE(follower.is_right());
  points.front() = {1.001, 0};
  EXPECT_TRUE(follower.change(points));
  EXPECT_TRUE(follower.is_right());
}

TEST(Delaunay_update_2, survives_being_moved) {
  Points points = uniform_points(100, 57);
  Progress progress;
  Delaunay_2 first = triangulate(points);
  Delaunay_2 second = std::move(first);
  points[3] = {0.5, 0.5};
  update(second, points, progress);
  EXPECT_TRUE(is_delaunay(second, points));
  first = std::move(second);
  points[4] = {0.25, 0.5};
  update(first, points, progress);
  EXPECT_TRUE(is_delaunay(first, points));
}

TEST(Delaunay_update_2, cancelled_one_may_be_assigned_to) {
  const Points points = uniform_points(5000, 58);
  const Points others = uniform_points(5000, 59);
  Delaunay_2 d = triangulate(points);
  std::stop_source source;
  source.request_stop();
  Progress progress(source.get_token());
  EXPECT_THROW(update(d, others, progress), Cancelled);
  d = triangulate(points);
  EXPECT_TRUE(is_delaunay(d, points));
}

}  // namespace
}  // namespace mesecina::test
