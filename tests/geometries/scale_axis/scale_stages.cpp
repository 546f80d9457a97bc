// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/scale_axis/scale_stages.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace mesecina::test {

namespace {

/// Counterclockwise from the direction of `from` to that of `to`, in (0, 2 pi].
double sweep(const Point_2& center, const Point_2& from, const Point_2& to) {
  double angle = std::atan2(to.y - center.y, to.x - center.x) - std::atan2(from.y - center.y, from.x - center.x);
  while (angle <= 0) angle += 2 * std::numbers::pi;
  return angle;
}

/// Inside of one of the disks, by more than rounding.
bool is_covered(const Union_boundary_2& boundary, const Point_2& point) {
  const auto& centers = boundary.dual->regular->balls->centers;
  for (std::size_t b = 0; b < centers.size(); ++b)
    if (distance(point, centers[b]) < boundary.radii[b] * (1 - 1e-12)) return true;
  return false;
}

Scale_stages from_axis(const std::shared_ptr<const Union_boundary_2>& boundary, Union_medial_axis_2 axis,
                       double scale) {
  Progress progress;
  Scale_stages result;
  result.scale = scale;
  result.boundary = boundary;
  result.axis = std::move(axis);
  result.grown_boundary = scale == 1 ? boundary
                                     : std::make_shared<const Union_boundary_2>(
                                           union_boundary(grown_medial_disks(result.axis, scale), 0, progress));
  result.grown_axis = union_medial_axis(union_voronoi(result.grown_boundary, progress), false, progress);
  return result;
}

}  // namespace

double Scale_stages::extent() const {
  double result = 0;
  const Balls_2& balls = grown_disks();
  for (std::size_t b = 0; b < balls.size(); ++b)
    result = std::max({result, std::abs(balls.centers[b].x), std::abs(balls.centers[b].y), balls.radii[b]});
  return result;
}

Scale_axis_2 Scale_stages::scale_axis(double min_angle, double sampling_min_angle) const {
  Progress progress;
  return mesecina::scale_axis(grown_axis, scale, min_angle, sampling_min_angle, progress);
}

Scale_stages scale_stages(const std::shared_ptr<const Balls_2>& balls, double scale) {
  Progress progress;
  const auto boundary = std::make_shared<const Union_boundary_2>(union_boundary(balls, 0, progress));
  return from_axis(boundary, union_medial_axis(union_voronoi(boundary, progress), false, progress), scale);
}

Scale_stages at_scale(const Scale_stages& stages, double scale) {
  return from_axis(stages.boundary, stages.axis, scale);
}

Betti betti_of_graph(std::size_t vertices, const std::vector<std::array<int, 2>>& edges) {
  std::vector<int> parent(vertices);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int a) {
    while (parent[a] != a) a = parent[a] = parent[parent[a]];
    return a;
  };
  auto components = static_cast<std::int64_t>(vertices);
  for (const auto& [a, b] : edges) {
    const int x = root(a);
    const int y = root(b);
    if (x == y) continue;
    parent[x] = y;
    --components;
  }
  return {components, static_cast<std::int64_t>(edges.size() + components - vertices)};
}

Betti betti(const Union_boundary_2& boundary) {
  const Topology of_dual = topology(*boundary.dual);
  return {of_dual.betti[0], of_dual.betti[1]};
}

std::string to_text(const Betti& betti) {
  return "(" + std::to_string(betti[0]) + ", " + std::to_string(betti[1]) + ")";
}

std::shared_ptr<const Balls_2> grown_medial_disks(const Union_medial_axis_2& axis, double scale) {
  return std::make_shared<const Balls_2>(grown(medial_balls(axis), scale));
}

Betti betti_of_union(const std::shared_ptr<const Balls_2>& balls) {
  Progress progress;
  return betti(union_boundary(balls, 0, progress));
}

double distance_to_boundary(const Union_boundary_2& boundary, const Point_2& point) {
  const Balls_2& balls = *boundary.dual->regular->balls;
  // Rounded vertices do not tell hardly any of a circle from nearly all of it.
  const auto is_short = [&](const Boundary_arc& arc) {
    const Point_2& center = balls.centers[arc.ball];
    return arc.from != arc.to && distance(boundary.vertices[arc.from], boundary.vertices[arc.to]) <=
                                     1e-14 * (boundary.radii[arc.ball] + std::abs(center.x) + std::abs(center.y));
  };
  std::vector<bool> has_long_arc(balls.size(), false);
  for (const Boundary_arc& arc : boundary.arcs)
    if (!is_short(arc)) has_long_arc[arc.ball] = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Boundary_arc& arc : boundary.arcs) {
    const Point_2& center = balls.centers[arc.ball];
    bool is_beside_arc = true;
    if (arc.from != arc.to) {
      const Point_2& p = boundary.vertices[arc.from];
      const Point_2& q = boundary.vertices[arc.to];
      nearest = std::min({nearest, distance(point, p), distance(point, q)});
      if (is_short(arc)) {
        const Point_2 reach{p.x - center.x, p.y - center.y};
        is_beside_arc = !has_long_arc[arc.ball] && !is_covered(boundary, {center.x - reach.x, center.y - reach.y}) &&
                        !is_covered(boundary, {center.x - reach.y, center.y + reach.x}) &&
                        !is_covered(boundary, {center.x + reach.y, center.y - reach.x});
      } else {
        is_beside_arc = point == center || sweep(center, p, point) <= sweep(center, p, q);
      }
    }
    if (is_beside_arc) nearest = std::min(nearest, std::abs(distance(point, center) - boundary.radii[arc.ball]));
  }
  return nearest;
}

bool is_in_union(const Balls_2& balls, const Point_2& point, double tolerance) {
  for (std::size_t b = 0; b < balls.size(); ++b)
    if (distance(point, balls.centers[b]) <= balls.radii[b] + tolerance) return true;
  return false;
}

}  // namespace mesecina::test
