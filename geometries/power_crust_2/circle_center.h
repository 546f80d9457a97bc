// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/point.h"

namespace mesecina {

template <class Number>
struct Vector {
  Number x;
  Number y;
};

template <class Number>
Number dot(const Vector<Number>& v, const Vector<Number>& w) {
  return v.x * w.x + v.y * w.y;
}

template <class Number>
Vector<Number> difference(const Point_2& p, const Point_2& q) {
  return {Number(p.x) - Number(q.x), Number(p.y) - Number(q.y)};
}

/// From a point on a circle to its center, times `factor`.
template <class Number>
struct Scaled_offset {
  Vector<Number> vector;
  Number factor;
};

/// From p to the center of the circle through p, q and r; the factor is four times the area of the triangle pqr,
/// positive when it is counterclockwise.
template <class Number>
Scaled_offset<Number> offset_of_center(const Point_2& p, const Point_2& q, const Point_2& r) {
  const auto to_q = difference<Number>(q, p);
  const auto to_r = difference<Number>(r, p);
  const Number q2 = dot(to_q, to_q);
  const Number r2 = dot(to_r, to_r);
  return {{to_r.y * q2 - to_q.y * r2, to_q.x * r2 - to_r.x * q2}, 2 * (to_q.x * to_r.y - to_q.y * to_r.x)};
}

}  // namespace mesecina
