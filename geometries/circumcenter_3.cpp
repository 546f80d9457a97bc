// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/circumcenter_3.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpzf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesecina {

namespace {

using Vector = std::array<double, 3>;

Vector difference(const Point_3& p, const Point_3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }

double largest_coordinate(const Vector& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

/// Rounded once: of exact numbers.
Point_3 exact_circumcenter(const std::array<Point_3, 4>& p) {
  using Number = CGAL::Gmpzf;
  std::array<std::array<Number, 3>, 3> edges;
  std::array<Number, 3> squares;
  for (int i = 0; i < 3; ++i) {
    const Point_3& q = p[i + 1];
    edges[i] = {Number(q.x) - Number(p[0].x), Number(q.y) - Number(p[0].y), Number(q.z) - Number(p[0].z)};
    squares[i] = edges[i][0] * edges[i][0] + edges[i][1] * edges[i][1] + edges[i][2] * edges[i][2];
  }
  const auto cross = [&](int i, int j) {
    std::array<Number, 3> result;
    for (int k = 0; k < 3; ++k)
      result[k] = edges[i][(k + 1) % 3] * edges[j][(k + 2) % 3] - edges[i][(k + 2) % 3] * edges[j][(k + 1) % 3];
    return result;
  };
  const std::array<std::array<Number, 3>, 3> products{cross(1, 2), cross(2, 0), cross(0, 1)};
  const Number determinant = edges[0][0] * products[0][0] + edges[0][1] * products[0][1] + edges[0][2] * products[0][2];
  const std::array<double, 3> origin{p[0].x, p[0].y, p[0].z};
  std::array<double, 3> center{};
  for (int k = 0; k < 3; ++k) {
    const Number shift = squares[0] * products[0][k] + squares[1] * products[1][k] + squares[2] * products[2][k];
    const Number numerator = shift + Number(2 * origin[k]) * determinant;
    center[k] = CGAL::to_double(CGAL::Gmpq(numerator) / CGAL::Gmpq(Number(2) * determinant));
  }
  return {center[0], center[1], center[2]};
}

/// Seen from there the digits that are lost where two points nearly meet are those of their short difference only.
int end_of_shortest_edge(const std::array<Point_3, 4>& points) {
  int best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) {
      const double square = squared_distance(points[i], points[j]);
      if (square < least) {
        least = square;
        best = i;
      }
    }
  }
  return best;
}

}  // namespace

Point_3 circumcenter(const std::array<Point_3, 4>& points) {
  const int o = end_of_shortest_edge(points);
  const Point_3& origin = points[o];
  const Vector a = difference(points[(o + 1) % 4], origin);
  const Vector b = difference(points[(o + 2) % 4], origin);
  const Vector c = difference(points[(o + 3) % 4], origin);
  const auto minor = [](const Vector& u, const Vector& v, int k) {
    return u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
  };
  const auto square = [](const Vector& u) { return u[0] * u[0] + u[1] * u[1] + u[2] * u[2]; };
  const double determinant = a[0] * minor(b, c, 0) + a[1] * minor(b, c, 1) + a[2] * minor(b, c, 2);
  // Rounding moves the determinant by less than 1e-15 of the product of its columns; what is 10^9 times as large gives
  // a center to nine digits of the radius and more.
  constexpr double safe = 1e-6;
  if (!(std::abs(determinant) > safe * largest_coordinate(a) * largest_coordinate(b) * largest_coordinate(c)))
    return exact_circumcenter(points);
  const auto coordinate = [&](int k, double from) {
    const double sum = square(a) * minor(b, c, k) + square(b) * minor(c, a, k) + square(c) * minor(a, b, k);
    return from + sum / (2 * determinant);
  };
  return {coordinate(0, origin.x), coordinate(1, origin.y), coordinate(2, origin.z)};
}

}  // namespace mesecina
