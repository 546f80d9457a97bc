// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_2/delaunay_2.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "core/outcome.h"
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

constexpr std::size_t points_between_reports = 4096;
/// Indices of triangles and of the elements of layers are ints; there are about two triangles, three edges per point.
constexpr std::size_t most_points = 300'000'000;

/// Traits for CGAL::spatial_sort whose comparisons throw Cancelled when a stop was asked for: the sort has no other
/// place to ask.
class Cancellable_sort_traits {
 public:
  using Point_2 = Indexed_point;
  struct Less_x_2 {
    const Progress* progress;
    bool operator()(const Point_2& p, const Point_2& q) const {
      progress->check();
      return p.first.x() < q.first.x();
    }
  };
  struct Less_y_2 {
    const Progress* progress;
    bool operator()(const Point_2& p, const Point_2& q) const {
      progress->check();
      return p.first.y() < q.first.y();
    }
  };
  explicit Cancellable_sort_traits(const Progress& progress) : progress_(&progress) {}
  Less_x_2 less_x_2_object() const { return {progress_}; }
  Less_y_2 less_y_2_object() const { return {progress_}; }

 private:
  const Progress* progress_;
};

/// The points in space-filling order, but for three that are not on one line at the front: CGAL looks through all
/// points at each insertion as long as they are on a line. None when all of them are.
std::vector<Indexed_point> insertion_order(std::span<const Point_2> points, const Progress& progress) {
  std::vector<Indexed_point> order;
  const auto add = [&](std::size_t i) {
    order.emplace_back(Dynamic::Kernel::Point_2(points[i].x, points[i].y), static_cast<int>(i));
  };
  if (points.empty()) return order;
  const auto at = [&](std::size_t i) { return Dynamic::Kernel::Point_2(points[i].x, points[i].y); };
  std::size_t second = 1;
  while (second < points.size() && points[second] == points[0]) ++second;
  std::size_t third = second + 1;
  while (third < points.size() && CGAL::orientation(at(0), at(second), at(third)) == CGAL::COLLINEAR) {
    progress.check();
    ++third;
  }
  if (third >= points.size()) return order;

  order.reserve(points.size());
  for (const std::size_t i : {std::size_t{0}, second, third}) add(i);
  for (std::size_t i = 1; i < points.size(); ++i)
    if (i != second && i != third) add(i);
  CGAL::spatial_sort(order.begin() + 3, order.end(), Cancellable_sort_traits(progress));
  return order;
}

/// The arrays for points on one line.
void connect_along_line(Delaunay_2& delaunay, const Progress& progress) {
  const auto& points = delaunay.points;
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](int a, int b) {
    progress.check();
    const Point_2& p = points[a];
    const Point_2& q = points[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
  });
  delaunay.site.resize(points.size());
  for (const int i : order) {
    if (delaunay.line.empty() || points[delaunay.line.back()] != points[i]) delaunay.line.push_back(i);
    delaunay.site[i] = delaunay.line.back();
  }
  delaunay.site_count = delaunay.line.size();
  delaunay.dimension = std::min(1, static_cast<int>(delaunay.line.size()) - 1);
}

/// Fills triangles and neighbors from `dynamic`, which must be of dimension 2.
void fill_arrays(Delaunay_2& delaunay, const Progress& progress) {
  auto& triangulation = delaunay.dynamic->triangulation;
  int count = 0;
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
    face->info().value = triangulation.is_infinite(face) ? -1 : count++;
  progress.check();
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

}  // namespace

Delaunay_2 delaunay(std::span<const Point_2> points, Progress& progress) {
  if (points.size() > most_points)
    throw Unavailable(std::to_string(points.size()) + " points are more than the " + std::to_string(most_points) +
                      " that can be triangulated");
  Delaunay_2 result;
  result.points.assign(points.begin(), points.end());
  std::vector<Indexed_point> order = insertion_order(points, progress);
  if (order.empty()) {
    connect_along_line(result, progress);
    return result;
  }
  result.dynamic = std::make_unique<Dynamic>();
  auto& triangulation = result.dynamic->triangulation;
  auto& vertex_of_point = result.dynamic->vertex_of_point;
  vertex_of_point.resize(points.size());

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
  result.dimension = triangulation.dimension();
  result.site_count = triangulation.number_of_vertices();
  progress.check();
  fill_arrays(result, progress);
  return result;
}

bool have_one_circle(const Delaunay_2& triangulation, int triangle, int corner) {
  const auto& [a, b, c] = triangulation.triangles[triangle];
  const int u = triangulation.neighbors[triangle][corner];
  const int d = triangulation.triangles[u][triangulation.mirror_corner(triangle, corner)];
  const Point_2& p = triangulation.points[a];
  const Point_2& q = triangulation.points[b];
  const Point_2& r = triangulation.points[c];
  const Point_2& s = triangulation.points[d];
  const double px = p.x - s.x;
  const double py = p.y - s.y;
  const double qx = q.x - s.x;
  const double qy = q.y - s.y;
  const double rx = r.x - s.x;
  const double ry = r.y - s.y;
  const double p2 = px * px + py * py;
  const double q2 = qx * qx + qy * qy;
  const double r2 = rx * rx + ry * ry;
  const double determinant = p2 * (qx * ry - qy * rx) + q2 * (rx * py - ry * px) + r2 * (px * qy - py * qx);
  const double magnitude = p2 * (std::abs(qx * ry) + std::abs(qy * rx)) + q2 * (std::abs(rx * py) + std::abs(ry * px)) +
                           r2 * (std::abs(px * qy) + std::abs(py * qx));
  // Rounding makes up less than 11.2 units of it, unless products vanish. [J. Shewchuk: Adaptive precision
  // floating-point arithmetic and fast robust geometric predicates, 1997]
  constexpr double smallest_part = 1.3e-15;
  constexpr double smallest_safe = 1e-280;
  if (magnitude > smallest_safe && std::abs(determinant) > smallest_part * magnitude) return false;
  const auto exact = [](const Point_2& point) { return Dynamic::Kernel::Point_2(point.x, point.y); };
  return CGAL::side_of_oriented_circle(exact(p), exact(q), exact(r), exact(s)) == CGAL::ON_ORIENTED_BOUNDARY;
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
    // From the least corner on, so that rounding does not depend on the history of the triangulation.
    const auto& corners = triangulation.triangles[t];
    const auto least = static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin());
    const Point_2& p = triangulation.points[corners[least]];
    const Point_2& q = triangulation.points[corners[(least + 1) % 3]];
    const Point_2& r = triangulation.points[corners[(least + 2) % 3]];
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
