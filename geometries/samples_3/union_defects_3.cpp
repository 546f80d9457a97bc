// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/samples_3/union_defects_3.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometries/edge_ring_3.h"
#include "geometries/parallel.h"

namespace mesecina {

namespace {

/// The center of the smallest sphere orthogonal to some balls, and the square of its radius.
struct Orthogonal_sphere {
  Point_3 center;
  double power = 0;
  bool is_centered = false;  ///< the center lies between those of the balls
};

double power(const Ball_3& ball, const Point_3& p) {
  return squared_distance(ball.center, p) - ball.radius * ball.radius;
}

/// Half of the difference of the powers along the way from one center to another.
double along(const Ball_3& from, const Ball_3& to, const Point_3& way) {
  return (dot(way, way) + from.radius * from.radius - to.radius * to.radius) / 2;
}

Orthogonal_sphere orthogonal_sphere(const Ball_3& a, const Ball_3& b) {
  const Point_3 way = b.center - a.center;
  const double part = along(a, b, way) / dot(way, way);
  const Point_3 center = a.center + part * way;
  return {center, power(a, center), part > 0 && part < 1};
}

Orthogonal_sphere orthogonal_sphere(const Ball_3& a, const Ball_3& b, const Ball_3& c) {
  const Point_3 u = b.center - a.center;
  const Point_3 v = c.center - a.center;
  const Point_3 n = cross(u, v);
  const double square = dot(n, n);
  const Point_3 foot = (1 / square) * (along(a, b, u) * cross(v, n) + along(a, c, v) * cross(n, u));
  const double second = dot(cross(foot, v), n) / square;
  const double third = dot(cross(u, foot), n) / square;
  const Point_3 center = a.center + foot;
  return {center, power(a, center), second > 0 && third > 0 && second + third < 1};
}

Orthogonal_sphere orthogonal_sphere(const Ball_3& a, const Ball_3& b, const Ball_3& c, const Ball_3& d) {
  const Point_3 u = b.center - a.center;
  const Point_3 v = c.center - a.center;
  const Point_3 w = d.center - a.center;
  const double determinant = dot(u, cross(v, w));
  const Point_3 foot =
      (1 / determinant) * (along(a, b, u) * cross(v, w) + along(a, c, v) * cross(w, u) + along(a, d, w) * cross(u, v));
  const double second = dot(foot, cross(v, w)) / determinant;
  const double third = dot(u, cross(foot, w)) / determinant;
  const double fourth = dot(u, cross(v, foot)) / determinant;
  const Point_3 center = a.center + foot;
  return {center, power(a, center), second > 0 && third > 0 && fourth > 0 && second + third + fourth < 1};
}

/// More than one place without a ball: all balls lie in a plane.
bool is_flat(const Regular_3& regular) {
  return std::ranges::any_of(regular.cells, [](const auto& corners) { return std::ranges::count(corners, -1) > 1; });
}

/// Calls use(balls, sphere) for the critical simplices with two to four balls, each once, block by block.
template <class Use>
void for_critical_simplices(const Regular_3& regular, int cell, const Use& use) {
  const auto& corners = regular.cells[cell];
  const std::vector<Ball_3>& balls = regular.balls;
  const auto is_free = [&](const Orthogonal_sphere& sphere, int other) {
    return other < 0 || power(balls[other], sphere.center) >= sphere.power;
  };
  if (!regular.is_infinite(cell)) {
    const auto& [a, b, c, d] = corners;
    if (const auto sphere = orthogonal_sphere(balls[a], balls[b], balls[c], balls[d]); sphere.is_centered)
      use(std::array{a, b, c, d}, sphere);
  }
  for (int i = 0; i < 4; ++i) {
    const int next = regular.neighbors[cell][i];
    if (next < cell) continue;
    std::array<int, 4> face{-1, -1, -1, -1};
    for (int k = 0; k < 3; ++k) face[k] = corners[(i + k + 1) % 4];
    const auto& [a, b, c, none] = face;
    if (std::min({a, b, c}) < 0) continue;
    const auto sphere = orthogonal_sphere(balls[a], balls[b], balls[c]);
    if (!sphere.is_centered || !is_free(sphere, corners[i])) continue;
    const int* across = std::ranges::find_if(
        regular.cells[next], [&](int ball) { return ball != face[0] && ball != face[1] && ball != face[2]; });
    if (is_free(sphere, *across)) use(face, sphere);
  }
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const int a = corners[i];
      const int b = corners[j];
      if (std::min(a, b) < 0) continue;
      const auto sphere = orthogonal_sphere(balls[a], balls[b]);
      if (!sphere.is_centered || !is_free(sphere, corners[(i + 1) % 4 == j ? (i + 2) % 4 : (i + 1) % 4])) continue;
      const bool is_whole = walk_around_edge(regular.cells, regular.neighbors, cell, i, j, [&](int current) {
        return current >= cell && std::ranges::all_of(regular.cells[current], [&](int ball) {
                 return ball == a || ball == b || is_free(sphere, ball);
               });
      });
      if (is_whole) use(std::array{a, b, -1, -1}, sphere);
    }
  }
}

/// Calls find(cell, found) for all cells, and gives what was found in their order.
template <class Found, class Find>
std::vector<Found> gathered(const Regular_3& regular, Progress& progress, const Find& find) {
  constexpr std::size_t block = 2048;
  const std::size_t count = regular.cells.size();
  std::vector<std::vector<Found>> parts((count + block - 1) / block);
  parallel_blocks(parts.size(), progress, [&](std::size_t b) {
    for (std::size_t c = b * block; c < std::min(count, (b + 1) * block); ++c) find(static_cast<int>(c), parts[b]);
  });
  std::vector<Found> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::vector<Union_defect_3> union_defects(const Regular_3& regular, const Solid_3& solid, double reach,
                                          Progress& progress) {
  if (is_flat(regular)) return {};
  std::vector<Union_defect_3> places =
      gathered<Union_defect_3>(regular, progress, [&](int cell, std::vector<Union_defect_3>& found) {
        for_critical_simplices(regular, cell, [&](const std::array<int, 4>& balls, const Orthogonal_sphere& sphere) {
          if (sphere.power >= -reach * reach) found.push_back({sphere.center, sphere.power > 0, balls});
        });
      });
  std::vector<Point_3> points;
  points.reserve(places.size());
  for (const Union_defect_3& place : places) points.push_back(place.place);
  const auto inside = are_inside(solid, points, progress);
  std::vector<Union_defect_3> defects;
  for (std::size_t i = 0; i < places.size(); ++i)
    if ((inside[i] != 0) == places[i].is_hole) defects.push_back(places[i]);
  return defects;
}

std::vector<Point_3> deep_arc_points(const Regular_3& regular, double depth, Progress& progress) {
  if (is_flat(regular)) return {};
  const std::vector<Ball_3>& balls = regular.balls;
  return gathered<Point_3>(regular, progress, [&](int cell, std::vector<Point_3>& found) {
    std::vector<int> around;
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        const int a = regular.cells[cell][i];
        const int b = regular.cells[cell][j];
        if (std::min(a, b) < 0) continue;
        const Point_3 way = balls[b].center - balls[a].center;
        // The circle of equal balls lies less than this below their cone, that of other ones even less.
        if (dot(way, way) <= 4 * depth * std::min(balls[a].radius, balls[b].radius)) continue;
        const double length = std::sqrt(dot(way, way));
        const double slope = (balls[a].radius - balls[b].radius) / length;
        const double height = along(balls[a], balls[b], way) / length;
        const double square = balls[a].radius * balls[a].radius - height * height;
        if (square <= 0 || std::abs(slope) >= 1) continue;
        const double radius = std::sqrt(square);
        if (balls[a].radius - slope * height - std::sqrt(1 - slope * slope) * radius <= depth) continue;
        around.clear();
        const bool is_whole = walk_around_edge(regular.cells, regular.neighbors, cell, i, j, [&](int current) {
          for (const int ball : regular.cells[current])
            if (ball >= 0 && ball != a && ball != b) around.push_back(ball);
          return current >= cell;
        });
        if (!is_whole) continue;
        const Point_3 center = balls[a].center + (height / length) * way;
        const Point_3 side = std::abs(way.x) < std::abs(way.y) ? Point_3{1, 0, 0} : Point_3{0, 1, 0};
        Point_3 u = cross(way, side);
        u = (radius / std::sqrt(dot(u, u))) * u;
        const Point_3 v = (1 / length) * cross(way, u);
        constexpr int parts = 16;
        for (int k = 0; k < parts; ++k) {
          const double angle = 2 * std::numbers::pi * k / parts;
          const Point_3 p = center + std::cos(angle) * u + std::sin(angle) * v;
          if (std::ranges::none_of(around, [&](int ball) { return power(balls[ball], p) < 0; })) found.push_back(p);
        }
      }
    }
  });
}

}  // namespace mesecina
