// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/union_3/ball_sets.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <sstream>

#include "tests/geometries/shapes.h"

namespace mesecina::test {

namespace {

using Balls = std::vector<Ball_3>;

testing::AssertionResult checked(const Balls_check& check, const Balls& balls) {
  try {
    return check(balls);
  } catch (const std::exception& exception) {
    return testing::AssertionFailure() << exception.what();
  }
}

/// Leaves out balls as long as the rest fails too.
Balls shrunk(Balls balls, const Balls_check& check) {
  for (std::size_t left_out = 0; left_out < balls.size() && balls.size() > 1;) {
    Balls rest = balls;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
    if (checked(check, rest)) {
      ++left_out;
    } else {
      balls = std::move(rest);
      left_out = 0;
    }
  }
  return balls;
}

void expect_of_family(const Ball_family& family, std::uint64_t seeds, const Balls_check& check) {
  std::uint64_t failures = 0;
  std::uint64_t seed_of_smallest = 0;
  Balls smallest;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const Balls balls = family.make(seed);
    if (checked(check, balls)) continue;
    ++failures;
    if (!smallest.empty() && smallest.size() <= balls.size()) continue;
    smallest = balls;
    seed_of_smallest = seed;
  }
  if (failures == 0) return;
  smallest = shrunk(smallest, check);
  ADD_FAILURE() << failures << " of " << seeds << " sets '" << family.name << "', for example a part of seed "
                << seed_of_smallest << ": " << checked(check, smallest).message() << "\n  " << to_text(smallest);
}

}  // namespace

void expect_of_balls(std::uint64_t seeds, const Balls_check& check) {
  expect_of_clear_balls(seeds, check);
  for (const Ball_family& family : ball_families())
    if (family.is_nearly_special) expect_of_family(family, seeds, check);
}

void expect_of_clear_balls(std::uint64_t seeds, const Balls_check& check) {
  for (const Named_balls& set : difficult_ball_sets())
    expect_of_family({set.name, [&set](std::uint64_t) { return set.balls; }}, 1, check);
  for (const Ball_family& family : ball_families())
    if (!family.is_nearly_special) expect_of_family(family, seeds, check);
}

std::vector<Named_balls> difficult_ball_sets() {
  const std::vector<Ball_3> tetrahedron{{{1, 1, 1}, 1.8}, {{1, -1, -1}, 1.8}, {{-1, 1, -1}, 1.8}, {{-1, -1, 1}, 1.8}};
  const auto with = [](Balls balls, const Balls& others) {
    balls.insert(balls.end(), others.begin(), others.end());
    return balls;
  };
  std::vector<Named_balls> result{
      {"one", {{{3, -1, 2}, 2}}, {1, 0, 0}},
      {"one point", {{{3, -1, 2}, 0}}, {1, 0, 0}},
      {"two apart", {{{0, 0, 0}, 1}, {{5, 0, 0}, 2}}, {2, 0, 0}},
      {"two touching", {{{0, 0, 0}, 1}, {{3, 0, 0}, 2}}, {1, 0, 0}},
      {"two crossing", {{{0, 0, 0}, 2}, {{3, 0, 0}, 2}}, {1, 0, 0}},
      {"two crossing, one center in the other", {{{0, 0, 0}, 5}, {{1, 0, 0}, 4.5}}, {1, 0, 0}},
      {"two touching from inside", {{{0, 0, 0}, 5}, {{3, 0, 0}, 2}}, {1, 0, 0}},
      {"two nested", {{{0, 0, 0}, 5}, {{1, 0, 0}, 2}}, {1, 0, 0}},
      {"two concentric", {{{0, 0, 0}, 5}, {{0, 0, 0}, 2}}, {1, 0, 0}},
      {"two equal", {{{1, 1, 1}, 2}, {{1, 1, 1}, 2}}, {1, 0, 0}},
      {"two equal points", {{{1, 1, 1}, 0}, {{1, 1, 1}, 0}}, {1, 0, 0}},
      {"three in a row", {{{0, 0, 0}, 2}, {{3, 0, 0}, 2}, {{6, 0, 0}, 2}}, {1, 0, 0}},
      {"three", {{{0, 0, 0}, 2}, {{3, 0, 0}, 2}, {{1, 2, 0}, 2}}, {1, 0, 0}},
      {"three around a hole", {{{0, 0, 0}, 2}, {{3.8, 0, 0}, 2}, {{1.9, 3.4, 0}, 2}}, {1, 1, 0}},
      {"three through a point, which they surround", {{{5, 0, 0}, 5}, {{-3, 4, 0}, 5}, {{-3, -4, 0}, 5}}, {1, 0, 0}},
      {"pencil through a circle", {{{-3, 0, 0}, 5}, {{0, 0, 0}, 4}, {{3, 0, 0}, 5}}, {1, 0, 0}},
      {"point where two spheres cross", {{{-3, 0, 0}, 5}, {{3, 0, 0}, 5}, {{0, 4, 0}, 0}}, {1, 0, 0}},
      {"three points there",
       {{{-3, 0, 0}, 5}, {{3, 0, 0}, 5}, {{0, 4, 0}, 0}, {{0, 0, 4}, 0}, {{0, -4, 0}, 0}},
       {1, 0, 0}},
      {"four", tetrahedron, {1, 0, 0}},
      {"four around a cavity",
       {{{1, 1, 1}, 1.7}, {{1, -1, -1}, 1.7}, {{-1, 1, -1}, 1.7}, {{-1, -1, 1}, 1.7}},
       {1, 0, 1}},
      {"four through a point, which they surround",
       {{{2, 2, 1}, 3}, {{-2, -1, 2}, 3}, {{1, -2, -2}, 3}, {{-2, 1, -2}, 3}},
       {1, 0, 0}},
      {"six through a point, which they surround",
       {{{5, 0, 0}, 5}, {{-5, 0, 0}, 5}, {{0, 5, 0}, 5}, {{0, -5, 0}, 5}, {{0, 0, 5}, 5}, {{0, 0, -5}, 5}},
       {1, 0, 0}},
      {"four through a point, on one side",
       {{{2, 1, 2}, 3}, {{-2, 1, 2}, 3}, {{2, -1, 2}, 3}, {{-2, -1, 2}, 3}},
       {1, 0, 0}},
      {"two parts touching in a point",
       {{{3, 4, 0}, 5}, {{4, 3, 0}, 5}, {{-3, -4, 0}, 5}, {{-4, -3, 0}, 5}},
       {1, 0, 0}},
      {"four around a tunnel, touching",
       {{{0, 0, 0}, 5}, {{10, 0, 0}, 5}, {{10, 10, 0}, 5}, {{0, 10, 0}, 5}},
       {1, 1, 0}},
      {"tetrahedron and a singular edge", with(tetrahedron, {{{2.5, 2.5, 2.5}, 1}}), {1, 0, 0}},
      {"tetrahedron and a singular triangle", with(tetrahedron, {{{3, 0, 0}, 1.2}}), {1, 0, 0}},
      {"two tetrahedra with a common ball",
       with(tetrahedron, {{{3, 3, 1}, 1.8}, {{3, 1, 3}, 1.8}, {{1, 3, 3}, 1.8}}),
       {1, 0, 0}},
      {"two tetrahedra with a common edge",
       {{{0, 0, 1}, 1.7},
        {{0, 0, -1}, 1.7},
        {{2, 1, 0}, 1.7},
        {{2, -1, 0}, 1.7},
        {{-2, 1, 0}, 1.7},
        {{-2, -1, 0}, 1.7}},
       {1, 0, 0}},
      {"chain of touching balls", {{{0, 0, 0}, 1}, {{2, 0, 0}, 1}, {{4, 0, 0}, 1}, {{6, 0, 0}, 1}}, {1, 0, 0}},
      {"cube of crossing balls",
       {{{0, 0, 0}, 2},
        {{2, 0, 0}, 2},
        {{0, 2, 0}, 2},
        {{2, 2, 0}, 2},
        {{0, 0, 2}, 2},
        {{2, 0, 2}, 2},
        {{0, 2, 2}, 2},
        {{2, 2, 2}, 2}},
       {1, 0, 0}},
      {"cube of balls around a cavity",
       {{{0, 0, 0}, 6},
        {{8, 0, 0}, 6},
        {{0, 8, 0}, 6},
        {{8, 8, 0}, 6},
        {{0, 0, 8}, 6},
        {{8, 0, 8}, 6},
        {{0, 8, 8}, 6},
        {{8, 8, 8}, 6}},
       {1, 0, 1}},
      {"cube of touching balls",
       {{{0, 0, 0}, 1},
        {{2, 0, 0}, 1},
        {{0, 2, 0}, 1},
        {{2, 2, 0}, 1},
        {{0, 0, 2}, 1},
        {{2, 0, 2}, 1},
        {{0, 2, 2}, 1},
        {{2, 2, 2}, 1}},
       {1, 5, 0}},
      {"points on a line", {{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{2, 0, 0}, 0}}, {3, 0, 0}},
      {"points in a plane", {{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{1, 1, 0}, 0}}, {4, 0, 0}},
      {"points", {{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{1, 1, 0}, 0}, {{0, 0, 1}, 0}}, {5, 0, 0}},
  };
  return result;
}

std::vector<Ball_3> many_balls(int count, double neighbors, std::uint64_t seed) {
  Random random(seed);
  Balls result;
  // In the unit cube, count (2 r)^3 4 pi / 3 = neighbors.
  const double radius = 0.5 * std::cbrt(neighbors / (4 * std::numbers::pi / 3 * count));
  for (int i = 0; i < count; ++i) {
    const double x = random.unit();
    const double y = random.unit();
    const double z = random.unit();
    result.push_back({{x, y, z}, radius * random.uniform(0.5, 1.5)});
  }
  return result;
}

std::vector<Smooth_solid> smooth_solids() {
  const auto on_sphere = [](double u, double v) {
    const double z = 2 * v - 1;
    const double width = std::sqrt(std::max(0.0, 1 - z * z));
    return Point_3{width * std::cos(2 * std::numbers::pi * u), width * std::sin(2 * std::numbers::pi * u), z};
  };
  return {{"sphere", on_sphere, [](const Point_3& p) { return dot(p, p) < 1; }, {1, 0, 0}},
          {"ellipsoid",
           [on_sphere](double u, double v) {
             const Point_3 p = on_sphere(u, v);
             return Point_3{2 * p.x, p.y, 0.6 * p.z};
           },
           [](const Point_3& p) {
             const Point_3 q{p.x / 2, p.y, p.z / 0.6};
             return dot(q, q) < 1;
           },
           {1, 0, 0}},
          {"torus",
           [](double u, double v) {
             const double a = 2 * std::numbers::pi * u;
             const double b = 2 * std::numbers::pi * v;
             const double reach = 1 + 0.4 * std::cos(b);
             return Point_3{reach * std::cos(a), reach * std::sin(a), 0.4 * std::sin(b)};
           },
           [](const Point_3& p) {
             const double reach = std::hypot(p.x, p.y) - 1;
             return reach * reach + p.z * p.z < 0.16;
           },
           {1, 1, 0}},
          {"shell",
           [on_sphere](double u, double v) {
             return v < 0.25 ? 0.5 * on_sphere(u, 4 * v) : on_sphere(u, (v - 0.25) / 0.75);
           },
           [](const Point_3& p) { return dot(p, p) < 1 && dot(p, p) > 0.25; },
           {1, 0, 1}}};
}

std::vector<Ball_3> inner_voronoi_balls(const Smooth_solid& solid, int samples, double perturbation,
                                        std::uint64_t seed) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  Random random(seed);
  CGAL::Delaunay_triangulation_3<Kernel> triangulation;
  const double golden = (std::sqrt(5.0) - 1) / 2;
  const double shift = random.unit();
  for (int i = 0; i < samples; ++i) {
    const double u = shift + i * golden + random.uniform(0, 0.2) / std::sqrt(samples);
    const Point_3 p = solid.surface(u - std::floor(u), (i + random.unit()) / samples);
    triangulation.insert(Kernel::Point_3(p.x, p.y, p.z));
  }
  Balls result;
  for (const auto& cell : triangulation.finite_cell_handles()) {
    const auto c = triangulation.dual(cell);
    Ball_3 ball{{c.x(), c.y(), c.z()}, std::sqrt(CGAL::squared_distance(c, cell->vertex(0)->point()))};
    if (!solid.is_inside(ball.center)) continue;
    const double reach = perturbation * ball.radius;
    const double x = random.uniform(-reach, reach);
    const double y = random.uniform(-reach, reach);
    const double z = random.uniform(-reach, reach);
    ball.center = ball.center + Point_3{x, y, z};
    result.push_back(ball);
  }
  return result;
}

std::string to_text(const std::vector<Ball_3>& balls) {
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "{";
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Ball_3& b = balls[i];
    text << (i ? ", " : "") << "{{" << b.center.x << ", " << b.center.y << ", " << b.center.z << "}, " << b.radius
         << "}";
  }
  text << "}";
  return text.str();
}

}  // namespace mesecina::test
