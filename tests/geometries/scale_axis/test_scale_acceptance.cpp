// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/graph.h"
#include "geometries/modules_2.h"
#include "tests/geometries/shapes.h"

/// [B. Miklos: The Scale Axis Transform, 2010, Figure 5.5 and section 6.2] A large square with small bumps, of which
/// an angle says nothing: between the parallel sides of a bump it is as large as it can be, on the way into a corner of
/// the square it is 90 degrees.
namespace mesecina::test {
namespace {

constexpr double side = 10;     ///< half of that of the large square
constexpr double height = 2.5;  ///< of the bumps, which are 2 wide and at the middle of three sides

/// Uneven samples: no more than three on a circle. None at corners: the disk through one and its neighbours has an
/// angle of 180 degrees.
Outline_2 square_with_bumps() {
  const std::vector<Point_2> corners{{-side, -side},     {side, -side},       {side, -1},           {side + height, -1},
                                     {side + height, 1}, {side, 1},           {side, side},         {1, side},
                                     {1, side + height}, {-1, side + height}, {-1, side},           {-side, side},
                                     {-side, 1},         {-side - height, 1}, {-side - height, -1}, {-side, -1}};
  Ring_2 ring;
  Random random(11);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point_2& p = corners[i];
    const Point_2& q = corners[(i + 1) % corners.size()];
    const int parts = static_cast<int>(std::ceil(distance(p, q) / 0.12));
    for (int part = 0; part < parts; ++part) {
      const bool is_beside_corner = part == 0 || part == parts - 1;
      const double t = (part + (is_beside_corner ? 0.5 : random.uniform(0.2, 0.8))) / parts;
      ring.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return {{ring}};
}

struct Extent {
  /// How far what is kept goes into each of the bumps, from the center of the square, and into each of its corners, by
  /// the lesser coordinate.
  std::array<double, 3> bumps{};
  std::array<double, 4> corners{};
};

class Square_with_bumps : public testing::Test {
 protected:
  Square_with_bumps() {
    graph_.set_inputs(Inputs().with(outline_input, square_with_bumps()));
    set("sampling-step", 0.0);
  }
  void set(std::string_view id, Setting_value value) {
    graph_.set_settings(graph_.settings().with(id, std::move(value)));
  }
  Primitive_set kept(const std::string& id) {
    const auto outcome = graph_.layer(id, progress_);
    EXPECT_TRUE(outcome.value) << outcome.reason;
    const auto cut = graph_.registry().cut(*graph_.registry().find_layer(id), graph_.settings());
    return cut ? apply_cut(*outcome.value, *cut) : *outcome.value;
  }
  Extent extent(const std::string& id) {
    const Primitive_set set = kept(id);
    Extent result;
    for (const auto& segment : set.segments) {
      for (const int v : segment) {
        const auto [x, y, z] = set.vertices[v];
        if (std::abs(y) < 1) result.bumps[0] = std::max(result.bumps[0], x);
        if (std::abs(x) < 1) result.bumps[1] = std::max(result.bumps[1], y);
        if (std::abs(y) < 1) result.bumps[2] = std::max(result.bumps[2], -x);
        const std::size_t quadrant = (x > 0 ? 1 : 0) + (y > 0 ? 2 : 0);
        result.corners[quadrant] = std::max(result.corners[quadrant], std::min(std::abs(x), std::abs(y)));
      }
    }
    return result;
  }
  /// How far the shape goes to the right, up and to the left, and into the corners.
  Extent extent_of_shape(const std::string& id) {
    const Primitive_set set = kept(id);
    Extent result;
    for (const Arc& arc : set.arcs) {
      for (int i = 0; i < 720; ++i) {
        const double x = arc.center.x + arc.radius * std::cos(i * 3.141592653589793 / 360);
        const double y = arc.center.y + arc.radius * std::sin(i * 3.141592653589793 / 360);
        result.bumps[0] = std::max(result.bumps[0], x);
        result.bumps[1] = std::max(result.bumps[1], y);
        result.bumps[2] = std::max(result.bumps[2], -x);
        const std::size_t quadrant = (x > 0 ? 1 : 0) + (y > 0 ? 2 : 0);
        result.corners[quadrant] = std::max(result.corners[quadrant], std::min(std::abs(x), std::abs(y)));
      }
    }
    return result;
  }

  Graph graph_{make_registry_2()};
  Progress progress_;
};

TEST_F(Square_with_bumps, HasABranchIntoEverything) {
  const Extent whole = extent("medial-axis");
  for (const double reach : whole.bumps) EXPECT_GT(reach, side + height - 1);
  for (const double reach : whole.corners) EXPECT_GT(reach, side - 0.2);
  EXPECT_EQ(topology(kept("medial-axis"))->betti, (std::array<std::int64_t, 3>{1, 0, 0}));
}

TEST_F(Square_with_bumps, AngleFiltrationKeepsTheBumpsAndLosesTheSquare) {
  for (const double limit : {150.0, 170.0, 179.0}) {
    SCOPED_TRACE(limit);
    set("angle-limit", limit);
    const Extent found = extent("angle-medial-axis");
    for (const double reach : found.bumps) EXPECT_GT(reach, side + 0.5);
    for (const double reach : found.corners) EXPECT_LT(reach, 2);
    EXPECT_EQ(topology(kept("angle-medial-axis"))->betti, (std::array<std::int64_t, 3>{1, 0, 0}));
    const Extent shape = extent_of_shape("angle-medial-axis-shape");
    for (const double reach : shape.bumps) EXPECT_GT(reach, side + 1.4);
    for (const double reach : shape.corners) EXPECT_LT(reach, side - 2);
  }
}

TEST_F(Square_with_bumps, ScaleFiltrationLosesTheBumpsAndKeepsTheSquare) {
  // The last disk in a bump, at 1.5 beyond the side, is covered at 11.5 / 9; those on the diagonals are at sqrt 2.
  set("scale-limit", 1.1);
  for (const double reach : extent("scale-medial-axis").bumps) EXPECT_GT(reach, side + 0.5);
  for (const double limit : {1.3, 1.35}) {
    SCOPED_TRACE(limit);
    set("scale-limit", limit);
    const Extent found = extent("scale-medial-axis");
    for (const double reach : found.bumps) EXPECT_LT(reach, 2);
    for (const double reach : found.corners) EXPECT_GT(reach, side - 1);
    EXPECT_EQ(topology(kept("scale-medial-axis"))->betti, (std::array<std::int64_t, 3>{1, 0, 0}));
    const Extent shape = extent_of_shape("scale-medial-axis-shape");
    for (const double reach : shape.bumps) EXPECT_LT(reach, side + 0.2);
    for (const double reach : shape.corners) EXPECT_GT(reach, side - 0.5);
  }
  set("scale-limit", 1.5);
  for (const double reach : extent("scale-medial-axis").corners) EXPECT_LT(reach, 2);
}

TEST_F(Square_with_bumps, ScaleAxisLosesTheBumpsAndKeepsTheSquare) {
  set("scale", 1.02);
  for (const double reach : extent("scale-axis").bumps) EXPECT_GT(reach, side + 0.5);
  set("scale", 1.3);
  const Extent found = extent("scale-axis");
  for (const double reach : found.bumps) EXPECT_LT(reach, side - 1);
  for (const double reach : found.corners) EXPECT_GT(reach, side - 2);
  EXPECT_EQ(topology(kept("scale-axis"))->betti, (std::array<std::int64_t, 3>{1, 0, 0}));
  const Extent shape = extent_of_shape("scale-axis-shape");
  for (const double reach : shape.bumps) EXPECT_LT(reach, side + 0.7);
  for (const double reach : shape.corners) EXPECT_GT(reach, side - 1);
}

}  // namespace
}  // namespace mesecina::test
