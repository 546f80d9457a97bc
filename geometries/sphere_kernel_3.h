// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_structural_filtering_traits.h>

#include <array>
#include <cmath>

namespace mesecina {

/// Five points as coordinates.
using Sphere_query_3 = std::array<std::array<double, 3>, 5>;

/// On which side of the oriented sphere through the first four points the fifth one lies, with the signs of CGAL;
/// ON_ORIENTED_BOUNDARY when about 100 bits do not tell. Requires that rounding is to nearest. The bound of the error
/// is that of the sums and products of its determinant, each known to 2^-102.
/// [T. Dekker: A floating-point technique for extending the available precision, 1971]
CGAL::Oriented_side side_of_sphere_by_double_doubles(const Sphere_query_3& points);

/// The same question where doubles alone may do, with what they need.
class Sphere_side_3 {
 public:
  template <class Point>
  Sphere_side_3(const Point& p, const Point& q, const Point& r, const Point& s, const Point& t)
      : a_(difference(p, t)), b_(difference(q, t)), c_(difference(r, t)), d_(difference(s, t)) {
    const double ab = a_.x * b_.y - b_.x * a_.y;
    const double bc = b_.x * c_.y - c_.x * b_.y;
    const double cd = c_.x * d_.y - d_.x * c_.y;
    const double da = d_.x * a_.y - a_.x * d_.y;
    const double ac = a_.x * c_.y - c_.x * a_.y;
    const double bd = b_.x * d_.y - d_.x * b_.y;
    abc_ = a_.z * bc - b_.z * ac + c_.z * ab;
    bcd_ = b_.z * cd - c_.z * bd + d_.z * bc;
    cda_ = c_.z * da + d_.z * ac + a_.z * cd;
    dab_ = d_.z * ab + a_.z * bd + b_.z * da;
    const double x = largest(a_.x, b_.x, c_.x, d_.x);
    const double y = largest(a_.y, b_.y, c_.y, d_.y);
    const double z = largest(a_.z, b_.z, c_.z, d_.z);
    reach_ = larger(larger(x, y), z);
    // 0 where it may overflow, or what is lost to underflow may count.
    constexpr double least_known = 1e-50;
    constexpr double most_known = 1e50;
    const bool is_known = x > least_known && y > least_known && z > least_known && reach_ < most_known;
    volume_ = is_known ? x * y * z : 0;
  }

  /// By the coordinates; ON_ORIENTED_BOUNDARY when doubles do not tell.
  CGAL::Oriented_side by_coordinates() const {
    // 72 terms, none larger than the size, each after 8 roundings at most.
    constexpr double relative_error = 0x1p-42;
    return side_of(determinant(square(a_), square(b_), square(c_), square(d_)),
                   relative_error * volume_ * reach_ * reach_);
  }

  /// By how far the points are from some one sphere, which tells more than the coordinates when they nearly lie on it:
  /// their powers, the squared distances from its center less its squared radius, each known to 2^-53 of itself and
  /// `error`. The determinant of powers is that of coordinates, by row operations. ON_ORIENTED_BOUNDARY when doubles do
  /// not tell, or one is NaN.
  CGAL::Oriented_side by_powers(const std::array<double, 5>& powers, double error) const {
    const auto [a, b, c, d, e] = powers;
    const double most = larger(largest(a, b, c, d), std::abs(e));
    // With m the volume and u = 2^-53: a minor, at most 6 m, is known to 54 u m; a difference of powers, at most
    // 2 most, to 4 u most + 2 error; what follows rounds by 192 u m most.
    constexpr double of_powers = 0x1p-42;
    constexpr double of_errors = 0x1p6;
    return side_of(determinant(a - e, b - e, c - e, d - e), volume_ * (of_powers * most + of_errors * error));
  }

 private:
  struct Vector {
    double x, y, z;
  };
  template <class Point>
  static Vector difference(const Point& p, const Point& q) {
    return {p.x() - q.x(), p.y() - q.y(), p.z() - q.z()};
  }
  static double square(const Vector& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }
  static double larger(double a, double b) { return a > b ? a : b; }
  static double largest(double a, double b, double c, double d) {
    return larger(larger(std::abs(a), std::abs(b)), larger(std::abs(c), std::abs(d)));
  }
  /// Positive where the fifth point is inside of a positively oriented sphere.
  double determinant(double a, double b, double c, double d) const {
    return (c * dab_ - d * abc_) + (a * bcd_ - b * cda_);
  }
  CGAL::Oriented_side side_of(double determinant, double error) const {
    if (volume_ == 0) return CGAL::ON_ORIENTED_BOUNDARY;
    if (determinant > error) return CGAL::ON_POSITIVE_SIDE;
    if (-determinant > error) return CGAL::ON_NEGATIVE_SIDE;
    return CGAL::ON_ORIENTED_BOUNDARY;
  }

  Vector a_, b_, c_, d_;
  double abc_ = 0;
  double bcd_ = 0;
  double cda_ = 0;
  double dab_ = 0;
  double reach_ = 0;   ///< the largest coordinate
  double volume_ = 0;  ///< the product of the largest coordinates per axis
};

/// The squared distance of a point from a center less a squared radius, to 2^-53 of itself and 2^-97 times the squared
/// radius; NaN when it is larger than the squared radius. Requires that rounding is to nearest.
double power_by_double_doubles(const std::array<double, 3>& point, const std::array<double, 3>& center, double radius);

/// The kernel of Delaunay triangulations of points that lie on few spheres, up to rounding: there doubles and their
/// intervals decide little, and rational numbers would have to. Exact, and the decisions are those of CGAL's kernel.
struct Sphere_kernel_3 : CGAL::Exact_predicates_inexact_constructions_kernel {
  using Base = CGAL::Exact_predicates_inexact_constructions_kernel;

  struct Side_of_oriented_sphere_3 {
    using result_type = CGAL::Oriented_side;

    CGAL::Oriented_side operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s,
                                   const Point_3& t) const;
  };
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }
};

}  // namespace mesecina

/// As of the kernel it is made of: points are located by doubles first.
template <>
struct CGAL::Triangulation_structural_filtering_traits<mesecina::Sphere_kernel_3>
    : CGAL::Triangulation_structural_filtering_traits<mesecina::Sphere_kernel_3::Base> {};
