// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_2/union_medial_axis_2.h"
#include "tests/geometries/results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <tuple>

#include "tests/geometries/union/disk_sets.h"
#include "tests/geometries/union/union_oracle.h"

namespace mesecina::test {
namespace {

std::string to_text(const Point_2& p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

struct Scene {
  std::shared_ptr<const Balls_2> balls;
  std::shared_ptr<const Union_boundary_2> boundary;
  Union_voronoi_2 voronoi;
  Union_medial_axis_2 axis;
  Union_oracle oracle;
  double tolerance = 0;  ///< of lengths
};

Scene scene_of(const std::shared_ptr<const Balls_2>& balls, double alpha = 0) {
  Progress progress;
  const auto boundary = std::make_shared<const Union_boundary_2>(union_boundary(balls, alpha, progress));
  Union_voronoi_2 voronoi = union_voronoi(boundary, progress);
  Union_medial_axis_2 axis = union_medial_axis(voronoi, false, progress);
  Scene scene{balls, boundary, std::move(voronoi), std::move(axis), union_oracle(*balls, alpha), 0};
  double steepness = 1;
  for (const Oracle_vertex& v : scene.oracle.vertices)
    if (v.steepness > 0) steepness = std::min(steepness, v.steepness);
  scene.tolerance = scene.oracle.scale * std::min(1e-6, 1e-11 + 1e-13 / steepness);
  return scene;
}

Point_2 point_between(const Point_2& a, const Point_2& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

testing::AssertionResult is_graph(const Scene& s) {
  const auto& axis = s.axis;
  const std::size_t count = axis.centers.size();
  if (axis.radii.size() != count || axis.balls.size() != count || axis.contacts.size() != axis.edges.size() ||
      axis.kinds.size() != axis.edges.size())
    return failure() << "sizes are wrong";
  std::vector<int> degree(count, 0);
  std::set<std::tuple<Edge, Edge>> seen;
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    const auto [a, b] = axis.edges[e];
    if (a < 0 || b < 0 || a >= static_cast<int>(count) || b >= static_cast<int>(count) || a == b)
      return failure() << "edge " << e << " joins " << a << " and " << b;
    if (!seen.insert({sorted_edge({a, b}), axis.contacts[e]}).second) return failure() << "an edge is there twice";
    ++degree[a];
    ++degree[b];
    const auto [v, w] = axis.contacts[e];
    if (v < 0 || w >= static_cast<int>(s.boundary->vertices.size()) || v > w)
      return failure() << "edge " << e << " has contacts " << v << " " << w;
    if (v == w && axis.kinds[e] != Axis_edge_kind::singular) return failure() << "edge " << e << " has one contact";
  }
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    const auto [a, b] = axis.edges[e];
    if (axis.kinds[e] == Axis_edge_kind::incomplete && degree[a] != 1 && degree[b] != 1)
      return failure() << "incomplete edge " << e << " is no leaf";
    if (axis.kinds[e] == Axis_edge_kind::singular && (axis.balls[a] == -1 || axis.balls[b] == -1))
      return failure() << "singular edge " << e << " does not join disks of the union";
  }
  for (std::size_t m = 0; m < count; ++m) {
    const int ball = axis.balls[m];
    if (ball == -1 && degree[m] == 0) return failure() << "medial disk " << m << " is alone and none of the disks";
    if (ball == -1) continue;
    if (axis.centers[m] != s.balls->centers[ball] || axis.radii[m] != s.boundary->radii[ball])
      return failure() << "medial disk " << m << " is not disk " << ball;
  }
  return testing::AssertionSuccess();
}

/// Every point of the output has its contacts as nearest points of the boundary.
testing::AssertionResult is_on_axis(const Scene& s) {
  const auto& axis = s.axis;
  for (std::size_t m = 0; m < axis.centers.size(); ++m) {
    const double expected = s.oracle.boundary_distance(axis.centers[m]);
    if (!(std::abs(axis.radii[m] - expected) <= s.tolerance))
      return failure() << "medial disk " << m << " at " << to_text(axis.centers[m]) << " has radius " << axis.radii[m]
                       << ", the boundary is at " << expected;
    if (expected > s.tolerance && !s.oracle.is_inside(axis.centers[m]))
      return failure() << "medial disk " << m << " at " << to_text(axis.centers[m]) << " is outside";
  }
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    for (const double t : {0.0, 0.02, 0.3, 0.5, 0.75, 0.98, 1.0}) {
      const Point_2 x = point_between(axis.centers[axis.edges[e][0]], axis.centers[axis.edges[e][1]], t);
      const double nearest = s.oracle.boundary_distance(x);
      for (const int contact : axis.contacts[e]) {
        const double found = distance(x, s.boundary->vertices[contact]);
        if (!(std::abs(found - nearest) <= s.tolerance))
          return failure() << "contact " << contact << " of edge " << e << " is " << found << " away from "
                           << to_text(x) << ", the boundary " << nearest;
      }
      if (nearest > s.tolerance && !s.oracle.is_inside(x)) return failure() << "edge " << e << " leaves the union";
    }
  }
  return testing::AssertionSuccess();
}

double distance_to_axis(const Union_medial_axis_2& axis, const Point_2& x) {
  double result = std::numeric_limits<double>::infinity();
  for (const Point_2& c : axis.centers) result = std::min(result, distance(c, x));
  for (const auto& [i, j] : axis.edges) {
    const Point_2& a = axis.centers[i];
    const Point_2& b = axis.centers[j];
    const double square = squared_distance(a, b);
    if (square == 0) continue;
    const double t = ((x.x - a.x) * (b.x - a.x) + (x.y - a.y) * (b.y - a.y)) / square;
    if (t > 0 && t < 1) result = std::min(result, distance(point_between(a, b, t), x));
  }
  return result;
}

/// From inner points away from the nearest point of the boundary, as long as that stays the nearest: the end is on the
/// medial axis.
testing::AssertionResult nothing_is_missing(const Scene& s) {
  std::set<int> found(s.axis.balls.begin(), s.axis.balls.end());
  for (const Oracle_arc& arc : s.oracle.arcs) {
    // Every point of the arc is nearest to the center. Vertices, and so short arcs, are rounded.
    if (arc.from != arc.to &&
        distance(s.oracle.vertices[arc.from].point(), s.oracle.vertices[arc.to].point()) < 1e-12 * s.oracle.scale)
      continue;
    if (!found.contains(arc.ball)) return failure() << "the center of disk " << arc.ball << " is missing";
  }
  Box box;
  for (std::size_t i = 0; i < s.oracle.centers.size(); ++i) {
    const Point_2& c = s.oracle.centers[i];
    const double r = s.oracle.radii[i];
    box.add(Point_2{c.x - r, c.y - r});
    box.add(Point_2{c.x + r, c.y + r});
  }
  Random random(s.oracle.disks.size());
  for (int i = 0; i < 40; ++i) {
    const double random_x = random.uniform(box.lower.x, box.upper.x);
    const Point_2 x{random_x, random.uniform(box.lower.y, box.upper.y)};
    if (!s.oracle.is_inside(x)) continue;
    const Oracle_vertex* foot = nullptr;
    for (const Oracle_vertex& v : s.oracle.vertices)
      if (!foot || distance(v.point(), x) < distance(foot->point(), x)) foot = &v;
    if (!foot) continue;
    const double away = distance(foot->point(), x);
    // Nearest to the inside of an arc: leads to its center.
    if (away > s.oracle.boundary_distance(x) || away < 1e-3 * s.oracle.scale) continue;
    const Point_2 p = foot->point();
    const Point_2 u{(x.x - p.x) / away, (x.y - p.y) / away};
    double reach = std::numeric_limits<double>::infinity();
    double gap = 0;
    for (const Oracle_vertex& w : s.oracle.vertices) {
      const double advance = u.x * (w.point().x - p.x) + u.y * (w.point().y - p.y);
      const double square = squared_distance(p, w.point());
      if (&w == foot || advance <= 0 || square / (2 * advance) >= reach) continue;
      reach = square / (2 * advance);
      gap = std::sqrt(square);
    }
    // Two vertices very close to each other say little about the place where they are equally near.
    if (!(reach < 4 * s.oracle.scale) || gap < 1e-3 * reach || reach < 1e-3 * s.oracle.scale) continue;
    const Point_2 end{p.x + reach * u.x, p.y + reach * u.y};
    if (std::abs(s.oracle.boundary_distance(end) - reach) > s.tolerance) return failure() << "the oracle is wrong";
    const double error = distance_to_axis(s.axis, end);
    if (!(error <= 1e4 * s.tolerance))
      return failure() << to_text(end) << ", where one gets from " << to_text(x) << ", is " << error << " away";
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult is_medial_axis_for(const std::shared_ptr<const Balls_2>& balls, double alpha) {
  const Scene s = scene_of(balls, alpha);
  if (auto result = is_graph(s); !result) return result;
  if (auto result = is_on_axis(s); !result) return result;
  return nothing_is_missing(s);
}

testing::AssertionResult is_medial_axis(const std::shared_ptr<const Balls_2>& balls) {
  return is_medial_axis_for(balls, 0);
}

TEST(Union_medial_axis_2, is_the_medial_axis) { expect_of_given_balls(repetitions(40), is_medial_axis); }
TEST(Union_medial_axis_2, is_the_medial_axis_of_circumscribed_disks) {
  expect_of_circumscribed_balls(repetitions(10), is_medial_axis);
}

TEST(Union_medial_axis_2, is_the_medial_axis_for_other_alpha) {
  const auto check = [](const std::shared_ptr<const Balls_2>& balls) {
    double square = 0;
    for (const double radius : balls->radii) square = std::max(square, radius * radius);
    for (const double alpha : {0.2 * square, -0.2 * square})
      if (auto result = is_medial_axis_for(balls, alpha); !result) return result << " (alpha " << alpha << ")";
    return testing::AssertionSuccess();
  };
  expect_of_given_balls(repetitions(5), check);
  expect_of_circumscribed_balls(repetitions(2), check);
}

testing::AssertionResult voronoi_is_right(const std::shared_ptr<const Balls_2>& balls) {
  const Scene s = scene_of(balls);
  const Union_voronoi_2& v = s.voronoi;
  const std::size_t count = v.delaunay.triangles.size();
  if (v.is_inner.size() != count || v.ball_of_triangle.size() != count || v.vertices.size() != count ||
      v.radii.size() != count)
    return failure() << "sizes are wrong";
  double separation = std::numeric_limits<double>::infinity();
  for (const Point_2& p : s.boundary->vertices)
    for (const Point_2& q : s.boundary->vertices)
      if (&p < &q) separation = std::min(separation, distance(p, q));
  if (v.lost_chords != 0 && separation > 1e-6 * s.oracle.scale)
    return failure() << v.lost_chords << " chords lost, though vertices are " << separation << " apart";
  for (std::size_t t = 0; t < count; ++t) {
    const auto& triangle = v.delaunay.triangles[t];
    // Vertices that are one to rounding share a corner.
    const auto is_source = [&](int ball) {
      return std::ranges::all_of(triangle, [&](int corner) {
        for (int vertex = 0; vertex < static_cast<int>(v.delaunay.site.size()); ++vertex) {
          const auto sources = s.boundary->sources_of(vertex);
          if (v.delaunay.site[vertex] == corner && std::ranges::find(sources, ball) != sources.end()) return true;
        }
        return false;
      });
    };
    const int ball = v.ball_of_triangle[t];
    if (ball != -1) {
      if (!is_source(ball)) return failure() << "triangle " << t << " is not on circle " << ball;
      if (v.vertices[t] != balls->centers[ball] || v.radii[t] != s.boundary->radii[ball])
        return failure() << "the Voronoi vertex of triangle " << t << " is not disk " << ball;
    } else {
      for (const int candidate : s.boundary->sources_of(triangle[0]))
        if (is_source(candidate)) return failure() << "triangle " << t << " is on circle " << candidate;
    }
    const Point_2& c = v.vertices[t];
    const double nearest = s.oracle.boundary_distance(c);
    const double margin = 1e3 * s.tolerance;
    // On the boundary it cannot be told, nor where an arc is as near as the corners, to rounding.
    if (nearest <= margin) continue;
    if (ball == -1 && std::abs(v.radii[t] - s.oracle.arc_distance(c)) <= margin) continue;
    const bool expected = s.oracle.is_inside(c) && v.radii[t] - nearest <= s.tolerance;
    if ((v.is_inner[t] != 0) != expected)
      return failure() << "triangle " << t << " with Voronoi vertex " << to_text(c) << " is said to be "
                       << (expected ? "outside" : "inside");
  }
  return testing::AssertionSuccess();
}

TEST(Union_voronoi_2, labels_follow_the_definition) {
  expect_of_given_balls(repetitions(20), voronoi_is_right);
  expect_of_circumscribed_balls(repetitions(5), voronoi_is_right);
}

testing::AssertionResult complete_axis_lacks_incomplete_edges(const std::shared_ptr<const Balls_2>& balls) {
  const Scene s = scene_of(balls);
  Progress progress;
  const Union_medial_axis_2 complete = union_medial_axis(s.voronoi, true, progress);
  using Described = std::tuple<Point_2, Point_2, Edge, Axis_edge_kind>;
  const auto describe = [](const Union_medial_axis_2& axis) {
    std::vector<Described> result;
    for (std::size_t e = 0; e < axis.edges.size(); ++e) {
      Point_2 p = axis.centers[axis.edges[e][0]];
      Point_2 q = axis.centers[axis.edges[e][1]];
      if (std::tie(q.x, q.y) < std::tie(p.x, p.y)) std::swap(p, q);
      if (axis.kinds[e] != Axis_edge_kind::incomplete) result.emplace_back(p, q, axis.contacts[e], axis.kinds[e]);
    }
    std::ranges::sort(result, [](const Described& a, const Described& b) {
      const auto key = [](const Described& d) {
        const auto& [p, q, contacts, kind] = d;
        return std::tuple(p.x, p.y, q.x, q.y, contacts, kind);
      };
      return key(a) < key(b);
    });
    return result;
  };
  if (std::ranges::find(complete.kinds, Axis_edge_kind::incomplete) != complete.kinds.end())
    return failure() << "there is an incomplete edge";
  if (describe(complete) != describe(s.axis)) return failure() << "it has other edges";
  return testing::AssertionSuccess();
}

TEST(Union_medial_axis_2, of_complete_edges_lacks_the_others_only) {
  expect_of_given_balls(repetitions(15), complete_axis_lacks_incomplete_edges);
  expect_of_circumscribed_balls(repetitions(4), complete_axis_lacks_incomplete_edges);
}

testing::AssertionResult measures_are_right(const std::shared_ptr<const Balls_2>& balls) {
  const Scene s = scene_of(balls);
  const std::vector<double> lambda = lambda_of_edges(s.axis);
  const std::vector<double> angle = angle_of_edges(s.axis);
  if (lambda.size() != s.axis.edges.size() || angle.size() != s.axis.edges.size()) return failure() << "sizes";
  for (std::size_t e = 0; e < lambda.size(); ++e) {
    const Point_2& p = s.boundary->vertices[s.axis.contacts[e][0]];
    const Point_2& q = s.boundary->vertices[s.axis.contacts[e][1]];
    const double half = distance(p, q) / 2;
    if (!(std::abs(lambda[e] - half) <= 1e-12 * half)) return failure() << "lambda " << lambda[e] << ", not " << half;
    const Point_2& a = s.axis.centers[s.axis.edges[e][0]];
    const Point_2& b = s.axis.centers[s.axis.edges[e][1]];
    double best = s.axis.contacts[e][0] == s.axis.contacts[e][1] ? 180 : 0;
    double low = 0;
    double high = 1;
    for (int round = 0; round < 15 && half > 0; ++round) {
      constexpr int steps = 20;
      double best_t = low;
      for (int i = 0; i <= steps; ++i) {
        const double t = low + (high - low) * i / steps;
        const Point_2 x = point_between(a, b, t);
        const double seen = std::abs(std::atan2((p.x - x.x) * (q.y - x.y) - (p.y - x.y) * (q.x - x.x),
                                                (p.x - x.x) * (q.x - x.x) + (p.y - x.y) * (q.y - x.y))) *
                            180 / std::numbers::pi;
        if (seen < best) continue;
        best = seen;
        best_t = t;
      }
      const double width = (high - low) / steps;
      low = std::max(0.0, best_t - width);
      high = std::min(1.0, best_t + width);
    }
    if (!(angle[e] > 0 && angle[e] <= 180 && std::abs(angle[e] - best) <= 1e-3))
      return failure() << "angle of edge " << e << " is " << angle[e] << ", not " << best;
  }
  return testing::AssertionSuccess();
}

TEST(Union_medial_axis_2, measures_follow_their_definitions) {
  expect_of_given_balls(repetitions(6), measures_are_right);
  expect_of_circumscribed_balls(repetitions(3), measures_are_right);
}

}  // namespace
}  // namespace mesecina::test
