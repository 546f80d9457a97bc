// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/union_3/boundary_oracle_3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesecina::test {

namespace {

double length(const Point_3& p) { return std::sqrt(dot(p, p)); }

Point_3 any_normal(const Point_3& direction) {
  const Point_3 other = std::abs(direction.x) < 0.6 ? Point_3{1, 0, 0} : Point_3{0, 1, 0};
  const Point_3 normal = cross(direction, other);
  return (1 / length(normal)) * normal;
}

}  // namespace

Boundary_oracle_3::Boundary_oracle_3(std::span<const Ball_3> balls) {
  const std::vector<std::uint8_t> is_left_out = are_concentric_with_another(balls);
  Box box;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Ball_3& b = balls[i];
    if (!is_left_out[i]) balls_.push_back(b);
    box.add(b.center - Point_3{b.radius, b.radius, b.radius});
    box.add(b.center + Point_3{b.radius, b.radius, b.radius});
  }
  scale_ = box.diagonal();
  double largest = scale_;
  for (const Point_3& p : {box.lower, box.upper})
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  precision_ = 1e-15 * largest;
  for (const Oracle_vertex_3& v : vertices_by_definition(balls))
    (v.is_on_boundary ? vertices_ : surrounded_).push_back(v.point);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Point_3 side = balls_[j].center - balls_[i].center;
      const double reach = length(side);
      const double r = balls_[i].radius;
      const double along = (reach + (r - balls_[j].radius) * (r + balls_[j].radius) / reach) / 2;
      const double square = (r - along) * (r + along);
      // Where spheres touch, rounding must not lose the point.
      if (square < -1e-13 * r * r - precision_ * r) continue;
      const Point_3 axis = (1 / reach) * side;
      circles_.push_back({balls_[i].center + along * axis, axis, std::sqrt(std::max(0.0, square))});
    }
  }
}

bool Boundary_oracle_3::is_inside(const Point_3& point) const {
  return std::ranges::any_of(balls_, [&](const Ball_3& b) { return distance(point, b.center) <= b.radius; });
}

/// In no ball's interior by more than rounding, and not surrounded.
bool Boundary_oracle_3::is_free(const Point_3& point) const {
  const double depth = 20 * precision_ + 1e-13 * scale_;
  if (std::ranges::any_of(balls_, [&](const Ball_3& b) { return distance(point, b.center) < b.radius - depth; }))
    return false;
  return std::ranges::none_of(surrounded_, [&](const Point_3& p) { return distance(p, point) < 1e-6 * scale_; });
}

bool Boundary_oracle_3::is_on_boundary(const Point_3& point, double tolerance) const {
  const double depth = 100 * precision_ + tolerance;
  double least = std::numeric_limits<double>::infinity();
  for (const Ball_3& b : balls_) least = std::min(least, distance(point, b.center) - b.radius);
  return std::abs(least) <= depth;
}

Point_3 Boundary_oracle_3::nearest(const Point_3& point) const {
  Point_3 result;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](const Point_3& candidate) {
    const double d = distance(point, candidate);
    if (d < least && is_free(candidate)) {
      least = d;
      result = candidate;
    }
  };
  for (const Point_3& v : vertices_) {
    const double d = distance(point, v);
    if (d >= least) continue;
    least = d;
    result = v;
  }
  for (const Ball_3& b : balls_) {
    const Point_3 u = point - b.center;
    const double reach = length(u);
    offer(b.center + b.radius * (reach > 0 ? (1 / reach) * u : Point_3{1, 0, 0}));
  }
  for (const Circle& c : circles_) {
    const Point_3 u = point - c.center;
    Point_3 flat = u - dot(u, c.axis) * c.axis;
    flat = flat - dot(flat, c.axis) * c.axis;
    const double reach = length(flat);
    offer(c.center + c.radius * (reach > 1e-12 * scale_ ? (1 / reach) * flat : any_normal(c.axis)));
  }
  return result;
}

double distance_to_segment(const Point_3& point, const Point_3& a, const Point_3& b) {
  const Point_3 side = b - a;
  const double square = dot(side, side);
  const double t = square > 0 ? std::clamp(dot(point - a, side) / square, 0.0, 1.0) : 0;
  return distance(point, a + t * side);
}

double distance_to_triangle(const Point_3& point, const Point_3& a, const Point_3& b, const Point_3& c) {
  const double least =
      std::min({distance_to_segment(point, a, b), distance_to_segment(point, b, c), distance_to_segment(point, c, a)});
  const Point_3 normal = cross(b - a, c - a);
  const double square = dot(normal, normal);
  if (square == 0) return least;
  const bool is_above = dot(cross(b - a, point - a), normal) >= 0 && dot(cross(c - b, point - b), normal) >= 0 &&
                        dot(cross(a - c, point - c), normal) >= 0;
  return is_above ? std::min(least, std::abs(dot(point - a, normal)) / std::sqrt(square)) : least;
}

std::vector<Point_3> voronoi_face(std::span<const Point_3> sites, int a, int b, double size) {
  const Point_3 side = sites[b] - sites[a];
  if (dot(side, side) == 0) return {};
  const Point_3 axis = (1 / length(side)) * side;
  const Point_3 u = any_normal(axis);
  const Point_3 v = cross(axis, u);
  const Point_3 middle = midpoint(sites[a], sites[b]);
  std::vector<Point_3> polygon{middle + size * (u + v), middle + size * (v - u), middle - size * (u + v),
                               middle + size * (u - v)};
  for (int k = 0; k < static_cast<int>(sites.size()); ++k) {
    if (k == a || k == b) continue;
    const Point_3 normal = sites[k] - sites[a];
    const Point_3 foot = midpoint(sites[a], sites[k]);
    std::vector<Point_3> rest;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point_3& p = polygon[i];
      const Point_3& q = polygon[(i + 1) % polygon.size()];
      const double at_p = dot(p - foot, normal);
      const double at_q = dot(q - foot, normal);
      if (at_p <= 0) rest.push_back(p);
      if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) rest.push_back(p + (at_p / (at_p - at_q)) * (q - p));
    }
    polygon = std::move(rest);
    if (polygon.size() < 3) return {};
  }
  return polygon;
}

}  // namespace mesecina::test
