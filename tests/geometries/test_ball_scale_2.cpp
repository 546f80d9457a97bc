// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/graph.h"
#include "geometries/medial_filtrations_2/ball_scale_2.h"
#include "geometries/modules_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"

/// Shapes whose samples are cocircular by the hundred, exactly or but for rounding.
namespace mesecina::test {
namespace {

/// Where radii are equal but for rounding the quotient is anything from here on.
constexpr double practically_infinite = 1e5;

struct State {
  Delaunay_2 triangulation;
  Medial_axis_2 axis;

  void find_axis() {
    Progress progress;
    const Labels_2 labels = flood_labels(triangulation, one_step_crust(triangulation, progress), progress);
    axis = medial_axis(triangulation, voronoi(triangulation, progress), labels, progress);
  }
};

State state_of(std::span<const Point_2> points) {
  Progress progress;
  State state{delaunay(points, progress), {}};
  state.find_axis();
  return state;
}

std::vector<double> scale_of(const State& state) {
  Progress progress;
  return ball_scale(state.triangulation, state.axis, progress).values;
}

/// The definition on the circles of the triangles in rational arithmetic, where nothing but the roots is rounded.
std::vector<double> scale_by_rationals(const State& state) {
  struct Exact_disk {
    Exact_point center;
    Rational squared_radius;
  };
  std::vector<Exact_disk> disks;
  for (const int t : state.axis.triangles) {
    const auto& [a, b, c] = state.triangulation.triangles[t];
    const Point_2& p = state.triangulation.points[a];
    const Exact_point center = exact_circumcenter(p, state.triangulation.points[b], state.triangulation.points[c]);
    const Rational dx = center.x - exact(p).x;
    const Rational dy = center.y - exact(p).y;
    disks.push_back({center, dx * dx + dy * dy});
  }
  const auto root = [](const Rational& square) { return std::sqrt(CGAL::to_double(square)); };
  std::vector<double> result(disks.size(), infinity);
  for (std::size_t i = 0; i < disks.size(); ++i) {
    for (const Exact_disk& larger : disks) {
      if (!(larger.squared_radius > disks[i].squared_radius)) continue;
      const Rational dx = larger.center.x - disks[i].center.x;
      const Rational dy = larger.center.y - disks[i].center.y;
      const Rational growth = larger.squared_radius - disks[i].squared_radius;
      const double radii = root(disks[i].squared_radius) + root(larger.squared_radius);
      result[i] = std::min(result[i], root(dx * dx + dy * dy) * radii / CGAL::to_double(growth));
    }
  }
  return result;
}

void expect_scale_by_definition(const std::vector<Point_2>& points) {
  const State state = state_of(points);
  const std::vector<double> found = scale_of(state);
  const std::vector<double> expected = scale_by_rationals(state);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t b = 0; b < found.size(); ++b) {
    const Point_2& c = state.axis.centers[b];
    if (expected[b] > practically_infinite) {
      EXPECT_GT(found[b], practically_infinite) << "ball at " << c.x << " " << c.y;
    } else {
      EXPECT_NEAR(found[b], expected[b], 1e-8 * expected[b]) << "ball at " << c.x << " " << c.y;
    }
  }
}

std::vector<Point_2> turned(std::vector<Point_2> points, double angle) {
  for (Point_2& p : points)
    p = {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
  return points;
}

/// Samples on the outline in steps of about `step`, each side evenly.
std::vector<Point_2> samples_on(const std::vector<Point_2>& corners, double step) {
  std::vector<Point_2> points;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point_2& from = corners[i];
    const Point_2& to = corners[(i + 1) % corners.size()];
    const int count = static_cast<int>(std::lround(distance(from, to) / step));
    for (int k = 0; k < count; ++k)
      points.push_back({from.x + (to.x - from.x) * k / count, from.y + (to.y - from.y) * k / count});
  }
  return points;
}

const std::vector<Point_2> square_on_bar = {{0, 0}, {34, 0}, {34, 8}, {24, 8}, {24, 22}, {10, 22}, {10, 8}, {0, 8}};
const std::vector<Point_2> plus = {{6, 0},   {12, 0}, {12, 6}, {18, 6}, {18, 12}, {12, 12},
                                   {12, 18}, {6, 18}, {6, 12}, {0, 12}, {0, 6},   {6, 6}};

std::vector<Named_points> cocircular_shapes() {
  return {{"square", rectangle_samples({14, 14}, 1)},
          {"rectangle", rectangle_samples({16, 9}, 1)},
          {"rectangle with steps of two sizes", rectangle_samples({16, 9.3}, 1)},
          {"corridor", rectangle_samples({40, 3}, 0.5)},
          {"square on a bar", samples_on(square_on_bar, 1)},
          {"plus", samples_on(plus, 1)},
          {"decimal square", rectangle_samples({14, 14}, 0.7)},
          {"decimal square on a bar", samples_on(square_on_bar, 0.7)}};
}

TEST(Ball_scale_2, equals_the_definition_of_cocircular_samples) {
  for (const auto& [name, points] : cocircular_shapes()) {
    SCOPED_TRACE(name);
    expect_scale_by_definition(points);
  }
}

TEST(Ball_scale_2, equals_the_definition_of_samples_that_rounding_keeps_from_being_cocircular) {
  for (const auto& [name, points] : cocircular_shapes()) {
    for (const double angle : {0.1, 0.7, 2.0}) {
      SCOPED_TRACE(testing::Message() << name << " turned by " << angle);
      expect_scale_by_definition(turned(points, angle));
    }
  }
}

TEST(Ball_scale_2, equals_the_definition_on_smooth_and_noisy_curves) {
  expect_scale_by_definition(flower(150, 0.3, 5, 0.8, 3));
  expect_scale_by_definition(ellipse(2, 1, 120, 0.5, 3));
  expect_scale_by_definition(ellipse(1, 1, 60));
  for (std::uint64_t seed = 0; seed < 4; ++seed) expect_scale_by_definition(noisy_curve(100, 0.05, seed));
}

TEST(Ball_scale_2, of_a_square_is_at_least_the_square_root_of_two) {
  for (const double step : {1.0, 0.7, 0.14}) {
    for (const double angle : {0.0, 0.3, 1.1}) {
      SCOPED_TRACE(testing::Message() << "step " << step << ", turned by " << angle);
      const State state = state_of(turned(rectangle_samples({14, 14}, step), angle));
      ASSERT_GT(state.axis.centers.size(), 10U);
      for (const double value : scale_of(state)) EXPECT_GT(value, (1 - 1e-8) * std::sqrt(2));
    }
  }
}

TEST(Ball_scale_2, is_symmetric_where_the_shape_is) {
  for (const auto& [name, corners] : {Named_points{"square on a bar", square_on_bar}, Named_points{"plus", plus}}) {
    SCOPED_TRACE(name);
    const State state = state_of(samples_on(corners, 1));
    const std::vector<double> scale = scale_of(state);
    double width = 0;
    for (const Point_2& p : corners) width = std::max(width, p.x);
    for (std::size_t b = 0; b < scale.size(); ++b) {
      const Point_2 mirrored{width - state.axis.centers[b].x, state.axis.centers[b].y};
      const auto other = std::ranges::min_element(state.axis.centers, {},
                                                  [&](const Point_2& center) { return distance(center, mirrored); });
      ASSERT_LT(distance(*other, mirrored), 1e-9);
      const double value = std::min(scale[b], practically_infinite);
      EXPECT_NEAR(std::min(scale[other - state.axis.centers.begin()], practically_infinite), value, 1e-9 * value)
          << mirrored.x << " " << mirrored.y;
    }
  }
}

TEST(Ball_scale_2, updates_to_what_it_is_afresh) {
  Progress progress;
  bool has_updated = false;
  for (const auto& [name, start] : cocircular_shapes()) {
    SCOPED_TRACE(name);
    Random random(5);
    std::vector<Point_2> points = start;
    State state = state_of(points);
    Ball_scale_2 current = ball_scale(state.triangulation, state.axis, progress);
    for (int step = 0; step < 60; ++step) {
      const int i = random.index(static_cast<int>(points.size()));
      // Back to its place, along its side, onto the circle of others, or anywhere.
      const int kind = random.index(4);
      if (kind == 0) points = start;
      if (kind == 1) points[i] = midpoint(points[i], points[(i + 1) % points.size()]);
      if (kind == 2) points[i] = {std::round(points[i].x + random.uniform(-1, 1)), std::round(points[i].y)};
      if (kind == 3) points[i] = {points[i].x + random.uniform(-0.1, 0.1), points[i].y};
      has_updated = update(state.triangulation, points, progress) || has_updated;
      state.find_axis();
      current = update_ball_scale(current, state.triangulation, state.axis, progress);
      ASSERT_EQ(current.values, ball_scale(state.triangulation, state.axis, progress).values) << "step " << step;
    }
  }
  EXPECT_TRUE(has_updated);
}

TEST(Ball_scale_2, updates_what_touches_further_samples_only) {
  Progress progress;
  const State state = state_of(rectangle_samples({14, 14}, 0.7));
  Ball_scale_2 other = ball_scale(state.triangulation, state.axis, progress);
  const std::vector<double> expected = other.values;
  // As if there had been more contacts on the same circles.
  other.slopes.assign(other.slopes.size(), 0.25);
  other.importance = scale_importance(other.centers, other.radii, other.slopes, progress);
  ASSERT_NE(other.importance.values, expected);
  EXPECT_EQ(update_ball_scale(other, state.triangulation, state.axis, progress).values, expected);
}

Primitive_set layer_of(Graph& graph, const char* id) {
  Progress progress;
  const Outcome<Primitive_set> layer = graph.layer(id, progress);
  EXPECT_TRUE(layer) << layer.reason;
  return layer ? *layer.value : Primitive_set();
}

TEST(Scale_medial_axis_layer, keeps_all_of_a_square_below_the_square_root_of_two) {
  Graph graph(make_registry_2());
  graph.set_inputs(Inputs().with(outline_input, Outline_2{{{{0, 0}, {14, 0}, {14, 14}, {0, 14}}}}));
  for (const double step : {0.05, 0.03, 0.02}) {
    graph.set_settings(Settings().with("sampling-step", step));
    const Primitive_set layer = layer_of(graph, "scale-medial-axis");
    ASSERT_GT(layer.segments.size(), 20U);
    for (const Values& values : layer.values)
      for (const double value : values.data) EXPECT_GT(value, (1 - 1e-8) * std::sqrt(2)) << values.name;
  }
}

TEST(Scale_medial_axis_layer, is_symmetric_at_every_limit) {
  Graph graph(make_registry_2());
  graph.set_inputs(Inputs().with(points_input, samples_on(square_on_bar, 1)));
  for (const char* id : {"scale-medial-axis", "angle-medial-axis", "lambda-medial-axis"}) {
    SCOPED_TRACE(id);
    const Primitive_set layer = layer_of(graph, id);
    ASSERT_GT(layer.segments.size(), 20U);
    const std::vector<double>& plain = layer.values.at(0).data;
    const auto middle = [&](std::size_t e) {
      const Point_3& a = layer.vertices[layer.segments[e][0]];
      const Point_3& b = layer.vertices[layer.segments[e][1]];
      return midpoint(Point_2{a.x, a.y}, Point_2{b.x, b.y});
    };
    for (std::size_t e = 0; e < layer.segments.size(); ++e) {
      const Point_2 mirrored{34 - middle(e).x, middle(e).y};
      std::size_t other = 0;
      for (std::size_t f = 0; f < layer.segments.size(); ++f)
        if (distance(middle(f), mirrored) < distance(middle(other), mirrored)) other = f;
      ASSERT_LT(distance(middle(other), mirrored), 1e-9);
      const double value = std::min(plain[e], practically_infinite);
      EXPECT_NEAR(std::min(plain[other], practically_infinite), value, 1e-6 * value) << mirrored.x << " " << mirrored.y;
      EXPECT_GE(layer.values.at(1).data[e], plain[e]);
    }
  }
}

}  // namespace
}  // namespace mesecina::test
