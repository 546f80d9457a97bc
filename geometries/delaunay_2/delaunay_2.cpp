// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_2/delaunay_2.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>

#include "geometries/delaunay_2/dynamic.h"
#include "geometries/parallel.h"

namespace mesecina {

Delaunay_2::Delaunay_2() = default;
Delaunay_2::~Delaunay_2() = default;
Delaunay_2::Delaunay_2(Delaunay_2&&) noexcept = default;
Delaunay_2& Delaunay_2::operator=(Delaunay_2&&) noexcept = default;

namespace {

using Dynamic = Delaunay_2::Dynamic;
using Indexed_point = std::pair<Dynamic::Kernel::Point_2, int>;
using Sort_traits =
    CGAL::Spatial_sort_traits_adapter_2<Dynamic::Kernel, CGAL::First_of_pair_property_map<Indexed_point>>;

constexpr std::size_t points_between_reports = 4096;

}  // namespace

void rebuild_arrays(Delaunay_2& delaunay) {
  auto& triangulation = delaunay.dynamic->triangulation;
  delaunay.dimension = triangulation.dimension();
  delaunay.site_count = triangulation.number_of_vertices();
  delaunay.triangles.clear();
  delaunay.neighbors.clear();
  delaunay.line.clear();
  if (delaunay.dimension < 2) {
    for (const auto& vertex : triangulation.finite_vertex_handles()) delaunay.line.push_back(vertex->info().value);
    std::ranges::sort(delaunay.line, [&](int a, int b) {
      const Point_2& p = delaunay.points[a];
      const Point_2& q = delaunay.points[b];
      return p.x != q.x ? p.x < q.x : p.y < q.y;
    });
    return;
  }
  int count = 0;
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
    face->info().value = triangulation.is_infinite(face) ? -1 : count++;
  delaunay.triangles.resize(count);
  delaunay.neighbors.resize(count);
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
    const int t = face->info().value;
    for (int i = 0; i < 3; ++i) {
      delaunay.triangles[t][i] = face->vertex(i)->info().value;
      delaunay.neighbors[t][i] = face->neighbor(i)->info().value;
    }
  }
}

Delaunay_2 delaunay(std::span<const Point_2> points, Progress& progress) {
  Delaunay_2 result;
  result.points.assign(points.begin(), points.end());
  result.dynamic = std::make_unique<Dynamic>();
  auto& triangulation = result.dynamic->triangulation;
  auto& vertex_of_point = result.dynamic->vertex_of_point;
  vertex_of_point.resize(points.size());

  std::vector<Indexed_point> order;
  order.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    order.emplace_back(Dynamic::Kernel::Point_2(points[i].x, points[i].y), static_cast<int>(i));
  CGAL::spatial_sort(order.begin(), order.end(), Sort_traits());

  Dynamic::Face_handle hint;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i % points_between_reports == 0)
      progress.report(0.9 * static_cast<double>(i) / static_cast<double>(order.size()));
    const Dynamic::Vertex_handle vertex = triangulation.insert(order[i].first, hint);
    int& site = vertex->info().value;
    site = site < 0 ? order[i].second : std::min(site, order[i].second);
    vertex_of_point[order[i].second] = vertex;
    hint = vertex->face();
  }
  order = {};
  result.site.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) result.site[i] = vertex_of_point[i]->info().value;
  progress.check();
  rebuild_arrays(result);
  return result;
}

namespace {

struct Circle {
  Point_2 center;
  double radius = 0;
};

/// For triangles so thin that rounding would leave nothing of their area.
Circle exact_circumcircle(const Point_2& p, const Point_2& q, const Point_2& r) {
  using Rational = CGAL::Exact_rational;
  const Rational qx = Rational(q.x) - Rational(p.x);
  const Rational qy = Rational(q.y) - Rational(p.y);
  const Rational rx = Rational(r.x) - Rational(p.x);
  const Rational ry = Rational(r.y) - Rational(p.y);
  const Rational q2 = qx * qx + qy * qy;
  const Rational r2 = rx * rx + ry * ry;
  const Rational twice_cross = 2 * (qx * ry - qy * rx);
  const Rational cx = (ry * q2 - qy * r2) / twice_cross;
  const Rational cy = (qx * r2 - rx * q2) / twice_cross;
  return {{CGAL::to_double(Rational(p.x) + cx), CGAL::to_double(Rational(p.y) + cy)},
          std::hypot(CGAL::to_double(cx), CGAL::to_double(cy))};
}

}  // namespace

Voronoi_2 voronoi(const Delaunay_2& triangulation, Progress& progress) {
  Voronoi_2 result;
  const std::size_t count = triangulation.triangles.size();
  result.vertices.resize(count);
  result.radii.resize(count);
  parallel_for(count, progress, [&](std::size_t t) {
    const auto& triangle = triangulation.triangles[t];
    const Point_2& p = triangulation.points[triangle[0]];
    const Point_2& q = triangulation.points[triangle[1]];
    const Point_2& r = triangulation.points[triangle[2]];
    const double qx = q.x - p.x;
    const double qy = q.y - p.y;
    const double rx = r.x - p.x;
    const double ry = r.y - p.y;
    // Scaled by a power of two, so that very small and very large coordinates neither overflow nor vanish.
    const double size = std::max({std::abs(qx), std::abs(qy), std::abs(rx), std::abs(ry)});
    double scale = 1;
    if (!(size > 1e-60 && size < 1e60)) {
      int exponent = 0;
      std::frexp(size, &exponent);
      scale = std::ldexp(1.0, -exponent);
    }
    const double sqx = qx * scale;
    const double sqy = qy * scale;
    const double srx = rx * scale;
    const double sry = ry * scale;
    const double twice_cross = 2 * (sqx * sry - sqy * srx);
    constexpr double smallest_trusted_part = 1e-10;
    if (!(std::abs(twice_cross) > smallest_trusted_part * (std::abs(sqx * sry) + std::abs(sqy * srx)))) {
      const auto [center, radius] = exact_circumcircle(p, q, r);
      result.vertices[t] = center;
      result.radii[t] = radius;
      return;
    }
    const double q2 = sqx * sqx + sqy * sqy;
    const double r2 = srx * srx + sry * sry;
    const double cx = (sry * q2 - sqy * r2) / twice_cross / scale;
    const double cy = (sqx * r2 - srx * q2) / twice_cross / scale;
    result.vertices[t] = {p.x + cx, p.y + cy};
    result.radii[t] = euclidean_norm(cx, cy);
  });
  return result;
}

}  // namespace mesecina
