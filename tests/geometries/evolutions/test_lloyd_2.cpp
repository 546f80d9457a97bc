// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/evolutions_2/lloyd_2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../shapes.h"
#include "evolving.h"
#include "geometries/evolutions_2/evolutions.h"
#include "geometries/modules_2.h"

namespace mesecina::test {
namespace {

using testing::HasSubstr;

using Points = std::vector<Point_2>;

Ring_2 rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

/// What of a convex polygon is nearer to p than to q.
Ring_2 nearer_part(const Ring_2& polygon, const Point_2& p, const Point_2& q) {
  Ring_2 result;
  const auto lead = [&](const Point_2& x) { return squared_distance(x, q) - squared_distance(x, p); };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point_2& a = polygon[i];
    const Point_2& b = polygon[(i + 1) % polygon.size()];
    if (lead(a) >= 0) result.push_back(a);
    if ((lead(a) > 0 && lead(b) < 0) || (lead(a) < 0 && lead(b) > 0)) {
      const double t = lead(a) / (lead(a) - lead(b));
      result.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return result;
}

/// By clipping every convex piece of the domain with every bisector, and adding up triangles.
Points centroids_by_clipping(const Points& points, const std::vector<Ring_2>& pieces) {
  Points result;
  for (const Point_2& p : points) {
    double area = 0;
    double x = 0;
    double y = 0;
    for (Ring_2 piece : pieces) {
      for (const Point_2& q : points)
        if (q != p) piece = nearer_part(piece, p, q);
      for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
        const double triangle = ((piece[i].x - piece[0].x) * (piece[i + 1].y - piece[0].y) -
                                 (piece[i].y - piece[0].y) * (piece[i + 1].x - piece[0].x)) /
                                2;
        area += triangle;
        x += triangle * (piece[0].x + piece[i].x + piece[i + 1].x) / 3;
        y += triangle * (piece[0].y + piece[i].y + piece[i + 1].y) / 3;
      }
    }
    result.push_back(area > 1e-13 ? Point_2{x / area, y / area} : p);
  }
  return result;
}

void expect_same(const Points& found, const Points& expected, const std::string& what) {
  ASSERT_EQ(found.size(), expected.size()) << what;
  for (std::size_t i = 0; i < found.size(); ++i)
    ASSERT_LT(distance(found[i], expected[i]), 1e-8) << what << " point " << i << " of " << found.size();
}

/// One point and about evenly many around it, from one angle to another: the cell of the one has many sides.
Points around(const Point_2& middle, double radius, double from = 0, double to = 2 * std::numbers::pi) {
  constexpr int count = 150;
  Points points{middle};
  for (int i = 0; i < count; ++i) {
    const double angle = from + (to - from) * (i + 0.3 * std::sin(7.0 * i)) / count;
    points.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
  }
  return points;
}

std::vector<Named_points> point_sets() {
  return {{"random", uniform_points(40, 1)},
          {"one", {{0.3, 0.4}}},
          {"two", {{0.3, 0.4}, {0.8, 0.1}}},
          {"equal", {{0.3, 0.4}, {0.3, 0.4}, {0.8, 0.1}, {0.3, 0.4}}},
          {"on a line", {{0.1, 0.1}, {0.9, 0.9}, {0.5, 0.5}, {0.2, 0.2}}},
          {"grid", scaled(grid_points(4, 4), -2)},
          {"outside too", uniform_points(60, 2, 2)},
          {"around one", around({0.45, 0.55}, 0.4)},
          {"half around one", around({0.45, 0.55}, 0.4, 0.5, 3.5)},
          {"around one across the border", around({0.9, 0.2}, 0.7)},
          {"around one outside", around({1.4, 0.6}, 1.5)},
          {"around all", around({0.5, 0.5}, 5)}};
}

TEST(Lloyd_2, InABoxGivesWhatClippingGives) {
  Progress progress;
  Box box;
  box.add(Point_2{0, 0});
  box.add(Point_2{1, 1});
  for (const auto& [name, points] : point_sets())
    expect_same(cell_centroids(points, box, progress), centroids_by_clipping(points, {rectangle(0, 0, 1, 1)}), name);
}

TEST(Lloyd_2, InAnOutlineGivesWhatClippingItsPiecesGives) {
  Progress progress;
  // A frame with an island in its hole, in all orientations, and an L.
  const Ring_2 outer = rectangle(0, 0, 1, 1);
  const Ring_2 hole = rectangle(0.3, 0.3, 0.7, 0.7);
  const Ring_2 island = rectangle(0.4, 0.45, 0.6, 0.55);
  const std::vector<Ring_2> frame = {rectangle(0, 0, 1, 0.3), rectangle(0, 0.7, 1, 1), rectangle(0, 0.3, 0.3, 0.7),
                                     rectangle(0.7, 0.3, 1, 0.7), island};
  const Ring_2 corner = {{0, 0}, {1, 0}, {1, 0.2}, {0.25, 0.2}, {0.25, 1}, {0, 1}};
  const std::vector<Ring_2> corner_pieces = {rectangle(0, 0, 1, 0.2), rectangle(0, 0.2, 0.25, 1)};
  for (const auto& [name, points] : point_sets()) {
    for (int orientation = 0; orientation < 8; ++orientation) {
      Outline_2 outline{{island, hole, outer}};
      for (int i = 0; i < 3; ++i)
        if ((orientation >> i) & 1) std::ranges::reverse(outline.rings[i]);
      expect_same(cell_centroids(points, outline, progress), centroids_by_clipping(points, frame), name + " frame");
    }
    expect_same(cell_centroids(points, Outline_2{{corner}}, progress), centroids_by_clipping(points, corner_pieces),
                name + " corner");
  }
}

TEST(Lloyd_2, OnePointOfAShapeGoesToItsCentroidAndEmptyDomainsMoveNothing) {
  Progress progress;
  const Outline_2 triangle{{{{0, 0}, {3, 0}, {0, 3}}}};
  expect_same(cell_centroids(Points{{9, 9}}, triangle, progress), {{1, 1}}, "triangle");
  expect_same(cell_centroids(Points{{9, 9}}, Outline_2{}, progress), {{9, 9}}, "nothing");
  expect_same(cell_centroids(Points{{9, 9}}, Outline_2{{{{0, 0}, {1, 1}}}}, progress), {{9, 9}}, "two vertices");
  EXPECT_TRUE(cell_centroids(Points{}, triangle, progress).empty());
}

/// How uneven distances to the nearest other point are.
double unevenness(const Points& points) {
  double least = 1e300;
  double most = 0;
  for (const Point_2& p : points) {
    double nearest = 1e300;
    for (const Point_2& q : points)
      if (p != q) nearest = std::min(nearest, distance(p, q));
    least = std::min(least, nearest);
    most = std::max(most, nearest);
  }
  return most / least;
}

TEST(Lloyd_2, SpreadsPointsEvenlyInTheBoxThatTheyHadAtFirst) {
  const Points points = uniform_points(80, 7);
  const Evolved result = run_steps(make_registry_2(), Inputs().with(points_input, points), "lloyd", 150);
  EXPECT_EQ(result.result.steps_done, 150u);
  EXPECT_LT(unevenness(result[points_input]), 2);
  EXPECT_GT(unevenness(points), 5);
  const Box box = bounding_box(Inputs().with(points_input, points));
  EXPECT_EQ(result[lloyd_domain_input].lower, box.lower);
  const double lost = box.diagonal() - bounding_box(Inputs().with(points_input, result[points_input])).diagonal();
  EXPECT_LT(lost, 0.2 * box.diagonal());
  EXPECT_GT(lost, 0);
}

TEST(Lloyd_2, EndsWhereNothingMovesAndSaysWhyItCannotBegin) {
  const auto run = [](Inputs inputs) { return run_steps(make_registry_2(), std::move(inputs), "lloyd", 5000); };
  const Evolved settled = run(Inputs().with(points_input, Points{{0, 0}, {1, 1}, {3, 1}, {2, 3}}));
  EXPECT_EQ(settled.result.end_reason, "nothing changes any more");
  EXPECT_LT(settled.result.steps_done, 5000u);
  EXPECT_THAT(run({}).result.end_reason, HasSubstr("no points to move"));
  EXPECT_THAT(run(Inputs().with(points_input, Points{{1, 1}})).result.end_reason, HasSubstr("no area"));
  EXPECT_THAT(run(Inputs().with(points_input, Points{{1, 1}, {1, 5}})).result.end_reason, HasSubstr("no area"));
  const Outline_2 square{{rectangle(0, 0, 1, 1)}};
  const Evolved one = run(Inputs().with(points_input, Points{{0.1, 0.1}}).with(outline_input, square));
  EXPECT_EQ(one[points_input], Points({{0.5, 0.5}}));
  EXPECT_EQ(one.inputs.get(lloyd_domain_input), nullptr);
}

}  // namespace
}  // namespace mesecina::test
