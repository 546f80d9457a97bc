// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/sphere_kernel_3.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesecina {

namespace {

/// The sum of two doubles of which the second is at most half a digit of the first. Without a bound of its error, as
/// that is known in advance here (compare Double_double).
struct Pair {
  double high = 0;
  double low = 0;
};

inline Pair exact_sum(double a, double b) {
  const double sum = a + b;
  const double shifted = sum - a;
  return {sum, (a - (sum - shifted)) + (b - shifted)};
}
inline Pair normalized(double high, double low) {
  const double sum = high + low;
  return {sum, low - (sum - high)};
}
[[gnu::always_inline]] inline Pair operator+(const Pair& a, const Pair& b) {
  const Pair high = exact_sum(a.high, b.high);
  const Pair low = exact_sum(a.low, b.low);
  const Pair sum = normalized(high.high, high.low + low.high);
  return normalized(sum.high, sum.low + low.low);
}
inline Pair operator-(const Pair& a, const Pair& b) { return a + Pair{-b.high, -b.low}; }

inline Pair split(double value) {
  const double scaled = 134217729.0 * value;  // 2^27 + 1
  const double first = scaled - (scaled - value);
  return {first, value - first};
}
[[gnu::always_inline]] inline Pair operator*(const Pair& a, const Pair& b) {
  const double product = a.high * b.high;
  const Pair u = split(a.high);
  const Pair v = split(b.high);
  const double rest = ((u.high * v.high - product) + u.high * v.low + u.low * v.high) + u.low * v.low;
  return normalized(product, rest + (a.high * b.low + a.low * b.high));
}

/// Positive where the fifth point is inside of a positively oriented sphere.
Pair in_sphere_determinant(const std::array<std::array<Pair, 3>, 4>& d) {
  const auto lift = [&](int i) { return d[i][0] * d[i][0] + d[i][1] * d[i][1] + d[i][2] * d[i][2]; };
  const auto minor = [&](int i, int j) { return d[i][0] * d[j][1] - d[j][0] * d[i][1]; };
  const Pair ab = minor(0, 1);
  const Pair bc = minor(1, 2);
  const Pair cd = minor(2, 3);
  const Pair da = minor(3, 0);
  const Pair ac = minor(0, 2);
  const Pair bd = minor(1, 3);
  const Pair abc = d[0][2] * bc - d[1][2] * ac + d[2][2] * ab;
  const Pair bcd = d[1][2] * cd - d[2][2] * bd + d[3][2] * bc;
  const Pair cda = d[2][2] * da + d[3][2] * ac + d[0][2] * cd;
  const Pair dab = d[3][2] * ab + d[0][2] * bd + d[1][2] * da;
  return (lift(2) * dab - lift(3) * abc) + (lift(0) * bcd - lift(1) * cda);
}

/// The product of the largest coordinates per axis and the square of the largest of all, which no term of the
/// determinant exceeds; 0 where it may overflow, or what is lost to underflow may count.
double size_of_terms(const std::array<std::array<double, 3>, 4>& d) {
  std::array<double, 3> most{};
  for (const auto& point : d)
    for (int k = 0; k < 3; ++k) most[k] = std::max(most[k], std::abs(point[k]));
  constexpr double least_known = 1e-50;
  constexpr double most_known = 1e50;
  const double largest = std::max({most[0], most[1], most[2]});
  if (!(std::min({most[0], most[1], most[2]}) > least_known) || !(largest < most_known)) return 0;
  return most[0] * most[1] * most[2] * largest * largest;
}

CGAL::Oriented_side side_of(double determinant, double error) {
  if (determinant > error) return CGAL::ON_POSITIVE_SIDE;
  if (-determinant > error) return CGAL::ON_NEGATIVE_SIDE;
  return CGAL::ON_ORIENTED_BOUNDARY;
}

}  // namespace

CGAL::Oriented_side side_of_sphere_by_double_doubles(const Sphere_query_3& points) {
  std::array<std::array<Pair, 3>, 4> d{};
  std::array<std::array<double, 3>, 4> rounded{};
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) {
      d[i][k] = exact_sum(points[i][k], -points[4][k]);
      rounded[i][k] = d[i][k].high;
    }
  }
  const double size = size_of_terms(rounded);
  if (size == 0) return CGAL::ON_ORIENTED_BOUNDARY;
  // 72 terms, each after 8 roundings at most.
  constexpr double relative_error = 0x1p-90;
  return side_of(in_sphere_determinant(d).high, relative_error * size);
}

double power_by_double_doubles(const std::array<double, 3>& point, const std::array<double, 3>& center, double radius) {
  Pair sum;
  for (int k = 0; k < 3; ++k) {
    const Pair along = exact_sum(point[k], -center[k]);
    sum = sum + along * along;
  }
  const Pair square = Pair{radius} * Pair{radius};
  const double power = (sum - square).high;
  return std::abs(power) <= square.high ? power : std::numeric_limits<double>::quiet_NaN();
}

CGAL::Oriented_side Sphere_kernel_3::Side_of_oriented_sphere_3::operator()(const Point_3& p, const Point_3& q,
                                                                           const Point_3& r, const Point_3& s,
                                                                           const Point_3& t) const {
  const CGAL::Oriented_side side = Sphere_side_3(p, q, r, s, t).by_coordinates();
  if (side != CGAL::ON_ORIENTED_BOUNDARY) return side;
  const CGAL::Oriented_side finer = side_of_sphere_by_double_doubles({{{p.x(), p.y(), p.z()},
                                                                       {q.x(), q.y(), q.z()},
                                                                       {r.x(), r.y(), r.z()},
                                                                       {s.x(), s.y(), s.z()},
                                                                       {t.x(), t.y(), t.z()}}});
  if (finer != CGAL::ON_ORIENTED_BOUNDARY) return finer;
  return Base().side_of_oriented_sphere_3_object()(p, q, r, s, t);
}

}  // namespace mesecina
