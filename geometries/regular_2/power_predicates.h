// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <array>
#include <vector>

#include "geometries/balls_2/balls_2.h"
#include "geometries/regular_2/double_double.h"

namespace mesecina {

/// Exact decisions about disks, named by their index. Intervals decide what they can, then numbers of 100 bits,
/// rationals the rest; that circles of circumscribed disks meet in a common sample is never computed. The weight of a
/// disk is its squared radius.
///
/// Not thread-safe. Decisions require that rounding is upwards, see `Upward_rounding`.
class Power_predicates {
 public:
  using Upward_rounding = CGAL::Protect_FPU_rounding<true>;

  /// The disks must outlive this. O(n). Throws Cancelled.
  Power_predicates(const Balls_2& balls, const Progress& progress);

  /// Where the circles of squared radii r^2 + alpha of two disks meet, on one side of a -> b, to about twice the digits
  /// of a double; where they nearly touch, that holds relative to their distance from the line of the centers. The
  /// nearest point of that line if they do not meet. The centers must differ. For any rounding.
  struct Precise_point {
    Point_2 point;
    Point_2 rest;
  };
  Precise_point crossing(int a, int b, double alpha, bool on_left) const;
  /// The point of equal power distance to three disks whose centers are not on a line, and that power distance; rounded
  /// from numbers of 100 bits, or rationals where these are too few. For any rounding.
  struct Power_vertex {
    Point_2 point;
    double power = 0;
  };
  Power_vertex power_vertex(int a, int b, int c) const;

  CGAL::Comparison_result compare_x(int a, int b) const;
  CGAL::Comparison_result compare_y(int a, int b) const;
  /// Of the centers.
  CGAL::Orientation orientation(int a, int b, int c) const;
  /// Of two centers and a point.
  CGAL::Orientation orientation(int a, int b, const Point_2& p) const;

  /// For counterclockwise centers a, b, c: positive iff the power distance between d and the circle orthogonal to a, b
  /// and c is negative, so that d belongs into a regular triangulation where a, b, c is a triangle; zero iff the four
  /// have one power vertex.
  CGAL::Oriented_side power_side(int a, int b, int c, int d) const;
  /// The same on a line: a and b have different centers, that of d is on their line.
  CGAL::Oriented_side power_side(int a, int b, int d) const;
  /// The same for one center: positive iff d is the larger disk.
  CGAL::Oriented_side power_side(int a, int d) const;
  CGAL::Comparison_result compare_power_distance(int at, int a, int b) const;

  /// Sign of (squared radius of the smallest circle orthogonal to the disks) - alpha.
  CGAL::Sign size_sign(int a, double alpha) const;
  CGAL::Sign size_sign(int a, int b, double alpha) const;
  CGAL::Sign size_sign(int a, int b, int c, double alpha) const;
  /// Sign of the power distance between d and the smallest circle orthogonal to a (and b): negative iff d is in
  /// conflict with it.
  CGAL::Sign conflict_sign(int a, int d) const;
  CGAL::Sign conflict_sign(int a, int b, int d) const;

 private:
  using Interval = CGAL::Interval_nt<false>;
  using Rational = CGAL::Exact_rational;
  /// A double and bounds of what it lacks. The difference of near numbers loses nothing.
  struct Split_interval {
    double high = 0;
    Interval low = 0;
    Split_interval() = default;
    explicit Split_interval(double value) : high(value) {}
    explicit Split_interval(const Double_double& value)
        : high(value.high()), low(value.low_lower_bound(), value.low_upper_bound()) {}
    explicit operator Interval() const { return Interval(high) + low; }
    Interval operator-(const Split_interval& other) const {
      return (Interval(high) - Interval(other.high)) + (low - other.low);
    }
  };
  /// A disk in one of the precisions: Number is what differences of its coordinates are computed in.
  template <class Coordinate_, class Number_ = Coordinate_>
  struct Lifted {
    using Coordinate = Coordinate_;
    using Number = Number_;
    Coordinate x;
    Coordinate y;
    Coordinate w;  ///< weight
  };
  using Rounded = Lifted<Split_interval, Interval>;
  struct Cached {
    int ball = -1;
    Lifted<Rational> value;
  };

  const Lifted<Rational>& exact(int ball) const;
  Lifted<Rational> compute_exact(int ball) const;
  bool have_common_contact(std::initializer_list<int> disks) const;
  bool touch_common_sample(std::initializer_list<int> disks) const;
  Rounded rounded(int ball) const;
  /// The sign that `function` gives, with the disks in the least precision that is certain. Where intervals are not,
  /// and `is_zero` says so, it is zero.
  template <class Function, class Is_zero, class... Disks>
  CGAL::Sign decide_unless(const Is_zero& is_zero, const Function& function, Disks... disks) const;
  template <class Function, class... Disks>
  CGAL::Sign decide(const Function& function, Disks... disks) const;

  const Balls_2& balls_;
  std::vector<Lifted<Double_double>> precise_;
  mutable std::vector<Cached> cache_;
};

}  // namespace mesecina
