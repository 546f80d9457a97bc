// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/crust_2/one_step_crust.h"

#include <CGAL/MP_Float.h>

#include <cmath>

#include "geometries/parallel.h"

namespace mesecina {

namespace {

/// Dot and cross product of the two vectors from a corner of a triangle to the others, and the product of their lengths
/// squared.
struct Corner {
  double dot;
  double cross;
  double squared_lengths;
};

Corner corner(const Point_2& p, const Point_2& q, const Point_2& at) {
  const double px = p.x - at.x;
  const double py = p.y - at.y;
  const double qx = q.x - at.x;
  const double qy = q.y - at.y;
  return {px * qx + py * qy, std::abs(px * qy - py * qx), (px * px + py * py) * (qx * qx + qy * qy)};
}

struct Exact_corner {
  CGAL::MP_Float dot;
  CGAL::MP_Float cross;
};

Exact_corner exact_corner(const Point_2& p, const Point_2& q, const Point_2& at) {
  using Number = CGAL::MP_Float;
  const Number px = Number(p.x) - Number(at.x);
  const Number py = Number(p.y) - Number(at.y);
  const Number qx = Number(q.x) - Number(at.x);
  const Number qy = Number(q.y) - Number(at.y);
  const Number cross = px * qy - py * qx;
  return {px * qx + py * qy, cross < Number(0) ? -cross : cross};
}

/// Products this small may have lost bits to underflow, which the relative error bounds below do not cover.
constexpr double smallest_safe_product = 1e-250;

/// Sign of dot_r dot_s - cross_r cross_s if the rounding errors cannot change it, else 0.
int filtered_sign(const Corner& r, const Corner& s) {
  const double difference = r.dot * s.dot - r.cross * s.cross;
  const double scale = r.squared_lengths * s.squared_lengths;
  // |dot|, |cross| <= product of lengths, each with relative error of that product below 4 u; their products and the
  // difference add less than 16 u of the product of all four lengths; doubled for the rounding of the bound itself.
  constexpr double bound = 32 * 1.1102230246251565e-16;
  if (!(scale > smallest_safe_product) || !(difference * difference > bound * bound * scale)) return 0;
  return difference > 0 ? 1 : -1;
}

}  // namespace

bool is_crust_edge(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& s) {
  if (const int sign = filtered_sign(corner(p, q, r), corner(p, q, s)); sign != 0) return sign > 0;
  const Exact_corner er = exact_corner(p, q, r);
  const Exact_corner es = exact_corner(p, q, s);
  return er.dot * es.dot >= er.cross * es.cross;
}

bool is_crust_hull_edge(const Point_2& p, const Point_2& q, const Point_2& r) {
  const Corner c = corner(p, q, r);
  constexpr double bound = 8 * 1.1102230246251565e-16;
  if (c.squared_lengths > smallest_safe_product && c.dot * c.dot > bound * bound * c.squared_lengths) return c.dot > 0;
  return exact_corner(p, q, r).dot > CGAL::MP_Float(0);
}

Crust_2 one_step_crust(const Delaunay_2& triangulation, Progress& progress) {
  Crust_2 crust;
  if (triangulation.dimension < 2) {
    for (std::size_t i = 1; i < triangulation.line.size(); ++i)
      crust.edges.push_back({triangulation.line[i - 1], triangulation.line[i]});
    return crust;
  }
  const std::size_t count = triangulation.triangles.size();
  const auto& points = triangulation.points;

  // First the edges that a triangle lists, then it learns of the others from its neighbours; every edge is decided
  // once.
  std::vector<std::uint8_t> listed(count, 0);
  parallel_for(count, progress, [&](std::size_t t) {
    std::uint8_t mask = 0;
    for (int i = 0; i < 3; ++i) {
      if (!triangulation.edge_is_listed(static_cast<int>(t), i)) continue;
      const int u = triangulation.neighbors[t][i];
      const auto [p, q] = triangulation.edge(static_cast<int>(t), i);
      const Point_2& r = points[triangulation.triangles[t][i]];
      bool in_crust;
      if (u < 0) {
        in_crust = is_crust_hull_edge(points[p], points[q], r);
      } else {
        const int j = triangulation.mirror_corner(static_cast<int>(t), i);
        in_crust = is_crust_edge(points[p], points[q], r, points[triangulation.triangles[u][j]]);
      }
      if (in_crust) mask |= static_cast<std::uint8_t>(1 << i);
    }
    listed[t] = mask;
  });
  crust.edges_of_triangle.assign(count, 0);
  parallel_for(count, progress, [&](std::size_t t) {
    std::uint8_t mask = listed[t];
    for (int i = 0; i < 3; ++i) {
      if (triangulation.edge_is_listed(static_cast<int>(t), i)) continue;
      const int u = triangulation.neighbors[t][i];
      if ((listed[u] >> triangulation.mirror_corner(static_cast<int>(t), i)) & 1)
        mask |= static_cast<std::uint8_t>(1 << i);
    }
    crust.edges_of_triangle[t] = mask;
  });
  for (std::size_t t = 0; t < count; ++t)
    for (int i = 0; i < 3; ++i)
      if (crust.contains(static_cast<int>(t), i) && triangulation.edge_is_listed(static_cast<int>(t), i))
        crust.edges.push_back(triangulation.edge(static_cast<int>(t), i));
  return crust;
}

}  // namespace mesecina
