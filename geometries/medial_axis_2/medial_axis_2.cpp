// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_axis_2/medial_axis_2.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// The corner of the triangle that is neither p nor q.
int opposite_corner(const std::array<int, 3>& triangle, const std::array<int, 2>& edge) {
  for (const int corner : triangle)
    if (corner != edge[0] && corner != edge[1]) return corner;
  return triangle[0];
}

}  // namespace

Medial_axis_2 medial_axis(const Delaunay_2& triangulation, const Voronoi_2& voronoi, const Labels_2& labels,
                          Progress& progress) {
  progress.check();
  Medial_axis_2 axis;
  const int count = static_cast<int>(triangulation.triangles.size());
  std::vector<int> ball_of_triangle(count, -1);
  for (int t = 0; t < count; ++t) {
    if (!labels.is_inner[t]) continue;
    ball_of_triangle[t] = static_cast<int>(axis.triangles.size());
    axis.triangles.push_back(t);
  }
  progress.check();
  axis.centers.reserve(axis.triangles.size());
  axis.radii.reserve(axis.triangles.size());
  axis.edges.reserve(axis.triangles.size() + axis.triangles.size() / 8);
  axis.contacts.reserve(axis.triangles.size() + axis.triangles.size() / 8);
  for (const int t : axis.triangles) {
    axis.centers.push_back(voronoi.vertices[t]);
    axis.radii.push_back(voronoi.radii[t]);
    for (int i = 0; i < 3; ++i) {
      const int u = triangulation.neighbors[t][i];
      if (u < 0 || u > t || ball_of_triangle[u] < 0) continue;
      axis.edges.push_back({ball_of_triangle[u], ball_of_triangle[t]});
      const auto [p, q] = triangulation.edge(t, i);
      axis.contacts.push_back({std::min(p, q), std::max(p, q)});
    }
  }
  return axis;
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
  std::vector<double> lambda(axis.triangles.size());
  parallel_for(lambda.size(), progress, [&](std::size_t b) {
    const auto& triangle = triangulation.triangles[axis.triangles[b]];
    lambda[b] = axis.radii[b];
    for (int i = 0; i < 3; ++i) {
      const Point_2& r = triangulation.points[triangle[i]];
      const Point_2& p = triangulation.points[triangle[(i + 1) % 3]];
      const Point_2& q = triangulation.points[triangle[(i + 2) % 3]];
      if ((p.x - r.x) * (q.x - r.x) + (p.y - r.y) * (q.y - r.y) <= 0) lambda[b] = distance(p, q) / 2;
    }
  });
  return lambda;
}

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
  return angles;
}

}  // namespace mesecina
