// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/power_center_3.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>

namespace mesecina {

namespace {

using Unprotected_interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Exact_rational;

template <class Number>
using Coordinates = std::array<Number, 3>;

/// A ball as the regular triangulation knows it.
struct Weighted_center {
  Point_3 center;
  double weight = 0;
};

/// From the center of the first ball to the point of equal power distance to all four.
template <class Number>
Coordinates<Number> offset_of_power_center(const std::array<Weighted_center, 4>& balls) {
  const Point_3& origin = balls[0].center;
  std::array<Coordinates<Number>, 3> to{};
  Coordinates<Number> power{};
  for (int i = 0; i < 3; ++i) {
    const Point_3& c = balls[i + 1].center;
    to[i] = {Number(c.x) - Number(origin.x), Number(c.y) - Number(origin.y), Number(c.z) - Number(origin.z)};
    power[i] = to[i][0] * to[i][0] + to[i][1] * to[i][1] + to[i][2] * to[i][2] + Number(balls[0].weight) -
               Number(balls[i + 1].weight);
  }
  const auto minor = [&to](int i, int j, int k) -> Number {
    return to[i][(k + 1) % 3] * to[j][(k + 2) % 3] - to[i][(k + 2) % 3] * to[j][(k + 1) % 3];
  };
  const Number twice_volume = 2 * (to[0][0] * minor(1, 2, 0) + to[0][1] * minor(1, 2, 1) + to[0][2] * minor(1, 2, 2));
  Coordinates<Number> result{};
  for (int k = 0; k < 3; ++k)
    result[k] = (power[0] * minor(1, 2, k) + power[1] * minor(2, 0, k) + power[2] * minor(0, 1, k)) / twice_volume;
  return result;
}

/// Wants upward rounding.
Point_3 rounded_power_center(const std::array<Weighted_center, 4>& balls, double error) {
  const auto rough = offset_of_power_center<Unprotected_interval>(balls);
  const auto is_sure = [error](const Unprotected_interval& x) { return x.sup() - x.inf() <= error; };
  if (std::ranges::all_of(rough, is_sure)) {
    const auto middle = [](const Unprotected_interval& x) { return (x.inf() + x.sup()) / 2; };
    return balls[0].center + Point_3{middle(rough[0]), middle(rough[1]), middle(rough[2])};
  }
  const auto sure = offset_of_power_center<Rational>(balls);
  const Point_3& c = balls[0].center;
  return {CGAL::to_double(Rational(c.x) + sure[0]), CGAL::to_double(Rational(c.y) + sure[1]),
          CGAL::to_double(Rational(c.z) + sure[2])};
}

}  // namespace

Point_3 power_center(const Regular_3& regular, int cell, double error) {
  std::array<Weighted_center, 4> balls{};
  for (int i = 0; i < 4; ++i) {
    const auto& [center, radius] = regular.balls[regular.cells[cell][i]];
    balls[i] = {center, radius * radius};
  }
  std::ranges::stable_sort(balls, {}, &Weighted_center::weight);
  const CGAL::Protect_FPU_rounding<true> upward_rounding;
  return rounded_power_center(balls, error);
}

}  // namespace mesecina
