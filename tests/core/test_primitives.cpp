// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/primitives.h"
#include "core/style.h"

namespace mesecina {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One element or two of each kind; vertex v lies at (v, 10 v).
Primitive_set all_kinds() {
  Primitive_set set;
  for (int v = 0; v < 12; ++v) set.vertices.push_back({1.0 * v, 10.0 * v, 0});
  set.points = {11, 3};
  set.segments = {{0, 1}, {1, 2}};
  set.rays = {{5, {0, 1, 0}}};
  set.arcs = {{{1, 1}, 2, 4, 6, false}};
  set.triangles = {{0, 1, 2}, {7, 8, 9}};
  set.polygon_offsets = {0, 3, 7};
  set.polygon_vertices = {0, 2, 4, 6, 7, 8, 9};
  set.balls = {{10, 0.5}, {2, 1.5}};
  set.values.push_back({"angle", "degrees", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, infinity, 11}});
  return set;
}

std::vector<bool> only(std::initializer_list<int> elements) {
  std::vector<bool> keep(12, false);
  for (const int element : elements) keep[element] = true;
  return keep;
}

TEST(Primitive_set, counts_elements_in_their_fixed_order) {
  const Primitive_set set = all_kinds();
  EXPECT_EQ(set.element_count(), 12U);
  EXPECT_EQ(set.polygon_count(), 2U);
  EXPECT_EQ(set.polygon(1).size(), 4U);
  EXPECT_EQ(set.id(7), 7);
  EXPECT_EQ(set.find_values("angle")->data.size(), 12U);
  EXPECT_EQ(set.find_values("lambda"), nullptr);
  EXPECT_TRUE(Primitive_set{}.is_empty());
}

TEST(Select, keeps_elements_with_their_vertices_values_and_ids) {
  const Primitive_set set = all_kinds();
  // The second point, the arc, the second triangle, the first polygon and the second ball.
  const Primitive_set result = select(set, only({1, 5, 7, 8, 11}));
  EXPECT_EQ(result.element_count(), 5U);
  std::vector<double> xs;
  for (const Point_3& p : result.vertices) xs.push_back(p.x);
  EXPECT_EQ(xs, (std::vector<double>{0, 2, 3, 4, 6, 7, 8, 9}));
  const auto x = [&](int vertex) { return result.vertices.at(vertex).x; };
  ASSERT_EQ(result.points.size(), 1U);
  EXPECT_EQ(x(result.points[0]), 3);
  EXPECT_TRUE(result.segments.empty());
  EXPECT_TRUE(result.rays.empty());
  ASSERT_EQ(result.arcs.size(), 1U);
  EXPECT_EQ(x(result.arcs[0].from), 4);
  EXPECT_EQ(x(result.arcs[0].to), 6);
  EXPECT_EQ(result.arcs[0].radius, 2);
  EXPECT_FALSE(result.arcs[0].counterclockwise);
  ASSERT_EQ(result.triangles.size(), 1U);
  EXPECT_EQ(x(result.triangles[0][2]), 9);
  ASSERT_EQ(result.polygon_count(), 1U);
  EXPECT_EQ(x(result.polygon(0)[2]), 4);
  ASSERT_EQ(result.balls.size(), 1U);
  EXPECT_EQ(x(result.balls[0].center), 2);
  EXPECT_EQ(result.balls[0].radius, 1.5);
  EXPECT_EQ(result.values.at(0).data, (std::vector<double>{1, 5, 7, 8, 11}));
  EXPECT_EQ(result.values[0].unit, "degrees");
  EXPECT_EQ(result.ids, (std::vector<std::int64_t>{1, 5, 7, 8, 11}));
}

TEST(Select, of_a_selection_keeps_the_first_ids) {
  const Primitive_set once = select(all_kinds(), only({1, 5, 7, 8, 11}));
  const Primitive_set twice = select(once, {false, true, false, false, true});
  EXPECT_EQ(twice.ids, (std::vector<std::int64_t>{5, 11}));
  EXPECT_TRUE(select(all_kinds(), std::vector<bool>(12, false)).is_empty());
  EXPECT_TRUE(select(all_kinds(), std::vector<bool>(12, false)).vertices.empty());
}

TEST(Apply_cut, keeps_values_of_at_least_the_minimum) {
  const Primitive_set set = all_kinds();
  EXPECT_EQ(apply_cut(set, {"angle", 9}).ids, (std::vector<std::int64_t>{9, 10, 11}));
  EXPECT_EQ(apply_cut(set, {"angle", infinity}).ids, (std::vector<std::int64_t>{10}));
  EXPECT_EQ(apply_cut(set, {"angle", -infinity}).element_count(), 12U);
  EXPECT_EQ(apply_cut(set, {"lambda", 5}).element_count(), 12U);
}

Primitive_set complex_of(int vertex_count) {
  Primitive_set set;
  set.is_complex = true;
  set.vertices.resize(vertex_count);
  return set;
}

void expect_topology(const Primitive_set& set, std::int64_t euler, std::int64_t components, std::int64_t holes) {
  const std::optional<Topology> result = topology(set);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->euler, euler);
  EXPECT_EQ(result->betti, (std::array<std::int64_t, 3>{components, holes, 0}));
}

TEST(Topology, of_small_complexes) {
  expect_topology(complex_of(0), 0, 0, 0);
  // Vertices that nothing uses do not belong to the complex.
  expect_topology(complex_of(5), 0, 0, 0);
  Primitive_set points = complex_of(5);
  points.points = {0, 2, 4};
  expect_topology(points, 3, 3, 0);
  Primitive_set tree = complex_of(5);
  tree.segments = {{0, 1}, {1, 2}, {1, 3}, {4, 3}};
  expect_topology(tree, 1, 1, 0);
  Primitive_set cycle = complex_of(4);
  cycle.segments = {{0, 1}, {2, 1}, {2, 3}, {3, 0}};
  expect_topology(cycle, 0, 1, 1);
  cycle.points = {0, 3};
  expect_topology(cycle, 0, 1, 1);
  Primitive_set two_triangles = complex_of(4);
  two_triangles.triangles = {{0, 1, 2}, {2, 1, 3}};
  expect_topology(two_triangles, 1, 1, 0);
  two_triangles.segments = {{1, 2}, {0, 1}};  // already there
  expect_topology(two_triangles, 1, 1, 0);
  two_triangles.segments = {{0, 3}};
  expect_topology(two_triangles, 0, 1, 1);
  Primitive_set ring = complex_of(6);
  ring.triangles = {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4}, {2, 0, 5}, {0, 3, 5}};
  expect_topology(ring, 0, 1, 1);
  Primitive_set mixed = complex_of(9);
  mixed.points = {8};
  mixed.segments = {{0, 1}, {1, 2}, {2, 0}};
  mixed.triangles = {{3, 4, 5}, {5, 6, 7}};
  expect_topology(mixed, 2, 3, 1);
}

TEST(Topology, counts_arcs_as_edges) {
  // Two crossing disks: a closed curve of two arcs between the same vertices.
  Primitive_set lens = complex_of(2);
  lens.arcs = {{{0, 0}, 1, 0, 1, true}, {{1, 0}, 1, 1, 0, true}};
  expect_topology(lens, 0, 1, 1);
  lens.arcs.push_back({{2, 0}, 1, 0, 1, false});
  expect_topology(lens, -1, 1, 2);
  Primitive_set circle = complex_of(3);
  circle.arcs = {{{0, 0}, 1, 1, 1, true}};
  expect_topology(circle, 0, 1, 1);
  circle.arcs.push_back({{3, 0}, 2, 1, 1, false});  // touches the first
  expect_topology(circle, -1, 1, 2);
  circle.arcs.push_back({{9, 0}, 2, 2, 2, true});
  expect_topology(circle, -1, 2, 3);
  Primitive_set open = complex_of(4);
  open.arcs = {{{0, 0}, 1, 0, 1, true}, {{0, 0}, 1, 3, 2, true}};
  expect_topology(open, 2, 2, 0);
  // Beside a segment, and beside the edges of a triangle, an arc is an edge of its own.
  Primitive_set mixed = complex_of(3);
  mixed.arcs = {{{0, 0}, 1, 0, 1, true}};
  mixed.segments = {{0, 1}};
  expect_topology(mixed, 0, 1, 1);
  mixed.triangles = {{0, 1, 2}};
  expect_topology(mixed, 0, 1, 1);
}

TEST(Topology, is_absent_for_what_is_no_complex) {
  Primitive_set set = complex_of(3);
  set.segments = {{0, 1}};
  EXPECT_TRUE(topology(set));
  set.balls = {{0, 1}};
  EXPECT_FALSE(topology(set));
  set.balls.clear();
  set.rays = {{0, {1, 0, 0}}};
  EXPECT_FALSE(topology(set));
  set.rays.clear();
  set.is_complex = false;
  EXPECT_FALSE(topology(set));
}

TEST(Drawn_elements, follow_the_cut_and_the_thresholds) {
  Scene_layer layer;
  EXPECT_TRUE(drawn_elements(layer).empty());
  Primitive_set set;
  set.vertices.resize(4);
  set.points = {0, 1, 2, 3};
  set.values = {{"angle", "", {1, 2, 3, infinity}}, {"lambda", "", {9, 1, 5, 1}}};
  layer.primitives = std::make_shared<Primitive_set>(set);
  EXPECT_TRUE(drawn_elements(layer).empty());
  layer.cut = Cut{"angle", 2};
  EXPECT_EQ(drawn_elements(layer), (std::vector{false, true, true, true}));
  layer.style.value = "lambda";
  EXPECT_EQ(drawn_elements(layer), (std::vector{false, true, true, true}));
  layer.style.threshold_minimum = 2;
  EXPECT_EQ(drawn_elements(layer), (std::vector{false, false, true, false}));
  layer.cut.reset();
  EXPECT_EQ(drawn_elements(layer), (std::vector{true, false, true, false}));
  layer.style.threshold_minimum.reset();
  layer.style.threshold_maximum = 5;
  EXPECT_EQ(drawn_elements(layer), (std::vector{false, true, true, true}));
  layer.style.value = "angle";
  EXPECT_EQ(drawn_elements(layer), (std::vector{true, true, true, false}));
  layer.style.value = "nothing";
  EXPECT_TRUE(drawn_elements(layer).empty());
}

TEST(Fit_view, shows_the_box_with_a_margin_of_five_percent) {
  Box box;
  box.add(Point_2{-10, 5});
  box.add(Point_2{10, 15});
  const View_2 view = fit_view(box, 400, 400);
  EXPECT_EQ(view.center, (Point_2{0, 10}));
  EXPECT_DOUBLE_EQ(view.to_pixel({-10, 10}, 400, 400).x, 20);
  EXPECT_DOUBLE_EQ(view.to_pixel({10, 10}, 400, 400).x, 380);
  EXPECT_GT(view.to_pixel({0, 5}, 400, 400).y, view.to_pixel({0, 15}, 400, 400).y);
  const View_2 wide = fit_view(box, 4000, 100);
  EXPECT_DOUBLE_EQ(wide.to_pixel({0, 15}, 4000, 100).y, 5);
  const Point_2 there_and_back = view.to_plane(view.to_pixel({1.25, 7.5}, 400, 400), 400, 400);
  EXPECT_NEAR(there_and_back.x, 1.25, 1e-12);
  EXPECT_NEAR(there_and_back.y, 7.5, 1e-12);
}

TEST(Fit_view, of_no_box_or_a_point_is_sensible) {
  Box point;
  point.add(Point_2{1e9, -3});
  Box segment;
  segment.add(Point_2{2, 2});
  segment.add(Point_2{2, 8});
  for (const Box& box : {Box{}, point, segment}) {
    const View_2 view = fit_view(box, 640, 480);
    EXPECT_TRUE(std::isfinite(view.scale));
    EXPECT_GT(view.scale, 0);
  }
  EXPECT_EQ(fit_view(point, 640, 480).center, (Point_2{1e9, -3}));
  EXPECT_DOUBLE_EQ(fit_view(segment, 640, 480).scale, 72);
}

TEST(Bounding_box, of_an_arc_is_that_of_what_is_drawn) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(0, 2 * M_PI);
  const auto expect_tight = [](double from, double to, bool counterclockwise) {
    const Point_2 center{3, -2};
    const double radius = 5;
    const auto at = [&](double t) {
      return Point_3{center.x + radius * std::cos(t), center.y + radius * std::sin(t), 0};
    };
    Primitive_set set;
    set.vertices = {at(from), at(to)};
    set.arcs = {{center, radius, 0, 1, counterclockwise}};
    double sweep = to - from;
    while (counterclockwise && sweep < 0) sweep += 2 * M_PI;
    while (!counterclockwise && sweep > 0) sweep -= 2 * M_PI;
    Box walked;
    for (int i = 0; i <= 20000; ++i) walked.add(at(from + sweep * i / 20000));
    const Box box = bounding_box(set, set.arcs[0]);
    for (const auto side : {&Point_3::x, &Point_3::y}) {
      EXPECT_NEAR(box.lower.*side, walked.lower.*side, 1e-6) << from << " to " << to;
      EXPECT_NEAR(box.upper.*side, walked.upper.*side, 1e-6) << from << " to " << to;
    }
    EXPECT_EQ(set.bounding_box().lower, box.lower);
    EXPECT_EQ(set.bounding_box().upper, box.upper);
  };
  for (const bool counterclockwise : {true, false}) {
    for (int i = 0; i < 200; ++i) expect_tight(angle(random), angle(random), counterclockwise);
    for (const double from : {0.3, M_PI / 4, 3.0})
      for (const double sweep : {M_PI / 2, M_PI, 3 * M_PI / 2, 1e-3, 2 * M_PI - 1e-3})
        expect_tight(from, from + sweep, counterclockwise);
  }
}

TEST(Bounding_box, of_a_whole_circle_and_of_none) {
  Primitive_set set;
  set.vertices = {{4, 0, 0}, {4, 0, 0}};
  set.arcs = {{{1, 0}, 3, 0, 0, false}};
  EXPECT_EQ(set.bounding_box().lower, (Point_3{-2, -3, 0}));
  EXPECT_EQ(set.bounding_box().upper, (Point_3{4, 3, 0}));
  set.arcs[0].to = 1;  // two vertices in one place: no length
  EXPECT_EQ(set.bounding_box().lower, (Point_3{4, 0, 0}));
  EXPECT_EQ(set.bounding_box().upper, (Point_3{4, 0, 0}));
}

TEST(Bounding_box, of_primitives_and_inputs) {
  Primitive_set set;
  set.vertices = {{1, 2, 0}};
  set.balls = {{0, 3}};
  EXPECT_EQ(set.bounding_box().lower, (Point_3{-2, -1, 0}));
  EXPECT_EQ(set.bounding_box().upper, (Point_3{4, 5, 0}));
  const Inputs inputs = Inputs{}
                            .with(points_input, std::vector<Point_2>{{0, 0}})
                            .with(disks_input, std::vector<Disk_2>{{{5, 0}, 2}})
                            .with(outline_input, Outline_2{{{{1, 9}, {2, 2}, {3, 3}}}});
  EXPECT_EQ(bounding_box(inputs).lower, (Point_3{0, -2, 0}));
  EXPECT_EQ(bounding_box(inputs).upper, (Point_3{7, 9, 0}));
  EXPECT_TRUE(bounding_box(Inputs{}).is_empty());
}

}  // namespace
}  // namespace mesecina
