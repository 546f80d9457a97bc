// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tests/geometries/scale_axis/scale_stages.h"
#include "tests/geometries/union/disk_sets.h"

/// [B. Miklos: The Scale Axis Transform, 2010, Lemma 24, Definition 8, Corollary 33, section 6.3.2]
namespace mesecina::test {
namespace {

/// The multiplicative distance to disks: the least factor by which one of them has to grow to reach the point.
double multiplicative_distance(const Balls_2& disks, const Point_2& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < disks.size(); ++b)
    least = std::min(least, distance(point, disks.centers[b]) / disks.radii[b]);
  return least;
}

double cross(const Point_2& p, const Point_2& q, const Point_2& r) {
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

bool is_in_triangle(const Point_2& point, const Point_2& p, const Point_2& q, const Point_2& r) {
  const double a = cross(p, q, point);
  const double b = cross(q, r, point);
  const double c = cross(r, p, point);
  return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

constexpr double negligible = 1e-9;

/// Values above 1 of the critical points of the multiplicative distance: points in the convex hull of the centers of
/// their nearest disks. Ascending. Every pair and every triple of disks is tried.
std::vector<double> critical_values(const Balls_2& disks) {
  std::vector<double> result;
  const auto add = [&](const Point_2& point, double value) {
    if (value > 1 + 1e-7 && multiplicative_distance(disks, point) >= value * (1 - negligible)) result.push_back(value);
  };
  const int count = static_cast<int>(disks.size());
  for (int i = 0; i < count; ++i) {
    const Point_2& p = disks.centers[i];
    for (int j = i + 1; j < count; ++j) {
      const Point_2& q = disks.centers[j];
      const double sum = disks.radii[i] + disks.radii[j];
      const double share = disks.radii[i] / sum;
      add({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)}, distance(p, q) / sum);
      for (int k = j + 1; k < count; ++k) {
        const Point_2& r = disks.centers[k];
        // Equal distances are two linear equations in the point and the squared value: point = p + base + value^2 step.
        const double qx = q.x - p.x;
        const double qy = q.y - p.y;
        const double rx = r.x - p.x;
        const double ry = r.y - p.y;
        const double det = 2 * (qx * ry - qy * rx);
        if (std::abs(det) < 1e-12 * (qx * qx + qy * qy + rx * rx + ry * ry)) continue;
        const double square = disks.radii[i] * disks.radii[i];
        const double wq = square - disks.radii[j] * disks.radii[j];
        const double wr = square - disks.radii[k] * disks.radii[k];
        const double lq = qx * qx + qy * qy;
        const double lr = rx * rx + ry * ry;
        const Point_2 base{(lq * ry - lr * qy) / det, (qx * lr - rx * lq) / det};
        const Point_2 step{(wq * ry - wr * qy) / det, (qx * wr - rx * wq) / det};
        const double a = step.x * step.x + step.y * step.y;
        const double b = base.x * step.x + base.y * step.y - square / 2;
        const double c = base.x * base.x + base.y * base.y;
        const double discriminant = b * b - a * c;
        if (discriminant < 0) continue;
        const double root = -b + (b < 0 ? 1 : -1) * std::sqrt(discriminant);
        for (const double squared_value : {c / root, a > 0 ? root / a : -1.0}) {
          if (!(squared_value > 0) || !std::isfinite(squared_value)) continue;
          const Point_2 point{p.x + base.x + squared_value * step.x, p.y + base.y + squared_value * step.y};
          if (is_in_triangle(point, p, q, r)) add(point, std::sqrt(squared_value));
        }
      }
    }
  }
  std::ranges::sort(result);
  return result;
}

/// The medial disks that have an extent.
Balls_2 extended_medial_disks(const Union_medial_axis_2& axis) {
  const Balls_2 all = medial_balls(axis);
  std::vector<int> kept;
  for (std::size_t b = 0; b < all.size(); ++b)
    if (all.radii[b] > 0) kept.push_back(static_cast<int>(b));
  return subset(all, kept);
}

Betti betti_at(const Union_medial_axis_2& axis, double scale) {
  return betti_of_union(grown_medial_disks(axis, scale));
}

/// Where the topology of the growing union changes first, up to `last`, to 12 digits. Changes that are undone within a
/// percent are not seen.
std::optional<double> first_change(const Union_medial_axis_2& axis, double last) {
  const Betti original = betti_at(axis, 1);
  double low = 1;
  while (low < last && betti_at(axis, low * 1.01) == original) low *= 1.01;
  if (low >= last) return std::nullopt;
  double high = low * 1.01;
  while (high > low * (1 + 1e-12)) {
    const double middle = (low + high) / 2;
    (betti_at(axis, middle) == original ? low : high) = middle;
  }
  return high;
}

Betti betti_of_scale_axis(const Scale_stages& stages, double scale) {
  const Scale_axis_2 axis = at_scale(stages, scale).scale_axis();
  return betti_of_graph(axis.centers.size(), axis.edges);
}

struct Seen {
  int changes = 0;       ///< sets with a first critical value that was tried
  int without = 0;       ///< sets without one
  int too_near = 0;      ///< sets with one that is too near to 1 to be told from it
  int components = 0;    ///< first changes that join components
  int holes_filled = 0;  ///< ... that fill a hole
  int holes_made = 0;
};

/// Compares Betti numbers below and above the first critical value, and that value with the one found by bisection.
void expect_corollary(const std::shared_ptr<const Balls_2>& balls, Seen& seen) {
  const Scale_stages stages = scale_stages(balls, 1);
  const Betti original = betti(*stages.boundary);
  const std::vector<double> values = critical_values(extended_medial_disks(stages.axis));
  constexpr double last = 20;
  EXPECT_EQ(betti_of_scale_axis(stages, 1), original);
  if (values.empty() || values.front() > last) {
    ++seen.without;
    for (const double scale : {1.2, 2.0, 6.0, last}) EXPECT_EQ(betti_of_scale_axis(stages, scale), original) << scale;
    return;
  }
  const double critical = values.front();
  if (critical < 1 + 1e-5) {
    ++seen.too_near;
    return;
  }
  ++seen.changes;
  constexpr double step = 1e-7;
  for (const double share : {0.1, 0.5, 0.9}) {
    const double scale = 1 + share * (critical - 1);
    EXPECT_EQ(betti_at(stages.axis, scale), original) << scale << " of " << critical;
    EXPECT_EQ(betti_of_scale_axis(stages, scale), original) << scale << " of " << critical;
  }
  EXPECT_EQ(betti_of_scale_axis(stages, critical * (1 - step)), original);
  const Betti after = betti_at(stages.axis, critical * (1 + step));
  // A second event right after it may undo the first.
  if (values.size() == 1 || values[1] > critical * (1 + step)) {
    EXPECT_NE(after, original) << critical;
  }
  EXPECT_EQ(betti_of_scale_axis(stages, critical * (1 + step)), after);
  if (after[0] < original[0]) ++seen.components;
  if (after[1] < original[1]) ++seen.holes_filled;
  if (after[1] > original[1]) ++seen.holes_made;
  // Without a second one that may undo the first, bisection finds it.
  const std::optional<double> change = first_change(stages.axis, 2 * critical);
  if (!change) {
    EXPECT_TRUE(values.size() > 1 && values[1] < critical * 1.02) << critical;
    return;
  }
  const auto nearest = std::ranges::min_element(values, {}, [&](double v) { return std::abs(v - *change); });
  EXPECT_NEAR(*nearest, *change, 1e-8 * *change);
  if (values.size() == 1 || values[1] > critical * 1.02) {
    EXPECT_NEAR(critical, *change, 1e-8 * *change);
  }
}

TEST(Critical_scale_2, bounds_where_topology_is_kept) {
  Seen seen;
  for (const Disk_family& family : disk_families()) {
    if (family.name != "sparse" && family.name != "dense" && family.name != "equal radii" && family.name != "ring" &&
        family.name != "nested")
      continue;
    for (std::uint64_t seed = 0; seed < repetitions(family.name == "ring" || family.name == "sparse" ? 25 : 10);
         ++seed) {
      SCOPED_TRACE(family.name + " " + std::to_string(seed));
      expect_corollary(std::make_shared<const Balls_2>(given_balls(family.make(seed))), seen);
    }
  }
  EXPECT_GT(seen.changes, 40);
  EXPECT_GT(seen.without, 5);
  EXPECT_LT(seen.too_near, 3);
  EXPECT_GT(seen.components, 10);
  EXPECT_GT(seen.holes_filled, 5);
  EXPECT_GT(seen.holes_made, 5);
}

TEST(Critical_scale_2, of_two_disks_is_where_they_meet) {
  const auto balls = std::make_shared<const Balls_2>(given_balls(std::vector<Disk_2>{{{0, 0}, 1}, {{9, 0}, 2}}));
  const Scale_stages stages = scale_stages(balls, 1);
  EXPECT_EQ(critical_values(extended_medial_disks(stages.axis)), std::vector<double>{3});
  EXPECT_EQ(betti_of_scale_axis(stages, 2.999999), (Betti{2, 0}));
  EXPECT_EQ(betti_of_scale_axis(stages, 3), (Betti{1, 0}));
  EXPECT_NEAR(*first_change(stages.axis, 5), 3, 1e-11);
}

TEST(Critical_scale_2, of_sampled_shapes) {
  // A ring of width 0.5 around a hole of radius 0.5: its medial disks reach the center when they are three times as
  // large.
  std::vector<Point_2> ring = ellipse(1, 1, 70, 0.3, 3);
  for (const Point_2& p : ellipse(0.5, 0.5, 40, 0.3, 4)) ring.push_back(p);
  const auto ring_disks = std::make_shared<const Balls_2>(inner_voronoi_disks(ring).circumscribed.balls);
  const Scale_stages ring_stages = scale_stages(ring_disks, 1);
  EXPECT_NEAR(critical_values(extended_medial_disks(ring_stages.axis)).front(), 3, 0.1);
  Seen seen;
  expect_corollary(ring_disks, seen);
  EXPECT_EQ(seen.holes_filled, 1);
  // Two fingers that lean towards each other: where their tips meet, a hole is made.
  const Outline_2 fingers{{{{0, 0}, {9, 0}, {8, 10}, {4.7, 10}, {5.5, 2}, {3.5, 2}, {4.1, 10}, {1, 10}}}};
  std::vector<Point_2> samples;
  Random random(5);
  for (std::size_t i = 0; i < fingers.rings[0].size(); ++i) {
    const Point_2& p = fingers.rings[0][i];
    const Point_2& q = fingers.rings[0][(i + 1) % fingers.rings[0].size()];
    const int parts = static_cast<int>(std::ceil(distance(p, q) / 0.5));
    for (int part = 0; part < parts; ++part) {
      const double t = (part + random.uniform(0.3, 0.7)) / parts;
      samples.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  expect_corollary(std::make_shared<const Balls_2>(inner_voronoi_disks(samples, fingers).circumscribed.balls), seen);
  EXPECT_EQ(seen.holes_made, 1);
  expect_corollary(std::make_shared<const Balls_2>(inner_voronoi_disks(flower(60, 0.6, 3, 0.3, 2)).circumscribed.balls),
                   seen);
}

/// [B. Miklos 2010, section 6.1.2] Growing the medial disks at the vertices grows them all.
TEST(Critical_scale_2, disks_at_vertices_grow_to_all_that_medial_disks_grow_to) {
  expect_of_given_balls(repetitions(10), [](const std::shared_ptr<const Balls_2>& balls) -> testing::AssertionResult {
    const Scale_stages stages = scale_stages(balls, 1);
    const Union_medial_axis_2& axis = stages.axis;
    const double tolerance = 1e-9 * stages.extent();
    for (const double scale : {1.0, 1.2, 2.5}) {
      for (std::size_t e = 0; e < axis.edges.size(); ++e) {
        const auto [a, b] = axis.edges[e];
        const Point_2& contact = axis.boundary->vertices[axis.contacts[e][0]];
        Balls_2 ends;
        ends.centers = {axis.centers[a], axis.centers[b]};
        ends.radii = {scale * axis.radii[a], scale * axis.radii[b]};
        for (const double t : {0.2, 0.5, 0.8}) {
          const Point_2 center{ends.centers[0].x + t * (ends.centers[1].x - ends.centers[0].x),
                               ends.centers[0].y + t * (ends.centers[1].y - ends.centers[0].y)};
          const double radius = scale * distance(center, contact);
          for (int direction = 0; direction < 16; ++direction) {
            const Point_2 point{center.x + radius * std::cos(0.4 * direction),
                                center.y + radius * std::sin(0.4 * direction)};
            if (!is_in_union(ends, point, tolerance))
              return testing::AssertionFailure() << "scale " << scale << ", a medial disk on edge " << e;
          }
        }
      }
    }
    return testing::AssertionSuccess();
  });
}

}  // namespace
}  // namespace mesecina::test
