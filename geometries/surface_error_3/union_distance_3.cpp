// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_error_3/union_distance_3.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometries/solid_3/surface_locator_3.h"

namespace mesecina {

namespace {

/// The point of a circle, the common one of two spheres, that is nearest to p; p itself where there is no circle.
Point_3 nearest_on_circle(const Ball_3& a, const Ball_3& b, const Point_3& p) {
  const Point_3 axis = b.center - a.center;
  const double square = dot(axis, axis);
  if (square == 0) return p;
  const double where = (square + a.radius * a.radius - b.radius * b.radius) / (2 * square);
  const double radius_square = a.radius * a.radius - where * where * square;
  if (radius_square < 0) return p;
  const Point_3 center = a.center + where * axis;
  Point_3 out = p - center;
  out = out - (dot(out, axis) / square) * axis;
  double length = std::sqrt(dot(out, out));
  if (length == 0) {
    // On the axis all points of the circle are equally near.
    out = std::abs(axis.x) < std::abs(axis.y) ? cross(axis, {1, 0, 0}) : cross(axis, {0, 1, 0});
    length = std::sqrt(dot(out, out));
  }
  return center + (std::sqrt(radius_square) / length) * out;
}

/// Offsets and entries of lists per ball from pairs (ball, entry).
void make_lists(std::size_t count, const std::vector<std::pair<int, int>>& pairs, std::vector<int>& first,
                std::vector<int>& entries) {
  first.assign(count + 1, 0);
  for (const auto& [ball, entry] : pairs) ++first[ball + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  entries.resize(pairs.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (const auto& [ball, entry] : pairs) entries[next[ball]++] = entry;
}

}  // namespace

Union_distance_3::Union_distance_3(const Union_boundary_3& boundary, Progress& progress) : boundary_(boundary) {
  const Dual_3& dual = *boundary.dual;
  const std::vector<Ball_3>& balls = dual.regular->balls;
  std::vector<Box> centers;
  std::vector<int> used;
  for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
    if (dual.vertices[i] == Simplex_kind_3::outside) continue;
    used.push_back(i);
    centers.push_back({balls[i].center, balls[i].center});
  }
  tree_ = Box_tree_3(centers, progress);
  std::vector<double> radii;
  for (const int i : tree_.order()) {
    numbers_.push_back(used[i]);
    balls_.push_back(balls[used[i]]);
    radii.push_back(balls_.back().radius);
  }
  largest_ = tree_.largest_below(radii);

  std::vector<std::pair<int, int>> neighbors;
  std::vector<std::pair<int, int>> circles;
  for (const Dual_3::Edge& edge : dual.edges) {
    const auto& [a, b] = edge.balls;
    neighbors.emplace_back(a, b);
    neighbors.emplace_back(b, a);
    if (edge.kind == Simplex_kind_3::regular || edge.kind == Simplex_kind_3::singular)
      circles.emplace_back(std::min(a, b), std::max(a, b));
  }
  make_lists(balls.size(), neighbors, first_neighbor_, neighbors_);
  make_lists(balls.size(), circles, first_circle_, circles_);

  std::vector<Box> points;
  points.reserve(boundary.vertices.size());
  for (const Point_3& p : boundary.vertices) points.push_back({p, p});
  vertex_tree_ = Box_tree_3(points, progress);
}

Union_distance_3::Nearest Union_distance_3::nearest(const Point_3& p, int guess) const {
  Nearest result{distance(balls_[guess].center, p) - balls_[guess].radius, guess};
  tree_.approach([&](const Box& box, int node) { return std::sqrt(squared_distance(box, p)) - largest_[node]; },
                 result.distance,
                 [&](int i) {
                   // Most are not the nearest one, which needs no root.
                   const double reach = result.distance + balls_[i].radius;
                   if (reach <= 0) return;
                   const double square = squared_distance(balls_[i].center, p);
                   if (square < reach * reach) result = {std::sqrt(square) - balls_[i].radius, i};
                 });
  return result;
}

bool Union_distance_3::is_free(const Corners_3& triangle) const {
  const Box around = box_of(triangle);
  const Point_3 middle = midpoint(around.lower, around.upper);
  const double radius = distance(around.lower, around.upper) / 2;
  bool is_free = true;
  tree_.visit(
      [&](const Box& box, int node) {
        const double reach = largest_[node] + radius;
        return squared_distance(box, middle) < reach * reach;
      },
      [&](int i) {
        const double reach = balls_[i].radius + radius;
        is_free = squared_distance(balls_[i].center, middle) >= reach * reach ||
                  squared_distance(triangle, balls_[i].center) >= balls_[i].radius * balls_[i].radius;
        return is_free;
      });
  return is_free;
}

bool Union_distance_3::is_exposed(int ball, const Point_3& p) const {
  // Of vertices and circles it is known on which spheres they are, but not to the last digit.
  constexpr double slack = 1e-9;
  const std::vector<Ball_3>& balls = boundary_.dual->regular->balls;
  return std::ranges::none_of(neighbors(ball), [&](int other) {
    const double reach = balls[other].radius * (1 - slack);
    return squared_distance(balls[other].center, p) < reach * reach;
  });
}

double Union_distance_3::depth(const Point_3& p) const {
  double least = std::numeric_limits<double>::infinity();
  vertex_tree_.approach(
      [&](const Box& box) { return std::sqrt(squared_distance(box, p)); }, least,
      [&](int i) { least = std::min(least, distance(boundary_.vertices[vertex_tree_.order()[i]], p)); });
  const Dual_3& dual = *boundary_.dual;
  const std::vector<Ball_3>& balls = dual.regular->balls;
  tree_.visit(
      [&](const Box& box, int node) { return std::sqrt(squared_distance(box, p)) - largest_[node] < least; },
      [&](int i) {
        const int ball = numbers_[i];
        if (dual.vertices[ball] == Simplex_kind_3::interior) return true;
        const Ball_3& own = balls_[i];
        const Point_3 out = p - own.center;
        const double length = std::sqrt(dot(out, out));
        if (std::abs(length - own.radius) >= least) return true;
        const Point_3 direction = length > 0 ? (1 / length) * out : Point_3{1, 0, 0};
        if (is_exposed(ball, own.center + own.radius * direction)) {
          least = std::abs(length - own.radius);
          return true;
        }
        for (int k = first_circle_[ball]; k < first_circle_[ball + 1]; ++k) {
          const Point_3 candidate = nearest_on_circle(own, balls[circles_[k]], p);
          const double apart = distance(candidate, p);
          if (apart < least && candidate != p && is_exposed(ball, candidate) && is_exposed(circles_[k], candidate))
            least = apart;
        }
        return true;
      });
  return least;
}

}  // namespace mesecina
