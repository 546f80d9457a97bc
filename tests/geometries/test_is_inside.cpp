// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "geometries/labels_2/labels_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/shapes.h"
#include "tests/growth.h"

namespace mesecina::test {
namespace {

/// Queries on the boundary are left out: they may count to either side.
void expect_exact(const Outline_2& outline, std::vector<Point_2> queries) {
  std::erase_if(queries, [&](const Point_2& query) { return is_on_boundary(outline, query); });
  for (const int threads : {1, 2}) {
    Progress progress({}, {}, threads);
    const std::vector<std::uint8_t> answers = is_inside(outline, queries, progress);
    ASSERT_EQ(answers.size(), queries.size());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ASSERT_EQ(answers[i] != 0, exact_is_inside(outline, queries[i]))
          << "query " << queries[i].x << " " << queries[i].y << ", threads " << threads;
    }
  }
}

/// Random points of the box, and points at heights and positions of vertices.
std::vector<Point_2> queries_around(const Outline_2& outline, int count, std::uint64_t seed) {
  Box box;
  const std::vector<Point_2> vertices = vertices_of(outline);
  for (const Point_2& p : vertices) box.add(p);
  Random random(seed);
  const double margin = 0.1 * box.diagonal() + 1e-300;
  std::vector<Point_2> result;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(box.lower.x - margin, box.upper.x + margin);
    const double y = random.uniform(box.lower.y - margin, box.upper.y + margin);
    const Point_2& v = vertices[random.index(static_cast<int>(vertices.size()))];
    const Point_2& w = vertices[random.index(static_cast<int>(vertices.size()))];
    result.push_back({x, y});
    result.push_back({x, v.y});
    result.push_back({v.x, y});
    result.push_back({v.x, w.y});
    result.push_back({std::nextafter(v.x, x), v.y});
    result.push_back({v.x, std::nextafter(v.y, y)});
    const Point_2 middle = midpoint(v, w);
    result.push_back({middle.x, std::nextafter(middle.y, y)});
  }
  return result;
}

TEST(Is_inside, simple_shapes) {
  Progress progress;
  const Outline_2 square{{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}}};
  const std::vector<Point_2> queries{{1, 1}, {3, 1}, {-1, 1}, {1, 3}, {1, -1}, {-1, 0}, {3, 2}, {-1, 2}};
  EXPECT_EQ(is_inside(square, queries, progress), (std::vector<std::uint8_t>{1, 0, 0, 0, 0, 0, 0, 0}));
  EXPECT_EQ(is_inside({}, queries, progress), std::vector<std::uint8_t>(queries.size(), 0));
  EXPECT_TRUE(is_inside(square, {}, progress).empty());
}

TEST(Is_inside, hole_and_island) {
  Progress progress;
  const auto square = [](double half) { return Ring_2{{-half, -half}, {half, -half}, {half, half}, {-half, half}}; };
  const Outline_2 nested{{square(4), square(3), square(2), square(1)}};
  const std::vector<Point_2> queries{{0, 0}, {1.5, 0}, {2.5, 0}, {3.5, 0}, {4.5, 0}, {0, 3.5}, {0, 2.5}};
  EXPECT_EQ(is_inside(nested, queries, progress), (std::vector<std::uint8_t>{0, 1, 0, 1, 0, 1, 0}));
}

TEST(Is_inside, vertices_and_horizontal_edges_at_the_height_of_the_query) {
  const Outline_2 stairs{
      {{{0, 0}, {6, 0}, {6, 1}, {5, 1}, {5, 2}, {4, 2}, {4, 1}, {3, 1}, {3, 3}, {2, 1}, {1, 3}, {0, 1}}}};
  std::vector<Point_2> queries;
  for (int x = -4; x <= 28; ++x)
    for (int y = -4; y <= 16; ++y) queries.push_back({x / 4.0, y / 4.0});
  expect_exact(stairs, queries);
}

TEST(Is_inside, degenerate_rings) {
  const std::vector<Point_2> queries = uniform_points(300, 1, 3);
  expect_exact({{{}}}, queries);
  expect_exact({{{{1, 1}}}}, queries);
  expect_exact({{{{1, 1}, {-1, 0}}}}, queries);
  expect_exact({{{{1, 1}, {1, 1}, {1, 1}}}}, queries);
  expect_exact({{{{-2, 0}, {0, 0}, {2, 0}}}}, queries);
  expect_exact({{{{-2, 0}, {2, 0}, {2, 0}, {2, 2}, {2, -2}, {2, 2}, {-2, 2}}}}, queries);
  // The same ring twice covers nothing.
  const Ring_2 triangle{{-2, -2}, {2, -2}, {0, 2}};
  expect_exact({{triangle, triangle}}, queries);
  // Self-crossing star.
  Ring_2 star;
  for (int i = 0; i < 5; ++i) star.push_back({2 * std::cos(i * 2.513274), 2 * std::sin(i * 2.513274)});
  expect_exact({{star}}, queries);
}

TEST(Is_inside, random_rings) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    Outline_2 outline;
    for (int ring = random.index(4); ring >= 0; --ring) {
      Ring_2 vertices(random.index(12));
      for (Point_2& p : vertices) {
        const double x = random.index(9);
        p = seed % 2 ? Point_2{x, static_cast<double>(random.index(7))} : Point_2{random.unit(), random.unit()};
      }
      outline.rings.push_back(vertices);
    }
    if (vertices_of(outline).empty()) continue;
    SCOPED_TRACE(seed);
    expect_exact(outline, queries_around(outline, 40, seed));
  }
}

TEST(Is_inside, extreme_scales) {
  for (const int exponent : {-500, -100, 100, 500}) {
    SCOPED_TRACE(exponent);
    const Outline_2 outline{{scaled(flower(60), exponent), scaled(ellipse(0.3, 0.2, 20), exponent)}};
    expect_exact(outline, queries_around(outline, 60, 7));
  }
}

TEST(Is_inside, nearly_on_long_edges) {
  const Outline_2 sliver{{{{0, 0}, {1e6, 3.3e5}, {1e6, 3.3e5 + 1e-3}, {0, 1e-9}}}};
  Random random(8);
  std::vector<Point_2> queries;
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(0, 1e6);
    queries.push_back({x, std::nextafter(x * 0.33, random.chance(0.5) ? 1e9 : -1e9)});
  }
  expect_exact(sliver, queries);
}

TEST(Is_inside, real_outlines) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("wkt")) {
    const Outline_2 outline = outline_of(file);
    const std::size_t size = vertices_of(outline).size();
    if (size > 10000) continue;
    SCOPED_TRACE(file.filename());
    expect_exact(outline, queries_around(outline, size < 2000 ? 40 : 10, 9));
  }
}

TEST(Is_inside, large_outline_takes_little_time) {
  constexpr int size = 200000;
  const Outline_2 outline{{flower(size)}};
  const Outline_2 smaller{{flower(size / 10)}};
  const std::vector<Point_2> queries = uniform_points(size, 10, 1.4);
  const std::vector<Point_2> fewer = uniform_points(size / 10, 10, 1.4);
  Progress progress;
  const std::vector<std::uint8_t> answers = is_inside(outline, queries, progress);
  // Every edge against every query would take 100 times as long.
  EXPECT_LT(growth([&] { is_inside(smaller, fewer, progress); }, [&] { is_inside(outline, queries, progress); }, 20),
            35);
  int differing = 0;
  for (int i = 0; i < size; ++i) {
    const Point_2& q = queries[i];
    const double gap = std::hypot(q.x, q.y) - 1 - 0.3 * std::cos(5 * std::atan2(q.y, q.x));
    if (std::abs(gap) > 1e-6 && (answers[i] != 0) != (gap < 0)) ++differing;
  }
  EXPECT_EQ(differing, 0);
}

/// Long teeth side by side: nearly every edge passes every height. `shear` leans them over.
Outline_2 comb(int teeth, double shear, bool lies_down) {
  Ring_2 ring;
  const auto add = [&](double x, double y) {
    x += shear * y;
    ring.push_back(lies_down ? Point_2{y, x} : Point_2{x, y});
  };
  for (int i = 0; i < teeth; ++i) {
    add(i, 0);
    add(i + 0.5, teeth);
  }
  add(teeth, 0);
  add(teeth, -1);
  add(0, -1);
  return {{ring}};
}

TEST(Is_inside, combs) {
  for (const bool lies_down : {false, true}) {
    for (const double shear : {0.0, 0.3, 1.0}) {
      SCOPED_TRACE(testing::Message() << "shear " << shear << ", lies down: " << lies_down);
      const Outline_2 outline = comb(100, shear, lies_down);
      expect_exact(outline, queries_around(outline, 60, 11));
    }
  }
}

TEST(Is_inside, large_combs_take_little_time_and_memory) {
  constexpr int teeth = 50000;
  for (const bool lies_down : {false, true}) {
    const Outline_2 outline = comb(teeth, 0, lies_down);
    std::vector<Point_2> queries;
    std::vector<std::uint8_t> expected;
    Random random(12);
    for (int i = 0; i < 2 * teeth; ++i) {
      const int tooth = random.index(teeth);
      const double height = random.unit();
      // Half the width of a tooth is (1 - height) / 2; between two teeth it is empty.
      const double place = random.uniform(-0.5, 0.5);
      const double gap = std::abs(place) - (1 - height) / 2;
      if (std::abs(gap) < 1e-6) continue;
      const double x = tooth + 0.5 + place;
      queries.push_back(lies_down ? Point_2{height * teeth, x} : Point_2{x, height * teeth});
      expected.push_back(gap < 0 ? 1 : 0);
    }
    ASSERT_GT(queries.size(), 1.9 * teeth);
    Progress progress;
    const std::vector<std::uint8_t> answers = is_inside(outline, queries, progress);
    // A list of edges for each of as many strips would hold 10^10 entries: 100 times as many as with a tenth.
    const Outline_2 smaller = comb(teeth / 10, 0, lies_down);
    std::vector<Point_2> fewer(queries.begin(), queries.begin() + static_cast<std::ptrdiff_t>(queries.size() / 10));
    for (Point_2& query : fewer) query = {query.x / 10, query.y / 10};
    EXPECT_LT(growth([&] { is_inside(smaller, fewer, progress); }, [&] { is_inside(outline, queries, progress); }, 20),
              35);
    EXPECT_EQ(answers, expected);
  }
}

}  // namespace
}  // namespace mesecina::test
