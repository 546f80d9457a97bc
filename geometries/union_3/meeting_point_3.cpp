// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/meeting_point_3.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <numeric>
#include <utility>

#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Rational = CGAL::Exact_rational;
using Interval = CGAL::Interval_nt<true>;

template <class Number>
struct Vector {
  Number x, y, z;
};
template <class Number>
Number product(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
Vector<Number> normal(const Vector<Number>& a, const Vector<Number>& b) {
  return {Number(a.y * b.z - a.z * b.y), Number(a.z * b.x - a.x * b.z), Number(a.x * b.y - a.y * b.x)};
}
template <class Number>
Vector<Number> vector(const Ball_3& from, const Ball_3& to) {
  return {Number(Number(to.center.x) - Number(from.center.x)), Number(Number(to.center.y) - Number(from.center.y)),
          Number(Number(to.center.z) - Number(from.center.z))};
}
template <class Number>
Number weight(const Ball_3& ball) {
  return Number(ball.radius * ball.radius);
}

/// The point a meeting name means: (foot + root(height) n) / square, from the first center, n being the normal with
/// the sign of the side and `square` its square.
template <class Number>
struct Meeting_point {
  Vector<Number> foot;
  Vector<Number> n;
  Number square;
  Number height;

  Meeting_point(std::span<const Ball_3> balls, const Meeting_name_3& name) {
    const Ball_3& a = balls[name.balls[0]];
    const Ball_3& b = balls[name.balls[1]];
    const Ball_3& c = balls[name.balls[2]];
    const Vector<Number> u = vector<Number>(a, b);
    const Vector<Number> v = vector<Number>(a, c);
    n = name.is_above ? normal(u, v) : normal(v, u);
    square = product(n, n);
    const Number s = (product(u, u) + weight<Number>(a) - weight<Number>(b)) / Number(2);
    const Number t = (product(v, v) + weight<Number>(a) - weight<Number>(c)) / Number(2);
    const Vector<Number> w = normal(u, v);
    const Vector<Number> vw = normal(v, w);
    const Vector<Number> wu = normal(w, u);
    foot = {Number(s * vw.x + t * wu.x), Number(s * vw.y + t * wu.y), Number(s * vw.z + t * wu.z)};
    height = weight<Number>(a) * square - product(foot, foot) / square;
  }
  /// Of the function constant + direction . point, from the first center, times the square: the part without the root,
  /// and the factor of the root.
  std::array<Number, 2> value(const Number& constant, const Vector<Number>& direction) const {
    return {Number(constant * square + product(direction, foot)), product(direction, n)};
  }
  /// Power to the ball.
  std::array<Number, 2> power(const Ball_3& first, const Ball_3& ball) const {
    const Vector<Number> u = vector<Number>(first, ball);
    const Number constant = product(u, u) + weight<Number>(first) - weight<Number>(ball);
    return value(constant, {Number(-2 * u.x), Number(-2 * u.y), Number(-2 * u.z)});
  }
  /// Height above the plane of three centers.
  std::array<Number, 2> elevation(const Ball_3& first, const Ball_3& a, const Ball_3& b, const Ball_3& c) const {
    const Vector<Number> up = normal(vector<Number>(a, b), vector<Number>(a, c));
    return value(Number(-product(up, vector<Number>(first, a))), up);
  }
};

bool is_certainly_not_zero(const std::array<Interval, 2>& value, const Interval& height) {
  const Interval root = CGAL::sqrt(Interval(std::max(0.0, height.inf()), std::max(0.0, height.sup())));
  const Interval sum = value[0] + value[1] * root;
  return sum.inf() > 0 || sum.sup() < 0;
}

int sign_with_root(const std::array<Rational, 2>& value, const Rational& height) {
  const int sign_a = static_cast<int>(CGAL::sign(value[0]));
  const int sign_b = CGAL::sign(height) == CGAL::ZERO ? 0 : static_cast<int>(CGAL::sign(value[1]));
  if (sign_a == 0 || sign_b == 0 || sign_a == sign_b) return sign_a != 0 ? sign_a : sign_b;
  return sign_a * static_cast<int>(CGAL::sign(Rational(value[0] * value[0] - value[1] * value[1] * height)));
}

bool is_same(std::span<const Ball_3> balls, const Meeting_name_3& name, const Meeting_name_3& other) {
  const Ball_3& first = balls[name.balls[0]];
  std::vector<int> others;
  for (const int ball : other.balls)
    if (std::ranges::find(name.balls, ball) == name.balls.end()) others.push_back(ball);
  const Meeting_point<Interval> rough(balls, name);
  for (const int ball : others)
    if (is_certainly_not_zero(rough.power(first, balls[ball]), rough.height)) return false;
  const Meeting_point<Rational> point(balls, name);
  for (const int ball : others)
    if (sign_with_root(point.power(first, balls[ball]), point.height) != 0) return false;
  // It is one of the two points of the other name.
  const auto& b = other.balls;
  const int side = sign_with_root(point.elevation(first, balls[b[0]], balls[b[1]], balls[b[2]]), point.height);
  return side == 0 || (side > 0) == other.is_above;
}

}  // namespace

Point_3 exact_meeting_point(const Ball_3& a, const Ball_3& b, const Ball_3& c, bool is_above) {
  const std::array<Ball_3, 3> balls{a, b, c};
  const Meeting_point<Rational> point(balls, {{0, 1, 2}, is_above});
  // The square of a normal may lie beyond the range of doubles.
  const Rational largest = std::max({Rational(abs(point.n.x)), Rational(abs(point.n.y)), Rational(abs(point.n.z))});
  const Point_3 along{CGAL::to_double(Rational(point.n.x / largest)), CGAL::to_double(Rational(point.n.y / largest)),
                      CGAL::to_double(Rational(point.n.z / largest))};
  const double height = std::sqrt(std::max(0.0, CGAL::to_double(Rational(point.height / point.square))));
  const Point_3 foot{CGAL::to_double(Rational(Rational(a.center.x) + point.foot.x / point.square)),
                     CGAL::to_double(Rational(Rational(a.center.y) + point.foot.y / point.square)),
                     CGAL::to_double(Rational(Rational(a.center.z) + point.foot.z / point.square))};
  return foot + (height / std::sqrt(dot(along, along))) * along;
}

std::vector<int> first_of_same_points(std::span<const Ball_3> balls, std::span<const Meeting_name_3> names,
                                      std::span<const Point_3> points, Progress& progress) {
  // Along a direction across which surfaces are not likely to be flat.
  const Point_3 direction{0.53, 0.61, 0.59};
  struct Place {
    double along;
    int number;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> places(points.size());
  parallel_for(places.size(), progress, [&](std::size_t i) {
    places[i] = {dot(points[i], direction), static_cast<int>(i)};
  });
  parallel_region(progress, [&] { tbb::parallel_sort(places.begin(), places.end(), std::less<>()); });
  // Of the balls, as all points may be one.
  Box box;
  for (const auto& [center, radius] : balls) {
    const Point_3 extent{radius, radius, radius};
    box.add(center - extent);
    box.add(center + extent);
  }
  // What rounding does to the point of spheres that nearly touch.
  const double reach = 3e-8 * box.diagonal();
  std::vector<int> first(points.size());
  std::iota(first.begin(), first.end(), 0);
  const auto root = [&first](int i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = i + 1; j < places.size() && places[j].along - places[i].along <= reach; ++j) {
      const int p = places[i].number;
      const int q = places[j].number;
      const int a = root(p);
      const int b = root(q);
      if (a == b || squared_distance(points[p], points[q]) > reach * reach) continue;
      if (is_same(balls, names[p], names[q])) first[std::max(a, b)] = std::min(a, b);
    }
  }
  for (int i = 0; i < static_cast<int>(first.size()); ++i) first[i] = root(i);
  return first;
}

}  // namespace mesecina
