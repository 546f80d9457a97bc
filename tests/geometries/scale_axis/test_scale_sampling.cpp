// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "tests/geometries/results.h"
#include "tests/geometries/scale_axis/scale_stages.h"
#include "tests/geometries/union/disk_sets.h"

/// How edges of the grown medial axis become disks. [B. Miklos: The Scale Axis Transform, 2010, section 6.1.2]
namespace mesecina::test {
namespace {

constexpr int most_halvings = 24;

/// A disk of a scale axis in a few numbers that are compared exactly.
using Place = std::array<double, 3>;
Place place_of(const Scale_axis_2& axis, int disk) {
  return {axis.centers[disk].x, axis.centers[disk].y, axis.radii[disk]};
}

/// An edge of a scale axis.
struct Piece {
  std::array<Place, 2> ends;
  double angle = 0;
};
using Pieces = std::vector<Piece>;

/// cos of (180 - the angle at which the circles meet); 1 and more: one disk in the other, undefined for points.
double depth(const Place& a, const Place& b) {
  const double square = (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
  return (a[2] * a[2] + b[2] * b[2] - square) / (2 * a[2] * b[2]);
}

class Expected_pieces {
 public:
  Expected_pieces(const Scale_stages& stages, double sampling_min_angle)
      : stages_(stages), least_depth_(std::cos((180 - sampling_min_angle) * std::numbers::pi / 180)) {}

  /// What sampling by definition makes of an edge of the axis.
  Pieces of_edge(int e, double angle) {
    const Union_medial_axis_2& axis = stages_.grown_axis;
    const auto end = [&](int disk) {
      return Place{axis.centers[disk].x, axis.centers[disk].y, axis.radii[disk] / stages_.scale};
    };
    contact_ = axis.boundary->vertices[axis.contacts[e][0]];
    pieces_.clear();
    angle_ = angle;
    add(end(axis.edges[e][0]), end(axis.edges[e][1]), 0);
    return pieces_;
  }
  /// True when some piece is so near to the limit that rounding may decide.
  bool is_uncertain() const { return is_uncertain_; }

 private:
  void add(const Place& a, const Place& b, int halvings) {
    const double found = a[2] > 0 && b[2] > 0 ? depth(a, b) : 0;
    if (a[2] == 0 || b[2] == 0 || std::abs(found - least_depth_) < 1e-9) is_uncertain_ = true;
    if (halvings == most_halvings || found >= least_depth_) {
      pieces_.push_back({{std::min(a, b), std::max(a, b)}, angle_});
      return;
    }
    const Point_2 middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    const Place m{middle.x, middle.y, distance(middle, contact_) / stages_.scale};
    add(a, m, halvings + 1);
    add(m, b, halvings + 1);
  }

  const Scale_stages& stages_;
  double least_depth_;
  Point_2 contact_;
  double angle_ = 0;
  Pieces pieces_;
  bool is_uncertain_ = false;
};

/// Without pruning: the complete edges of the axis, halved as the definition says, and its isolated disks; and nothing
/// else.
testing::AssertionResult samples_complete_edges(const Scale_stages& stages, double sampling_min_angle) {
  const Union_medial_axis_2& axis = stages.grown_axis;
  const std::vector<double> angles = angle_of_edges(axis);
  Expected_pieces definition(stages, sampling_min_angle);
  using Key = std::pair<std::array<Place, 2>, double>;
  std::multiset<Key> expected;
  std::multiset<Place> isolated;
  std::vector<bool> has_edge(axis.centers.size(), false);
  for (int e = 0; e < static_cast<int>(axis.edges.size()); ++e) {
    const auto [a, b] = axis.edges[e];
    if (axis.kinds[e] == Axis_edge_kind::incomplete) {
      // Its far end is a leaf that goes with it.
      has_edge[b] = true;
      continue;
    }
    has_edge[a] = has_edge[b] = true;
    for (const Piece& piece : definition.of_edge(e, angles[e])) expected.insert({piece.ends, piece.angle});
  }
  if (definition.is_uncertain()) return testing::AssertionSuccess();
  for (int b = 0; b < static_cast<int>(has_edge.size()); ++b)
    if (!has_edge[b]) isolated.insert({axis.centers[b].x, axis.centers[b].y, axis.radii[b] / stages.scale});
  const Scale_axis_2 found = stages.scale_axis(0, sampling_min_angle);
  std::multiset<Key> found_pieces;
  std::vector<bool> is_used(found.centers.size(), false);
  for (std::size_t e = 0; e < found.edges.size(); ++e) {
    const auto [a, b] = found.edges[e];
    is_used[a] = is_used[b] = true;
    const Place p = place_of(found, a);
    const Place q = place_of(found, b);
    found_pieces.insert({{std::min(p, q), std::max(p, q)}, found.angles[e]});
  }
  std::multiset<Place> found_isolated;
  for (int b = 0; b < static_cast<int>(is_used.size()); ++b)
    if (!is_used[b]) found_isolated.insert(place_of(found, b));
  if (found_pieces != expected)
    return failure() << "scale " << stages.scale << ": " << found_pieces.size() << " edges, expected "
                     << expected.size();
  if (found_isolated != isolated)
    return failure() << "scale " << stages.scale << ": " << found_isolated.size() << " isolated disks, expected "
                     << isolated.size();
  return testing::AssertionSuccess();
}

TEST(Scale_sampling_2, halves_the_complete_edges_of_the_grown_axis) {
  expect_of_given_balls(repetitions(12), [](const std::shared_ptr<const Balls_2>& balls) -> testing::AssertionResult {
    Scale_stages stages = scale_stages(balls, 1);
    for (const double scale : {1.0, 1.15, 1.7}) {
      stages = at_scale(stages, scale);
      for (const double angle : {0.0, 90.0, 150.0, 175.0})
        if (auto result = samples_complete_edges(stages, angle); !result) return result << ", sampling " << angle;
    }
    return testing::AssertionSuccess();
  });
}

/// What must hold of every disk and edge, pruned or not.
testing::AssertionResult is_well_sampled(const Scale_stages& stages, double min_angle, double sampling_min_angle) {
  const Scale_axis_2 axis = stages.scale_axis(min_angle, sampling_min_angle);
  const double tolerance = 1e-9 * stages.extent();
  double longest = 0;
  for (const auto& [a, b] : stages.grown_axis.edges)
    longest = std::max(longest, distance(stages.grown_axis.centers[a], stages.grown_axis.centers[b]));
  const double shortest = std::ldexp(longest, -most_halvings) * (1 + 1e-6);
  const double least = std::cos((180 - sampling_min_angle) * std::numbers::pi / 180);
  for (const auto& [a, b] : axis.edges) {
    if (distance(axis.centers[a], axis.centers[b]) <= shortest) continue;
    const double ra = axis.radii[a];
    const double rb = axis.radii[b];
    const double slack = tolerance * std::max(ra, rb);
    if (ra * ra + rb * rb - squared_distance(axis.centers[a], axis.centers[b]) < 2 * ra * rb * least - slack)
      return failure() << "neighbours do not meet deeply";
  }
  for (std::size_t b = 0; b < axis.centers.size(); ++b) {
    const double radius = axis.radii[b] * stages.scale;
    if (!is_in_union(stages.grown_disks(), axis.centers[b], tolerance)) return failure() << "a disk centered outside";
    if (std::abs(distance_to_boundary(*stages.grown_boundary, axis.centers[b]) - radius) > tolerance)
      return failure() << "scale " << stages.scale << ": a disk of radius " << radius << " is "
                       << distance_to_boundary(*stages.grown_boundary, axis.centers[b]) << " from the boundary";
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult is_well_sampled_everywhere(const std::shared_ptr<const Balls_2>& balls) {
  Scale_stages stages = scale_stages(balls, 1);
  for (const double scale : {1.0, 1.1, 1.5}) {
    stages = at_scale(stages, scale);
    for (const double min_angle : {0.0, 30.0})
      if (auto result = is_well_sampled(stages, min_angle, 150); !result) return result;
  }
  return testing::AssertionSuccess();
}

TEST(Scale_sampling_2, disks_are_medial_and_meet_deeply) {
  expect_of_given_balls(repetitions(6), is_well_sampled_everywhere);
  expect_of_circumscribed_balls(repetitions(3), is_well_sampled_everywhere);
}

TEST(Scale_sampling_2, stops_after_24_halvings_where_disks_touch) {
  // Two disks touch when they have grown by 2: shrunk back, the disks between them go down to the point where they do.
  const auto balls = std::make_shared<const Balls_2>(given_balls(std::vector<Disk_2>{{{0, 0}, 1}, {{6, 0}, 2}}));
  const Scale_stages stages = scale_stages(balls, 2);
  const Scale_axis_2 axis = stages.scale_axis(30, 150);
  EXPECT_EQ(betti_of_graph(axis.centers.size(), axis.edges), (Betti{1, 0}));
  ASSERT_GT(axis.edges.size(), 40U);
  EXPECT_LT(axis.edges.size(), 2000U);
  double shortest = 6;
  double reached = 0;
  std::vector<double> places;
  for (std::size_t b = 0; b < axis.centers.size(); ++b) {
    EXPECT_EQ(axis.centers[b].y, 0);
    EXPECT_NEAR(axis.radii[b], std::abs(axis.centers[b].x - 2) / 2, 1e-15);
    places.push_back(axis.centers[b].x);
  }
  std::ranges::sort(places);
  EXPECT_EQ(places.front(), 0);
  EXPECT_EQ(places.back(), 6);
  for (std::size_t i = 1; i < places.size(); ++i) {
    shortest = std::min(shortest, places[i] - places[i - 1]);
    reached += places[i] - places[i - 1];
  }
  EXPECT_DOUBLE_EQ(shortest, std::ldexp(6, -most_halvings));
  EXPECT_DOUBLE_EQ(reached, 6);
}

TEST(Scale_sampling_2, angles_from_179_degrees_are_one) {
  const auto balls = std::make_shared<const Balls_2>(given_balls(disk_families()[1].make(3)));
  const Scale_stages stages = scale_stages(balls, 1.2);
  const std::size_t count = stages.scale_axis(0, 179).centers.size();
  EXPECT_EQ(stages.scale_axis(0, 180).centers.size(), count);
  EXPECT_GT(count, stages.scale_axis(0, 170).centers.size());
  EXPECT_GT(stages.scale_axis(0, 170).centers.size(), stages.scale_axis(0, 90).centers.size());
}

/// Points on the boundary and inside of a union.
std::vector<Point_2> points_of_union(const Union_boundary_2& boundary) {
  const Balls_2& balls = *boundary.dual->regular->balls;
  std::vector<Point_2> result = boundary.vertices;
  Random random(balls.size());
  for (std::size_t b = 0; b < balls.size(); ++b) {
    for (int i = 0; i < 30; ++i) {
      const double angle = random.uniform(0, 2 * std::numbers::pi);
      const double radius = balls.radii[b] * (i % 2 == 0 ? 1 : std::sqrt(random.unit()));
      result.push_back({balls.centers[b].x + radius * std::cos(angle), balls.centers[b].y + radius * std::sin(angle)});
    }
  }
  return result;
}

/// Grown again, the disks of the scale axis fill the grown union, but for the disks at incomplete edges and those that
/// were pruned.
testing::AssertionResult fills_the_grown_union(const std::shared_ptr<const Balls_2>& balls) {
  Scale_stages stages = scale_stages(balls, 1);
  for (const double scale : {1.0, 1.2, 2.0}) {
    stages = at_scale(stages, scale);
    const double tolerance = 1e-9 * stages.extent();
    const std::vector<Point_2> points = points_of_union(*stages.grown_boundary);
    for (const double min_angle : {0.0, 30.0, 120.0}) {
      const Scale_axis_2 axis = stages.scale_axis(min_angle, 90);
      Balls_2 again;
      again.centers = axis.centers;
      for (const double radius : axis.radii) again.radii.push_back(radius * scale);
      const std::set<Place> kept = [&] {
        std::set<Place> result;
        for (std::size_t b = 0; b < again.size(); ++b) result.insert({again.centers[b].x, again.centers[b].y, 0});
        return result;
      }();
      for (std::size_t b = 0; b < stages.grown_axis.centers.size(); ++b) {
        const Point_2& center = stages.grown_axis.centers[b];
        if (kept.contains({center.x, center.y, 0})) continue;
        again.centers.push_back(center);
        again.radii.push_back(stages.grown_axis.radii[b]);
      }
      for (const Point_2& point : points)
        if (!is_in_union(again, point, tolerance))
          return failure() << "scale " << scale << ", least angle " << min_angle << ": a point is missing";
    }
  }
  return testing::AssertionSuccess();
}

TEST(Scale_sampling_2, disks_grown_again_are_the_grown_union_but_for_what_is_pruned) {
  expect_of_given_balls(repetitions(4), fills_the_grown_union);
  expect_of_circumscribed_balls(repetitions(2), fills_the_grown_union);
}

/// The simplified shape is inside the grown one.
testing::AssertionResult shape_is_inside(const std::shared_ptr<const Balls_2>& balls) {
  Progress progress;
  for (const double scale : {1.0, 1.3}) {
    const Scale_stages stages = scale_stages(balls, scale);
    const Scale_axis_2 axis = stages.scale_axis();
    Balls_2 shape;
    shape.centers = axis.centers;
    shape.radii = axis.radii;
    const Union_boundary_2 boundary = union_boundary(std::make_shared<const Balls_2>(shape), 0, progress);
    const double tolerance = 1e-9 * stages.extent();
    for (const Point_2& vertex : boundary.vertices)
      if (!is_in_union(stages.grown_disks(), vertex, tolerance)) return failure() << "a vertex outside";
    for (std::size_t b = 0; b < shape.size(); ++b) {
      for (int direction = 0; direction < 12; ++direction) {
        const double angle = direction * std::numbers::pi / 6;
        const Point_2 point{shape.centers[b].x + shape.radii[b] * std::cos(angle),
                            shape.centers[b].y + shape.radii[b] * std::sin(angle)};
        if (!is_in_union(stages.grown_disks(), point, tolerance)) return failure() << "a point outside";
      }
    }
  }
  return testing::AssertionSuccess();
}

TEST(Scale_sampling_2, shape_is_within_the_grown_union) {
  expect_of_given_balls(repetitions(6), shape_is_inside);
  expect_of_circumscribed_balls(repetitions(2), shape_is_inside);
}

}  // namespace
}  // namespace mesecina::test
