// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_axis_2/medial_axis_2.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <span>

#include "geometries/parallel.h"

namespace mesecina {

namespace {

/// Angle at `at` between the directions to p and q, in radians in [0, pi].
double angle_between(const Point_2& p, const Point_2& q, const Point_2& at) {
  const double px = p.x - at.x;
  const double py = p.y - at.y;
  const double qx = q.x - at.x;
  const double qy = q.y - at.y;
  return std::atan2(std::abs(px * qy - py * qx), px * qx + py * qy);
}

double degrees(double radians) { return radians * (180 / std::numbers::pi); }

/// A corner of the triangle that is neither p nor q.
int opposite_corner(const std::array<int, 3>& triangle, const std::array<int, 2>& edge) {
  for (const int corner : triangle)
    if (corner != edge[0] && corner != edge[1]) return corner;
  return triangle[0];
}

/// Twice the area.
double size_of(const Delaunay_2& triangulation, int triangle) {
  const auto& [a, b, c] = triangulation.triangles[triangle];
  const Point_2& p = triangulation.points[a];
  const Point_2& q = triangulation.points[b];
  const Point_2& r = triangulation.points[c];
  return std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
}

constexpr int triangles_between_checks = 1 << 13;

}  // namespace

Medial_axis_2 medial_axis(const Delaunay_2& triangulation, const Voronoi_2& voronoi, const Labels_2& labels,
                          Progress& progress) {
  Medial_axis_2 axis;
  const int count = static_cast<int>(triangulation.triangles.size());
  const auto inner = static_cast<std::size_t>(std::ranges::count_if(labels.is_inner, std::identity()));
  axis.triangles.reserve(inner);
  axis.edges.reserve(inner + inner / 8);
  axis.contacts.reserve(inner + inner / 8);
  // Per inner triangle one with the same circle and no greater index, its own at the least of them; else -1. Edges are
  // pairs of triangles at first.
  std::vector<int> circle(count, -1);
  const auto root = [&](int t) {
    while (circle[t] != t) t = circle[t] = circle[circle[t]];
    return t;
  };
  for (int t = 0; t < count; ++t) {
    if (t % triangles_between_checks == 0) progress.check();
    if (!labels.is_inner[t]) continue;
    circle[t] = t;
    for (int i = 0; i < 3; ++i) {
      const int u = triangulation.neighbors[t][i];
      if (u < 0 || u > t || !labels.is_inner[u]) continue;
      if (have_one_circle(triangulation, t, i)) {
        const int r = root(t);
        const int s = root(u);
        circle[std::max(r, s)] = std::min(r, s);
        continue;
      }
      axis.edges.push_back({u, t});
      const auto [p, q] = triangulation.edge(t, i);
      axis.contacts.push_back({std::min(p, q), std::max(p, q)});
    }
  }
  std::vector<int>& ball_of_triangle = circle;
  for (int t = 0; t < count; ++t) {
    if (circle[t] < 0) continue;
    if (circle[t] == t) {
      ball_of_triangle[t] = static_cast<int>(axis.triangles.size());
      axis.triangles.push_back(t);
      continue;
    }
    // What is before t is a ball already, and what has its circle is among it.
    const int ball = ball_of_triangle[t] = ball_of_triangle[circle[t]];
    int further = t;
    if (size_of(triangulation, t) > size_of(triangulation, axis.triangles[ball]))
      std::swap(further, axis.triangles[ball]);
    axis.further_triangles.push_back({ball, further});
  }
  std::ranges::sort(axis.further_triangles);
  progress.check();
  for (auto& [a, b] : axis.edges) {
    a = ball_of_triangle[a];
    b = ball_of_triangle[b];
  }
  axis.centers.reserve(axis.triangles.size());
  axis.radii.reserve(axis.triangles.size());
  for (const int t : axis.triangles) {
    axis.centers.push_back(voronoi.vertices[t]);
    axis.radii.push_back(voronoi.radii[t]);
  }
  return axis;
}

std::vector<int> contacts_of_ball(const Delaunay_2& triangulation, const Medial_axis_2& axis, int ball) {
  const auto& corners = triangulation.triangles[axis.triangles[ball]];
  std::vector<int> contacts(corners.begin(), corners.end());
  for (auto further = std::ranges::lower_bound(axis.further_triangles, std::array{ball, 0});
       further != axis.further_triangles.end() && (*further)[0] == ball; ++further) {
    const auto& others = triangulation.triangles[(*further)[1]];
    contacts.insert(contacts.end(), others.begin(), others.end());
  }
  std::ranges::sort(contacts);
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  return contacts;
}

std::vector<double> lambda_of_edges(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress) {
  std::vector<double> lambda(axis.edges.size());
  parallel_for(lambda.size(), progress, [&](std::size_t e) {
    const auto [p, q] = axis.contacts[e];
    lambda[e] = distance(triangulation.points[p], triangulation.points[q]) / 2;
  });
  return lambda;
}

std::vector<double> angle_of_edges(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress) {
  std::vector<double> angles(axis.edges.size());
  parallel_for(angles.size(), progress, [&](std::size_t e) {
    const auto [a, b] = axis.contacts[e];
    const Point_2& p = triangulation.points[a];
    const Point_2& q = triangulation.points[b];
    // The angle at a corner opposite to pq is obtuse iff that Voronoi vertex lies beyond pq; at most one of the two is.
    double angle = 180;
    for (const int ball : axis.edges[e]) {
      const auto& triangle = triangulation.triangles[axis.triangles[ball]];
      const Point_2& r = triangulation.points[opposite_corner(triangle, axis.contacts[e])];
      const double px = p.x - r.x;
      const double py = p.y - r.y;
      const double qx = q.x - r.x;
      const double qy = q.y - r.y;
      const double dot = px * qx + py * qy;
      if (dot < 0) angle = degrees(2 * std::atan2(std::abs(px * qy - py * qx), -dot));
    }
    angles[e] = angle;
  });
  return angles;
}

std::vector<double> lambda_of_balls(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress) {
  const auto of_triangle = [&](std::size_t b, int t) {
    const auto& triangle = triangulation.triangles[t];
    double lambda = axis.radii[b];
    for (int i = 0; i < 3; ++i) {
      const Point_2& r = triangulation.points[triangle[i]];
      const Point_2& p = triangulation.points[triangle[(i + 1) % 3]];
      const Point_2& q = triangulation.points[triangle[(i + 2) % 3]];
      if ((p.x - r.x) * (q.x - r.x) + (p.y - r.y) * (q.y - r.y) <= 0) lambda = distance(p, q) / 2;
    }
    return lambda;
  };
  std::vector<double> lambda(axis.triangles.size());
  parallel_for(lambda.size(), progress, [&](std::size_t b) { lambda[b] = of_triangle(b, axis.triangles[b]); });
  // The contact points of one of the triangles need as large a circle as all of them.
  for (const auto& [b, t] : axis.further_triangles) lambda[b] = std::max(lambda[b], of_triangle(b, t));
  return lambda;
}

namespace {

/// Largest angle between two of the points seen from `eye`, in radians.
double largest_angle(const Delaunay_2& triangulation, std::span<const int> contacts, const Point_2& eye) {
  std::vector<double> directions;
  for (const int contact : contacts) {
    const Point_2& p = triangulation.points[contact];
    directions.push_back(std::atan2(p.y - eye.y, p.x - eye.x));
  }
  std::ranges::sort(directions);
  double largest = 0;
  for (const double direction : directions) {
    // The last before and the first behind the opposite direction.
    const double opposite = direction > 0 ? direction - std::numbers::pi : direction + std::numbers::pi;
    const auto behind = std::ranges::lower_bound(directions, opposite);
    for (const double other : {behind == directions.end() ? directions.front() : *behind,
                               behind == directions.begin() ? directions.back() : *std::prev(behind)}) {
      const double between = std::abs(other - direction);
      largest = std::max(largest, std::min(between, 2 * std::numbers::pi - between));
    }
  }
  return largest;
}

}  // namespace

std::vector<double> angle_of_balls(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress) {
  std::vector<double> angles(axis.triangles.size());
  parallel_for(angles.size(), progress, [&](std::size_t b) {
    const auto& triangle = triangulation.triangles[axis.triangles[b]];
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
      const Point_2& r = triangulation.points[triangle[i]];
      const Point_2& p = triangulation.points[triangle[(i + 1) % 3]];
      const Point_2& q = triangulation.points[triangle[(i + 2) % 3]];
      // The central angle of pq is twice the inscribed one, measured the short way round.
      const double central = 2 * angle_between(p, q, r);
      largest = std::max(largest, std::min(central, 2 * std::numbers::pi - central));
    }
    angles[b] = degrees(largest);
  });
  int last = -1;
  for (const auto& [b, t] : axis.further_triangles) {
    if (b == last) continue;
    last = b;
    angles[b] = degrees(largest_angle(triangulation, contacts_of_ball(triangulation, axis, b), axis.centers[b]));
  }
  return angles;
}

std::vector<double> slope_of_balls(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress) {
  const auto of_triangle = [&](int t) {
    const auto& triangle = triangulation.triangles[t];
    double slope = 0;
    for (int i = 0; i < 3; ++i) {
      const Point_2& r = triangulation.points[triangle[i]];
      const Point_2& p = triangulation.points[triangle[(i + 1) % 3]];
      const Point_2& q = triangulation.points[triangle[(i + 2) % 3]];
      const double dot = (p.x - r.x) * (q.x - r.x) + (p.y - r.y) * (q.y - r.y);
      if (dot < 0) slope = std::min(1.0, -dot / distance(p, r) / distance(q, r));
    }
    return slope;
  };
  std::vector<double> slopes(axis.triangles.size());
  parallel_for(slopes.size(), progress, [&](std::size_t b) { slopes[b] = of_triangle(axis.triangles[b]); });
  for (const auto& [b, t] : axis.further_triangles) slopes[b] = std::min(slopes[b], of_triangle(t));
  return slopes;
}

std::vector<double> scale_along_edges(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // Positive if the first end is the smaller ball, negative if the second is.
  std::vector<double> quotients(axis.edges.size(), infinity);
  parallel_for(quotients.size(), progress, [&](std::size_t e) {
    const Point_2& p = triangulation.points[axis.contacts[e][0]];
    const Point_2& q = triangulation.points[axis.contacts[e][1]];
    // The centers lie on the bisector of pq, at h cot R and h cot R' on either side of it, where h = |pq| / 2 and R, R'
    // are the angles at opposite contacts. So d = h (cot R + cot R') and r'^2 - r^2 = h^2 (cot^2 R' - cot^2 R).
    std::array<double, 2> cotangents{};
    for (std::size_t end = 0; end < 2; ++end) {
      const auto& triangle = triangulation.triangles[axis.triangles[axis.edges[e][end]]];
      const Point_2& r = triangulation.points[opposite_corner(triangle, axis.contacts[e])];
      const double one = (p.x - r.x) * (q.y - r.y);
      const double other = (p.y - r.y) * (q.x - r.x);
      constexpr double smallest_trusted_part = 1e-10;
      if (!(std::abs(one - other) > smallest_trusted_part * (std::abs(one) + std::abs(other)))) return;
      cotangents[end] = ((p.x - r.x) * (q.x - r.x) + (p.y - r.y) * (q.y - r.y)) / std::abs(one - other);
    }
    const double difference = (cotangents[1] - cotangents[0]) * (distance(p, q) / 2);
    const double radii = axis.radii[axis.edges[e][0]] + axis.radii[axis.edges[e][1]];
    if (difference != 0) quotients[e] = radii / difference;
  });
  std::vector<double> scale(axis.triangles.size(), infinity);
  for (std::size_t e = 0; e < quotients.size(); ++e) {
    double& smaller = scale[axis.edges[e][quotients[e] > 0 ? 0 : 1]];
    smaller = std::min(smaller, std::max(1.0, std::abs(quotients[e])));
  }
  return scale;
}

}  // namespace mesecina
