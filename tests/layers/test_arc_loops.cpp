// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "layers/arc_loops.h"

namespace mesecina {
namespace {

Primitive_set graph(int vertices, std::initializer_list<std::pair<int, int>> edges) {
  Primitive_set set;
  for (int i = 0; i < vertices; ++i) set.vertices.push_back({1.0 * i, 0, 0});
  for (const auto& [from, to] : edges) set.arcs.push_back({{0, 5}, 10, from, to, true});
  return set;
}

/// Checks that every loop is a closed walk and no arc is walked twice; the arcs that are walked.
std::set<int> walked(const Primitive_set& set, const std::vector<bool>& drawn = {}) {
  std::set<int> result;
  const Arc_loops loops = closed_loops(set, drawn);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto loop = loops.loop(i);
    const auto start = [&](const Arc_step& s) { return s.is_backward ? set.arcs[s.arc].to : set.arcs[s.arc].from; };
    const auto end = [&](const Arc_step& s) { return s.is_backward ? set.arcs[s.arc].from : set.arcs[s.arc].to; };
    for (std::size_t k = 0; k < loop.size(); ++k) {
      EXPECT_TRUE(result.insert(loop[k].arc).second);
      EXPECT_EQ(end(loop[k]), start(loop[(k + 1) % loop.size()]));
    }
  }
  return result;
}

TEST(Arc_loops, of_small_graphs) {
  EXPECT_TRUE(walked(graph(0, {})).empty());
  EXPECT_TRUE(walked(graph(2, {{0, 1}})).empty());
  EXPECT_EQ(walked(graph(1, {{0, 0}})), (std::set{0}));
  EXPECT_EQ(walked(graph(2, {{0, 1}, {0, 1}})), (std::set{0, 1})) << "against the direction of one";
  EXPECT_EQ(walked(graph(3, {{0, 1}, {2, 1}, {2, 0}})).size(), 3U);
  EXPECT_EQ(walked(graph(3, {{0, 1}, {1, 0}, {1, 2}, {2, 1}, {1, 1}})).size(), 5U) << "touching in vertex 1";
  EXPECT_TRUE(walked(graph(2, {{0, 1}, {0, 1}, {0, 1}})).empty()) << "three ends at each vertex";
}

TEST(Arc_loops, what_hangs_on_a_loop_does_not_open_it) {
  const Primitive_set set = graph(6, {{0, 1}, {1, 0}, {1, 2}, {3, 2}, {4, 5}});
  EXPECT_EQ(walked(set), (std::set{0, 1}));
  EXPECT_EQ(closed_loops(set, {}).size(), 1U);
  EXPECT_TRUE(walked(set, {true, false, true, true, true}).empty());
  // One of three touching loops is no longer closed.
  const Primitive_set chain = graph(4, {{0, 1}, {1, 0}, {1, 2}, {2, 1}, {2, 3}, {3, 2}});
  EXPECT_EQ(walked(chain, {true, true, true, true, true, false}), (std::set{0, 1, 2, 3}));
}

TEST(Arc_loops, elements_of_other_kinds_come_before_arcs) {
  Primitive_set set = graph(2, {{0, 1}, {1, 0}, {0, 0}});
  set.points = {0, 1};
  set.segments = {{0, 1}};
  EXPECT_EQ(walked(set, {false, false, false, true, true, false}), (std::set{0, 1}));
}

TEST(Arc_loops, arcs_that_cannot_be_drawn_are_left_out) {
  Primitive_set set = graph(3, {{0, 1}, {1, 0}, {1, 1}, {0, 0}});
  set.arcs[0].radius = 0;
  set.arcs[2].center.x = std::nan("");
  set.arcs[3].radius = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(walked(set).empty());
}

TEST(Arc_loops, every_even_graph_is_walked_once) {
  std::mt19937 random(9);
  for (int round = 0; round < 200; ++round) {
    const int n = 1 + static_cast<int>(random() % 12);
    Primitive_set set = graph(n, {});
    std::size_t count = 0;
    for (int loops = static_cast<int>(random() % 6); loops >= 0; --loops) {
      const int start = static_cast<int>(random() % n);
      int at = start;
      for (int length = static_cast<int>(random() % 5); length >= 0; --length) {
        const int next = length == 0 ? start : static_cast<int>(random() % n);
        const bool turned = random() % 2 == 0;
        set.arcs.push_back({{0, 5}, 10, turned ? next : at, turned ? at : next, true});
        at = next;
        ++count;
      }
    }
    std::shuffle(set.arcs.begin(), set.arcs.end(), random);
    EXPECT_EQ(walked(set).size(), count);
  }
}

TEST(Arc_loops, planar_arcs_are_walked_in_their_direction) {
  Primitive_set set;
  set.vertices = {{1, 0, 0}, {0, 1, 0}};
  set.arcs = {{{0, 0}, 1, 0, 1, true}, {{0, 0}, 1, 0, 1, false}, {{0, 0}, 1, 0, 0, false}};
  EXPECT_NEAR(planar_arc(set, {0, false}).sweep, M_PI / 2, 1e-15);
  EXPECT_NEAR(planar_arc(set, {0, true}).sweep, -M_PI / 2, 1e-15);
  EXPECT_EQ(planar_arc(set, {0, true}).from, (Point_2{0, 1}));
  EXPECT_NEAR(planar_arc(set, {1, false}).sweep, -3 * M_PI / 2, 1e-15);
  EXPECT_EQ(planar_arc(set, {2, false}).sweep, -2 * M_PI);
}

TEST(Arc_polyline, is_close_where_it_meets_the_box_and_coarse_elsewhere) {
  const Pixel_box box{-10, -10, 10, 10};
  for (const double radius : {5.0, 300.0, 1e6, 1e12}) {
    const Pixel_arc arc = whole_circle({0, radius - 3}, radius);
    std::vector<Point_2> points{arc.from};
    append_polyline(arc, box, 0.01, points);
    EXPECT_EQ(points.back(), arc.to);
    EXPECT_LT(points.size(), 500U) << radius;
    for (double x = -4; x <= 4; x += 0.5) {
      // The height at which the lower half circle passes x, and that of the polyline.
      const double expected = radius - 3 - std::sqrt(radius * radius - x * x);
      double nearest = 1e9;
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point_2& p = points[i];
        const Point_2& q = points[i + 1];
        if (std::min(p.x, q.x) > x || std::max(p.x, q.x) < x || p.x == q.x) continue;
        nearest = std::min(nearest, std::abs(p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x) - expected));
      }
      EXPECT_LT(nearest, 0.012 + radius * 1e-15) << radius << " at " << x;
    }
  }
}

}  // namespace
}  // namespace mesecina
