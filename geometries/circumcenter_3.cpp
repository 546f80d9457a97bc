// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/circumcenter_3.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <cmath>

namespace mesecina {

namespace {

using Vector = std::array<double, 3>;

Vector difference(const Point_3& p, const Point_3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }

double largest_coordinate(const Vector& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

Point_3 exact_circumcenter(const std::array<Point_3, 4>& p) {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto exact = [](const Point_3& q) { return Exact::Point_3(q.x, q.y, q.z); };
  const Exact::Point_3 center = CGAL::circumcenter(exact(p[0]), exact(p[1]), exact(p[2]), exact(p[3]));
  // Intervals may be as wide as the numbers here.
  return {CGAL::to_double(CGAL::exact(center.x())), CGAL::to_double(CGAL::exact(center.y())),
          CGAL::to_double(CGAL::exact(center.z()))};
}

}  // namespace

Point_3 circumcenter(const std::array<Point_3, 4>& points) {
  const Vector a = difference(points[1], points[0]);
  const Vector b = difference(points[2], points[0]);
  const Vector c = difference(points[3], points[0]);
  const auto minor = [](const Vector& u, const Vector& v, int k) {
    return u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
  };
  const auto square = [](const Vector& u) { return u[0] * u[0] + u[1] * u[1] + u[2] * u[2]; };
  const double determinant = a[0] * minor(b, c, 0) + a[1] * minor(b, c, 1) + a[2] * minor(b, c, 2);
  // Rounding moves the determinant by less than 1e-15 of the product of its columns; what is ten thousand times as
  // large gives a center to four digits of the radius and more.
  constexpr double safe = 1e-11;
  if (!(std::abs(determinant) > safe * largest_coordinate(a) * largest_coordinate(b) * largest_coordinate(c)))
    return exact_circumcenter(points);
  const auto coordinate = [&](int k, double origin) {
    const double sum = square(a) * minor(b, c, k) + square(b) * minor(c, a, k) + square(c) * minor(a, b, k);
    return origin + sum / (2 * determinant);
  };
  return {coordinate(0, points[0].x), coordinate(1, points[0].y), coordinate(2, points[0].z)};
}

}  // namespace mesecina
