// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

#include "geometries/medial_axis_2/medial_axis_2.h"
#include "geometries/union_2/union_medial_axis_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/union/disk_sets.h"

/// [B. Miklos: The Scale Axis Transform, 2010, Theorems 4 and 8]
namespace mesecina::test {
namespace {

/// A smooth curve as many points, with the local feature size at each: its distance to the medial axis of both sides.
struct Dense_curve {
  std::vector<Point_2> points;
  std::vector<double> feature_size;
};

Dense_curve dense_curve(const std::function<Point_2(double)>& curve, int count) {
  Dense_curve result;
  std::vector<Point_2> normals;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * i / count;
    result.points.push_back(curve(t));
    const Point_2 before = curve(t - 1e-5);
    const Point_2 after = curve(t + 1e-5);
    const double length = distance(before, after);
    normals.push_back({(before.y - after.y) / length, (after.x - before.x) / length});
  }
  // The largest empty circles that touch the curve in a point; near the point the curvature circle.
  std::vector<Point_2> medial;
  for (int i = 0; i < count; ++i) {
    const Point_2& p = result.points[i];
    for (const double side : {1.0, -1.0}) {
      const Point_2 n{side * normals[i].x, side * normals[i].y};
      double radius = std::numeric_limits<double>::infinity();
      for (int j = 0; j < count; ++j) {
        const Point_2& q = result.points[j];
        const double advance = n.x * (q.x - p.x) + n.y * (q.y - p.y);
        const double square = squared_distance(p, q);
        if (advance > 1e-9 * square) radius = std::min(radius, square / (2 * advance));
      }
      if (radius < 1e6) medial.push_back({p.x + radius * n.x, p.y + radius * n.y});
    }
  }
  for (const Point_2& p : result.points) {
    double square = std::numeric_limits<double>::infinity();
    for (const Point_2& m : medial) square = std::min(square, squared_distance(p, m));
    result.feature_size.push_back(std::sqrt(square));
  }
  return result;
}

/// As few of its points as one gets by walking along it, such that every point has one within epsilon times its feature
/// size.
std::vector<Point_2> epsilon_sample(const Dense_curve& curve, double epsilon, int start) {
  const int count = static_cast<int>(curve.points.size());
  const auto is_covered = [&](int first, int last) {
    for (int k = first; k <= last; ++k) {
      const Point_2& p = curve.points[k % count];
      const double nearest =
          std::min(distance(p, curve.points[first % count]), distance(p, curve.points[last % count]));
      if (nearest > epsilon * curve.feature_size[k % count]) return false;
    }
    return true;
  };
  std::vector<Point_2> result;
  for (int i = start; i < start + count;) {
    result.push_back(curve.points[i % count]);
    int next = i + 1;
    while (next < start + count && is_covered(i, next + 1)) ++next;
    i = next;
  }
  return result;
}

struct Named_curve {
  const char* name;
  std::function<Point_2(double)> point;
};

std::vector<Named_curve> smooth_curves() {
  return {
      {"ellipse",
       [](double t) {
         return Point_2{2 * std::cos(t), std::sin(t)};
       }},
      {"long ellipse",
       [](double t) {
         return Point_2{5 * std::cos(t), std::sin(t)};
       }},
      {"flower",
       [](double t) {
         const double r = 1 + 0.3 * std::cos(5 * t);
         return Point_2{r * std::cos(t), r * std::sin(t)};
       }},
      {"deep flower",
       [](double t) {
         const double r = 1 + 0.6 * std::cos(3 * t);
         return Point_2{r * std::cos(t), r * std::sin(t)};
       }},
      {"without symmetry",
       [](double t) {
         const double r = 1 + 0.2 * std::cos(2 * t + 1) + 0.15 * std::sin(3 * t) + 0.08 * std::cos(7 * t + 2);
         return Point_2{1.5 * r * std::cos(t), r * std::sin(t)};
       }},
  };
}

struct General_axis {
  std::shared_ptr<const Union_boundary_2> boundary;
  Union_medial_axis_2 axis;
};
General_axis general_axis(const Balls_2& balls, bool complete_only) {
  Progress progress;
  const auto boundary =
      std::make_shared<const Union_boundary_2>(union_boundary(std::make_shared<const Balls_2>(balls), 0, progress));
  return {boundary, union_medial_axis(union_voronoi(boundary, progress), complete_only, progress)};
}

TEST(Union_theorems_2, vertices_of_the_union_of_inner_voronoi_disks_are_samples) {
  for (const Named_curve& curve : smooth_curves()) {
    const Dense_curve dense = dense_curve(curve.point, 3000);
    for (const auto& [epsilon, start] : std::vector<std::pair<double, int>>{{0.23, 0}, {0.23, 97}, {0.1, 11}}) {
      SCOPED_TRACE(curve.name);
      SCOPED_TRACE(epsilon);
      const std::vector<Point_2> samples = epsilon_sample(dense, epsilon, start);
      const Balls_2 balls = inner_voronoi_disks(samples).circumscribed.balls;
      const General_axis general = general_axis(balls, false);
      // All of them but those on one circle only: the middle ones of three at the end of a branch.
      std::vector<int> circles(samples.size(), 0);
      for (const int contact : balls.contacts) ++circles[contact];
      std::vector<int> expected;
      for (std::size_t i = 0; i < samples.size(); ++i)
        if (circles[i] > 1) expected.push_back(static_cast<int>(i));
      std::vector<int> found = general.boundary->samples;
      std::ranges::sort(found);
      EXPECT_EQ(found, expected);
      EXPECT_GT(expected.size(), samples.size() / 2);
      // Arcs go along the curve.
      const int count = static_cast<int>(samples.size());
      for (const Boundary_arc& arc : general.boundary->arcs) {
        ASSERT_GE(arc.from, 0);
        const int steps = (general.boundary->samples[arc.to] - general.boundary->samples[arc.from] + count) % count;
        EXPECT_GE(steps, 1);
        for (int i = 1; i < steps; ++i) EXPECT_EQ(circles[(general.boundary->samples[arc.from] + i) % count], 1);
      }
      EXPECT_EQ(general.boundary->arcs.size(), expected.size());
    }
  }
}

/// Two disks of the union by their numbers, and the two samples the edge lies between.
using Described_edge = std::tuple<Edge, Edge>;

TEST(Union_theorems_2, inner_voronoi_edges_are_the_medial_axis_of_the_union) {
  for (const Named_curve& curve : smooth_curves()) {
    const Dense_curve dense = dense_curve(curve.point, 3000);
    for (const double epsilon : {0.23, 0.12}) {
      SCOPED_TRACE(curve.name);
      SCOPED_TRACE(epsilon);
      const std::vector<Point_2> samples = epsilon_sample(dense, epsilon, 5);
      const Sampled_shape shape = inner_voronoi_disks(samples);
      Progress progress;
      const Medial_axis_2 special = medial_axis(shape.triangulation, shape.voronoi, {shape.is_inner, {}}, progress);
      const auto ball = [&](int i) { return shape.circumscribed.ball_of_triangle[special.triangles[i]]; };
      std::set<Described_edge> expected;
      std::map<int, int> degree;
      for (std::size_t e = 0; e < special.edges.size(); ++e) {
        const auto [a, b] = special.edges[e];
        // Triangles with one circle are one disk.
        if (ball(a) == ball(b)) continue;
        expected.insert({sorted_edge({ball(a), ball(b)}), sorted_edge(special.contacts[e])});
        ++degree[ball(a)];
        ++degree[ball(b)];
      }
      const General_axis general = general_axis(shape.circumscribed.balls, false);
      const auto& axis = general.axis;
      std::set<Described_edge> found;
      for (std::size_t e = 0; e < axis.edges.size(); ++e) {
        const auto [a, b] = axis.edges[e];
        const auto [v, w] = axis.contacts[e];
        found.insert({sorted_edge({axis.balls[a], axis.balls[b]}),
                      sorted_edge({general.boundary->samples[v], general.boundary->samples[w]})});
        // The sample in the middle of the end of a branch is no vertex: there the Voronoi edge of the others goes on.
        const bool is_end = degree[axis.balls[a]] == 1 || degree[axis.balls[b]] == 1;
        EXPECT_EQ(axis.kinds[e], is_end ? Axis_edge_kind::incomplete : Axis_edge_kind::complete);
      }
      EXPECT_EQ(found, expected);
      EXPECT_EQ(axis.edges.size(), expected.size());
      std::vector<int> balls = axis.balls;
      std::ranges::sort(balls);
      std::vector<int> all(shape.circumscribed.balls.size());
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
      EXPECT_EQ(balls, all);
      for (std::size_t m = 0; m < axis.centers.size(); ++m) {
        ASSERT_GE(axis.balls[m], 0);
        const int t = shape.circumscribed.triangles[axis.balls[m]];
        EXPECT_NEAR(distance(axis.centers[m], shape.voronoi.vertices[t]), 0, 1e-9);
        EXPECT_NEAR(axis.radii[m], shape.voronoi.radii[t], 1e-9);
      }
    }
  }
}

TEST(Union_theorems_2, fail_for_coarse_samples) {
  // Two fingers, hardly sampled: the disk at the end of each bulges over the gap, where it meets the other.
  const Outline_2 fingers{{{{0, 0}, {9, 0}, {9, 10}, {5, 10}, {5, 2}, {4, 2}, {4, 10}, {0, 10}}}};
  const Sampled_shape shape = inner_voronoi_disks(fingers.rings[0], fingers);
  const General_axis general = general_axis(shape.circumscribed.balls, false);
  EXPECT_NE(std::ranges::count(general.boundary->samples, -1), 0);
}

/// By columns, each measured as a union of intervals.
double area_by_columns(const Balls_2& balls, const Box& box, int columns) {
  double area = 0;
  const double width = (box.upper.x - box.lower.x) / columns;
  for (int column = 0; column < columns; ++column) {
    const double x = box.lower.x + (column + 0.5) * width;
    std::vector<std::pair<double, double>> intervals;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const double dx = x - balls.centers[i].x;
      if (std::abs(dx) >= balls.radii[i]) continue;
      const double half = std::sqrt(balls.radii[i] * balls.radii[i] - dx * dx);
      intervals.emplace_back(balls.centers[i].y - half, balls.centers[i].y + half);
    }
    std::ranges::sort(intervals);
    double reached = -std::numeric_limits<double>::infinity();
    for (const auto& [low, high] : intervals) {
      if (high <= reached) continue;
      area += width * (high - std::max(low, reached));
      reached = high;
    }
  }
  return area;
}

double area_by_arcs(const Union_boundary_2& boundary) {
  const Balls_2& balls = *boundary.dual->regular->balls;
  double result = 0;
  for (const auto& [ball, from, to] : boundary.arcs) {
    const Point_2& c = balls.centers[ball];
    const double r = boundary.radii[ball];
    if (from == to) {
      result += std::numbers::pi * r * r;
      continue;
    }
    const Point_2& p = boundary.vertices[from];
    const Point_2& q = boundary.vertices[to];
    double sweep = std::atan2(q.y - c.y, q.x - c.x) - std::atan2(p.y - c.y, p.x - c.x);
    if (sweep < 0) sweep += 2 * std::numbers::pi;
    result += (r * r * sweep + c.x * (q.y - p.y) - c.y * (q.x - p.x)) / 2;
  }
  return result;
}

std::array<std::int64_t, 2> betti_of_graph(std::size_t vertices, const std::vector<Edge>& edges) {
  std::vector<int> parent(vertices);
  for (std::size_t i = 0; i < vertices; ++i) parent[i] = static_cast<int>(i);
  const auto root = [&](int a) {
    while (parent[a] != a) a = parent[a] = parent[parent[a]];
    return a;
  };
  auto components = static_cast<std::int64_t>(vertices);
  for (const auto& [a, b] : edges) {
    if (root(a) == root(b)) continue;
    parent[root(a)] = root(b);
    --components;
  }
  return {components, static_cast<std::int64_t>(edges.size() + components - vertices)};
}

void expect_same_topology(const Balls_2& balls) {
  ASSERT_GT(balls.size(), 0U);
  for (const bool complete_only : {false, true}) {
    const General_axis general = general_axis(balls, complete_only);
    const Topology dual = topology(*general.boundary->dual);
    const auto betti = betti_of_graph(general.axis.centers.size(), general.axis.edges);
    EXPECT_EQ(betti[0], dual.betti[0]);
    EXPECT_EQ(betti[1], dual.betti[1]);
  }
}

/// Too many disks for the oracle: the parts must agree with each other, and the area with that of the disks.
void expect_agreement(const Balls_2& balls) {
  expect_same_topology(balls);
  const General_axis general = general_axis(balls, false);
  Box box;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    box.add(Point_2{balls.centers[i].x - balls.radii[i], balls.centers[i].y - balls.radii[i]});
    box.add(Point_2{balls.centers[i].x + balls.radii[i], balls.centers[i].y + balls.radii[i]});
  }
  const double area = area_by_arcs(*general.boundary);
  EXPECT_NEAR(area, area_by_columns(balls, box, 2000), 2e-3 * area);
  // No two vertices are one.
  std::set<std::pair<double, double>> places;
  for (const Point_2& p : general.boundary->vertices) EXPECT_TRUE(places.emplace(p.x, p.y).second);
}

const std::vector<std::string> shape_names{"bat",     "cad_wrench", "denmark", "giraffe",
                                           "glyph_8", "glyph_amp",  "sym_gear"};

Balls_2 balls_of_shape(const std::string& name) {
  for (const auto& file : planar_files("wkt")) {
    if (file.stem() != name) continue;
    const Outline_2 outline = outline_of(file);
    return inner_voronoi_disks(vertices_of(outline), outline).circumscribed.balls;
  }
  throw std::invalid_argument(name);
}

TEST(Union_of_real_shapes_2, agrees_with_itself) {
  MESECINA_NEED_DATA();
  for (const std::string& name : shape_names) {
    SCOPED_TRACE(name);
    const Balls_2 balls = balls_of_shape(name);
    expect_agreement(balls);
    for (const double factor : {1.0000001, 1.05, 1.3}) {
      SCOPED_TRACE(factor);
      expect_agreement(grown(balls, factor));
    }
  }
}

/// As after saving and loading: many circles nearly through one point, and nothing known of it.
TEST(Union_of_real_shapes_2, agrees_with_itself_when_rounded) {
  MESECINA_NEED_DATA();
  for (const std::string& name : shape_names) {
    SCOPED_TRACE(name);
    const Balls_2 balls = balls_of_shape(name);
    std::vector<Disk_2> disks;
    for (std::size_t i = 0; i < balls.size(); ++i) disks.push_back({balls.centers[i], balls.radii[i]});
    expect_same_topology(given_balls(disks));
  }
}

TEST(Union_of_real_shapes_2, agrees_with_itself_for_points) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("xy")) {
    SCOPED_TRACE(file.filename());
    expect_agreement(inner_voronoi_disks(points_of(file)).circumscribed.balls);
  }
}

}  // namespace
}  // namespace mesecina::test
