// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing, subdivision and noise of points on curves, and of outlines.
#include "geometries/evolutions_2/curves_2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../shapes.h"
#include "evolving.h"
#include "geometries/evolution_settings.h"
#include "geometries/modules_2.h"

namespace mesecina::test {
namespace {

using testing::HasSubstr;

using Points = std::vector<Point_2>;

Inputs with_points(Points points) { return Inputs().with(points_input, std::move(points)); }
Inputs with_ring(Ring_2 ring) { return Inputs().with(outline_input, Outline_2{{std::move(ring)}}); }

/// Turned a little, so that no two points have the same coordinate.
Points circle(int count, double radius = 2) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * i / count + 0.1;
    points.push_back({radius * std::cos(t), radius * std::sin(t)});
  }
  return points;
}

double norm(const Point_2& p) { return std::hypot(p.x, p.y); }

void expect_radius(const Points& points, double radius, double tolerance) {
  for (const Point_2& p : points) ASSERT_NEAR(norm(p), radius, tolerance);
}

TEST(Laplacian_smoothing_2, ACircleShrinksByItsCosine) {
  constexpr int count = 40;
  constexpr int steps = 7;
  for (const double factor : {0.5, 0.2, 1.0}) {
    const double per_step = 1 - factor * (1 - std::cos(2 * std::numbers::pi / count));
    const double radius = 2 * std::pow(per_step, steps);
    const Settings settings = Settings().with("smoothing-factor", factor);
    const Evolved points = evolved_2(with_points(circle(count)), "laplacian-smoothing", steps, settings);
    EXPECT_EQ(points.result.steps_done, 7u);
    expect_radius(points[points_input], radius, 1e-12);
    const Evolved ring = evolved_2(with_ring(circle(count)), "laplacian-smoothing", steps, settings);
    expect_radius(ring[outline_input].rings[0], radius, 1e-12);
  }
}

TEST(Laplacian_smoothing_2, WithKeptSizeACircleStaysAndZigzagGoes) {
  constexpr int count = 200;
  Points jagged = circle(count);
  for (int i = 0; i < count; i += 2) jagged[i] = {jagged[i].x * 1.02, jagged[i].y * 1.02};
  const Settings keeps = Settings().with("smoothing-keeps-size", true);
  for (const double factor : {0.3, 0.5, 0.69, 1.0}) {
    const Evolved result =
        evolved_2(with_ring(jagged), "laplacian-smoothing", 100, keeps.with("smoothing-factor", factor));
    expect_radius(result[outline_input].rings[0], 2.02, 0.01);
    const auto& ring = result[outline_input].rings[0];
    for (int i = 0; i < count; ++i) EXPECT_NEAR(norm(ring[i]), norm(ring[(i + 1) % count]), 2e-3);
  }
  const Evolved shrunk = evolved_2(with_ring(jagged), "laplacian-smoothing", 2000);
  EXPECT_LT(norm(shrunk[outline_input].rings[0][0]), 1.5);
  const Evolved kept = evolved_2(with_ring(jagged), "laplacian-smoothing", 2000, keeps);
  EXPECT_NEAR(norm(kept[outline_input].rings[0][0]), 2, 0.2);
}

TEST(Laplacian_smoothing_2, NoWaveEverGrows) {
  for (const double factor : {0.1, 0.5, 0.69, 0.8, 1.0})
    for (const bool keeps : {false, true}) {
      // A wave of frequency k is multiplied by the product of 1 - factor k, for k between 0 and 2.
      for (double k = 0; k <= 2; k += 0.01) {
        double gain = 1;
        for (const double pass : smoothing_passes(factor, keeps)) gain *= 1 - pass * k;
        EXPECT_LE(std::abs(gain), 1.003) << factor << keeps << k;
        if (keeps && k > 0.001 && k < 0.09) {
          EXPECT_GE(gain, 1);
        }
      }
    }
}

TEST(Laplacian_smoothing_2, PointsWithoutTwoNeighboursStay) {
  Points arc = spiral_arc(60);
  arc.push_back({100, 100});
  const Evolved result = evolved_2(with_points(arc), "laplacian-smoothing", 3);
  const Points& smooth = result[points_input];
  ASSERT_EQ(smooth.size(), arc.size());
  EXPECT_EQ(smooth.back(), arc.back());
  EXPECT_NE(smooth[30], arc[30]);
  const Evolved line = evolved_2(with_points({{0, 0}, {1, 0}, {3, 0}, {4, 0}}), "laplacian-smoothing", 1);
  EXPECT_THAT(line[points_input],
              testing::ElementsAre(Point_2{0, 0}, Point_2{1.25, 0}, Point_2{2.75, 0}, Point_2{4, 0}));
}

TEST(Laplacian_smoothing_2, EqualPointsStayTogetherAndPointsBesideAnOutlineFollowTheirOwnCurve) {
  Points points = circle(30);
  points.push_back(points[7]);
  points.push_back(points[7]);
  const Evolved twice = evolved_2(with_points(points), "laplacian-smoothing", 4);
  EXPECT_EQ(twice[points_input][30], twice[points_input][7]);
  EXPECT_EQ(twice[points_input][31], twice[points_input][7]);
  EXPECT_NE(twice[points_input][7], points[7]);
  const Inputs both = with_points(circle(30)).with(outline_input, Outline_2{{circle(35, 2.1)}});
  EXPECT_EQ(evolved_2(both, "laplacian-smoothing", 4)[points_input],
            evolved_2(with_points(circle(30)), "laplacian-smoothing", 4)[points_input]);
}

TEST(Curve_evolutions_2, SayWhyThereIsNothingToChange) {
  for (const char* id : {"laplacian-smoothing", "subdivision", "noise"}) {
    EXPECT_THAT(evolved_2({}, id, 3).result.end_reason, HasSubstr("there is no curve")) << id;
    for (const Points& points : {Points{{1, 2}}, Points{{1, 2}, {1, 2}}, Points{{1, 2}, {3, 4}}}) {
      const Evolved result = evolved_2(with_points(points), id, 3);
      EXPECT_EQ(result.result.steps_done, 0u) << id;
      EXPECT_THAT(result.result.end_reason, HasSubstr("two neighbours")) << id;
      EXPECT_EQ(result[points_input], points) << id;
    }
    EXPECT_NE(evolved_2(with_ring({{0, 0}, {1, 0}}), id, 1).result.end_reason, "") << id;
  }
  EXPECT_EQ(evolved_2(with_points(circle(20)), "laplacian-smoothing", 3, Settings().with("smoothing-factor", 0.0))
                .result.end_reason,
            "nothing changes any more");
  EXPECT_EQ(evolved_2(with_points(circle(20)), "noise", 3, Settings().with("noise-amplitude", 0.0)).result.end_reason,
            "nothing changes any more");
}

/// The point where the cubic B-spline of a ring is at its vertex i: its control points are the ring's.
Point_2 spline_at(const Ring_2& ring, std::size_t i) {
  const std::size_t n = ring.size();
  const Point_2& a = ring[(i + n - 1) % n];
  const Point_2& b = ring[i];
  const Point_2& c = ring[(i + 1) % n];
  return {(a.x + 4 * b.x + c.x) / 6, (a.y + 4 * b.y + c.y) / 6};
}

TEST(Subdivision_2, ARingTendsToItsBSpline) {
  const Ring_2 ring = {{0, 0}, {4, 1}, {5, 5}, {2, 3}, {-1, 6}};
  constexpr int steps = 12;
  const Evolved fine = evolved_2(with_ring(ring), "subdivision", steps);
  const Ring_2& curve = fine[outline_input].rings[0];
  ASSERT_EQ(curve.size(), ring.size() << steps);
  for (std::size_t i = 0; i < ring.size(); ++i) EXPECT_LT(distance(curve[i << steps], spline_at(ring, i)), 1e-6);
  // Between vertices 1 and 2, half of the way.
  const Point_2 middle{(ring[0].x + 23 * ring[1].x + 23 * ring[2].x + ring[3].x) / 48,
                       (ring[0].y + 23 * ring[1].y + 23 * ring[2].y + ring[3].y) / 48};
  EXPECT_LT(distance(curve[(std::size_t{1} << steps) + (std::size_t{1} << (steps - 1))], middle), 1e-6);
}

TEST(Subdivision_2, OfPointsIsThatOfTheirRing) {
  const Points ring = circle(24);
  const Evolved points = evolved_2(with_points(shuffled(ring, 3)), "subdivision", 3);
  const Evolved outline = evolved_2(with_ring(ring), "subdivision", 3);
  Points a = points[points_input];
  Points b = outline[outline_input].rings[0];
  ASSERT_EQ(a.size(), 24u * 8);
  const auto by_angle = [](const Point_2& p, const Point_2& q) { return std::atan2(p.y, p.x) < std::atan2(q.y, q.x); };
  std::ranges::sort(a, by_angle);
  std::ranges::sort(b, by_angle);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_LT(distance(a[i], b[i]), 1e-12);
}

TEST(Subdivision_2, EndsBeforeItTakesAllMemory) {
  const Evolved result = evolved_2(with_ring(circle(1000)), "subdivision", 40);
  EXPECT_EQ(result.result.steps_done, 13u);
  EXPECT_THAT(result.result.end_reason, HasSubstr("10 million"));
}

TEST(Noise_2, IsTheSameForTheSameSeedAndStepByStep) {
  const Inputs inputs = with_points(circle(50))
                            .with(outline_input, Outline_2{{circle(30, 5), circle(20, 9)}})
                            .with(disks_input, std::vector<Disk_2>{{{0, 0}, 1}, {{3, 3}, 2}});
  const Settings seed = Settings().with("evolution-seed", std::int64_t{5});
  const Evolved once = evolved_2(inputs, "noise", 4, seed);
  const Evolved again = evolved_2(inputs, "noise", 4, seed);
  EXPECT_EQ(once[points_input], again[points_input]);
  EXPECT_EQ(once[outline_input], again[outline_input]);
  EXPECT_EQ(once[disks_input], again[disks_input]);
  const Evolved other = evolved_2(inputs, "noise", 4, seed.with("evolution-seed", std::int64_t{6}));
  EXPECT_NE(once[points_input], other[points_input]);
  // Another step draws other numbers.
  Graph graph(make_registry_2());
  graph.set_inputs(inputs);
  Progress progress;
  const auto first = graph.evolve("noise", 1, progress);
  const auto second = graph.evolve("noise", 2, progress);
  EXPECT_NE(*first.value->inputs.get(points_input), *second.value->inputs.get(points_input));
}

TEST(Noise_2, NumbersAreThoseOfEveryMachine) {
  const Evolved result = evolved_2(with_ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), "noise", 1);
  const Ring_2& ring = result[outline_input].rings[0];
  // The first numbers of the 64-bit Mersenne twister with seed 1, in [0, 1).
  constexpr double first = 0.13387664401253263;
  constexpr double second = 0.13640703636619722;
  // The neighbours of a vertex are those beside it; what is between them is (1, -1), then (1, 1).
  EXPECT_NEAR(ring[0].x, 0.1 * (2 * first - 1), 1e-16);
  EXPECT_NEAR(ring[0].y, 0.1 * (2 * first - 1), 1e-16);
  EXPECT_NEAR(ring[1].x, 1 - 0.1 * (2 * second - 1), 1e-15);
  EXPECT_NEAR(ring[1].y, 0.1 * (2 * second - 1), 1e-15);
}

TEST(Noise_2, StaysWithinItsAmplitudeAndAlongNormals) {
  const Points before = circle(100);
  const Evolved result = evolved_2(with_points(before), "noise", 1, Settings().with("noise-amplitude", 0.25));
  const Points& after = result[points_input];
  const double reach = 0.25 * distance(before[99], before[1]);
  double farthest = 0;
  for (int i = 0; i < 100; ++i) {
    const double moved = distance(before[i], after[i]);
    EXPECT_LE(moved, reach * (1 + 1e-12));
    farthest = std::max(farthest, moved);
    EXPECT_NEAR(std::atan2(after[i].y, after[i].x), std::atan2(before[i].y, before[i].x), 1e-12);
  }
  EXPECT_GT(farthest, 0.9 * reach);
  const std::vector<Disk_2> disks = {{{0, 0}, 1}, {{3, 3}, 0}};
  const Evolved moved = evolved_2(with_points({{8, 8}}).with(disks_input, disks), "noise", 1);
  EXPECT_LE(norm(moved[disks_input][0].center), 0.1 * std::numbers::sqrt2);
  EXPECT_GT(norm(moved[disks_input][0].center), 0);
  EXPECT_EQ(moved[disks_input][0].radius, 1);
  EXPECT_EQ(moved[disks_input][1], disks[1]);
  EXPECT_EQ(moved[points_input], Points({{8, 8}}));
}

}  // namespace
}  // namespace mesecina::test
