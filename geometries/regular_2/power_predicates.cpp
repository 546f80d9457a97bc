// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/regular_2/power_predicates.h"

#include <CGAL/Uncertain.h>
#include <CGAL/predicates/kernel_ftC2.h>

#include <cmath>

namespace mesecina {

namespace {

/// Direct-mapped: decisions about one place ask for the same few disks again and again.
constexpr std::size_t cache_size = 4096;

template <class Number>
struct Circle {
  Number x;
  Number y;
  Number squared_radius;
};

/// Of the circle through three points that are not on a line.
template <class Number>
Circle<Number> circumcircle(const Point_2& p, const Point_2& q, const Point_2& r) {
  const Number px(p.x);
  const Number py(p.y);
  const Number qx = Number(q.x) - px;
  const Number qy = Number(q.y) - py;
  const Number rx = Number(r.x) - px;
  const Number ry = Number(r.y) - py;
  const Number q2 = CGAL_NTS square(qx) + CGAL_NTS square(qy);
  const Number r2 = CGAL_NTS square(rx) + CGAL_NTS square(ry);
  const Number twice_cross = 2 * (qx * ry - qy * rx);
  const Number cx = (ry * q2 - qy * r2) / twice_cross;
  const Number cy = (qx * r2 - rx * q2) / twice_cross;
  return {px + cx, py + cy, CGAL_NTS square(cx) + CGAL_NTS square(cy)};
}

bool is_bounded(const CGAL::Interval_nt<false>& interval) {
  return std::isfinite(interval.inf()) && std::isfinite(interval.sup());
}

}  // namespace

Power_predicates::Power_predicates(const Balls_2& balls) : balls_(balls), cache_(cache_size) {
  const Upward_rounding rounding;
  intervals_.reserve(balls.size());
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (!balls.is_circumscribed()) {
      intervals_.push_back(
          {Interval(balls.centers[b].x), Interval(balls.centers[b].y), CGAL_NTS square(Interval(balls.radii[b]))});
      continue;
    }
    const auto contacts = balls.contacts_of(static_cast<int>(b));
    const auto& samples = *balls.samples;
    const auto circle = circumcircle<Interval>(samples[contacts[0]], samples[contacts[1]], samples[contacts[2]]);
    if (is_bounded(circle.x) && is_bounded(circle.y) && is_bounded(circle.squared_radius)) {
      intervals_.push_back({circle.x, circle.y, circle.squared_radius});
    } else {
      const Lifted<Rational> value = compute_exact(static_cast<int>(b));
      intervals_.push_back({Interval(CGAL_NTS to_interval(value.x)), Interval(CGAL_NTS to_interval(value.y)),
                            Interval(CGAL_NTS to_interval(value.w))});
    }
  }
}

Power_predicates::Lifted<Power_predicates::Rational> Power_predicates::compute_exact(int ball) const {
  if (!balls_.is_circumscribed())
    return {Rational(balls_.centers[ball].x), Rational(balls_.centers[ball].y),
            CGAL_NTS square(Rational(balls_.radii[ball]))};
  const auto contacts = balls_.contacts_of(ball);
  const auto& samples = *balls_.samples;
  auto circle = circumcircle<Rational>(samples[contacts[0]], samples[contacts[1]], samples[contacts[2]]);
  return {std::move(circle.x), std::move(circle.y), std::move(circle.squared_radius)};
}

const Power_predicates::Lifted<Power_predicates::Rational>& Power_predicates::exact(int ball) const {
  Cached& place = cache_[static_cast<std::size_t>(ball) % cache_.size()];
  if (place.ball != ball) {
    place.value = compute_exact(ball);
    place.ball = ball;
  }
  return place.value;
}

bool Power_predicates::have_common_contact(std::initializer_list<int> disks) const {
  return balls_.is_circumscribed() && balls_.common_contact({disks.begin(), disks.size()}) >= 0;
}

template <class Function>
auto Power_predicates::decide(const Function& function, std::initializer_list<int> disks) const {
  const int* d = disks.begin();
  const auto is_sure = [](const auto& answer) { return CGAL::is_certain(answer); };
  const auto at = [&](int i) -> const Lifted<Interval>& { return intervals_[d[i]]; };
  if constexpr (std::is_invocable_v<Function, Lifted<Interval>, Lifted<Interval>>) {
    if (const auto answer = function(at(0), at(1)); is_sure(answer)) return CGAL::get_certain(answer);
    const Lifted<Rational> a = exact(d[0]);
    return function(a, exact(d[1]));
  } else if constexpr (std::is_invocable_v<Function, Lifted<Interval>, Lifted<Interval>, Lifted<Interval>>) {
    if (const auto answer = function(at(0), at(1), at(2)); is_sure(answer)) return CGAL::get_certain(answer);
    const Lifted<Rational> a = exact(d[0]);
    const Lifted<Rational> b = exact(d[1]);
    return function(a, b, exact(d[2]));
  } else {
    if (const auto answer = function(at(0), at(1), at(2), at(3)); is_sure(answer)) return CGAL::get_certain(answer);
    const Lifted<Rational> a = exact(d[0]);
    const Lifted<Rational> b = exact(d[1]);
    const Lifted<Rational> c = exact(d[2]);
    return function(a, b, c, exact(d[3]));
  }
}

CGAL::Comparison_result Power_predicates::compare_x(int a, int b) const {
  return decide([](const auto& p, const auto& q) { return CGAL_NTS compare(p.x, q.x); }, {a, b});
}

CGAL::Comparison_result Power_predicates::compare_y(int a, int b) const {
  return decide([](const auto& p, const auto& q) { return CGAL_NTS compare(p.y, q.y); }, {a, b});
}

CGAL::Orientation Power_predicates::orientation(int a, int b, int c) const {
  return decide(
      [](const auto& p, const auto& q, const auto& r) { return CGAL::orientationC2(p.x, p.y, q.x, q.y, r.x, r.y); },
      {a, b, c});
}

CGAL::Orientation Power_predicates::orientation(int a, int b, const Point_2& point) const {
  return decide(
      [&point](const auto& p, const auto& q) {
        using Number = std::decay_t<decltype(p.x)>;
        return CGAL::orientationC2(p.x, p.y, q.x, q.y, Number(point.x), Number(point.y));
      },
      {a, b});
}

CGAL::Oriented_side Power_predicates::power_side(int a, int b, int c, int d) const {
  if (have_common_contact({a, b, c, d})) return CGAL::ON_ORIENTED_BOUNDARY;
  return CGAL::enum_cast<CGAL::Oriented_side>(decide(
      [](const auto& p, const auto& q, const auto& r, const auto& t) {
        using Number = std::decay_t<decltype(p.x)>;
        const auto lift = [&t](const auto& of, const Number& x, const Number& y) -> Number {
          return CGAL_NTS square(x) + CGAL_NTS square(y) - of.w + t.w;
        };
        const Number px = p.x - t.x;
        const Number py = p.y - t.y;
        const Number qx = q.x - t.x;
        const Number qy = q.y - t.y;
        const Number rx = r.x - t.x;
        const Number ry = r.y - t.y;
        return CGAL::sign_of_determinant<Number>(px, py, lift(p, px, py), qx, qy, lift(q, qx, qy), rx, ry,
                                                 lift(r, rx, ry));
      },
      {a, b, c, d}));
}

CGAL::Oriented_side Power_predicates::power_side(int a, int b, int d) const {
  if (have_common_contact({a, b, d})) return CGAL::ON_ORIENTED_BOUNDARY;
  return CGAL::enum_cast<CGAL::Oriented_side>(-conflict_sign(a, b, d));
}

CGAL::Oriented_side Power_predicates::power_side(int a, int d) const {
  return decide(
      [](const auto& p, const auto& t) { return CGAL::enum_cast<CGAL::Oriented_side>(CGAL_NTS compare(t.w, p.w)); },
      {a, d});
}

CGAL::Comparison_result Power_predicates::compare_power_distance(int at, int a, int b) const {
  return decide(
      [](const auto& o, const auto& p, const auto& q) {
        return CGAL_NTS compare(CGAL_NTS square(p.x - o.x) + CGAL_NTS square(p.y - o.y) - p.w,
                                CGAL_NTS square(q.x - o.x) + CGAL_NTS square(q.y - o.y) - q.w);
      },
      {at, a, b});
}

CGAL::Sign Power_predicates::size_sign(int a, double alpha) const {
  if (alpha >= 0) return alpha == 0 && balls_.radii[a] == 0 ? CGAL::ZERO : CGAL::NEGATIVE;
  return decide(
      [alpha](const auto& p, const auto&) {
        using Number = std::decay_t<decltype(p.x)>;
        return CGAL_NTS sign(-p.w - Number(alpha));
      },
      {a, a});
}

CGAL::Sign Power_predicates::size_sign(int a, int b, double alpha) const {
  return decide(
      [alpha](const auto& p, const auto& q) {
        using Number = std::decay_t<decltype(p.x)>;
        const Number d2 = CGAL_NTS square(q.x - p.x) + CGAL_NTS square(q.y - p.y);
        return CGAL_NTS sign(CGAL_NTS square(d2 + p.w - q.w) - 4 * d2 * (p.w + Number(alpha)));
      },
      {a, b});
}

CGAL::Sign Power_predicates::size_sign(int a, int b, int c, double alpha) const {
  if (have_common_contact({a, b, c})) return CGAL_NTS sign(-alpha);
  return decide(
      [alpha](const auto& p, const auto& q, const auto& r) {
        using Number = std::decay_t<decltype(p.x)>;
        const Number qx = q.x - p.x;
        const Number qy = q.y - p.y;
        const Number rx = r.x - p.x;
        const Number ry = r.y - p.y;
        const Number q2 = CGAL_NTS square(qx) + CGAL_NTS square(qy) - q.w + p.w;
        const Number r2 = CGAL_NTS square(rx) + CGAL_NTS square(ry) - r.w + p.w;
        const Number cross = qx * ry - qy * rx;
        return CGAL_NTS sign(CGAL_NTS square(q2 * ry - r2 * qy) + CGAL_NTS square(r2 * qx - q2 * rx) -
                             4 * CGAL_NTS square(cross) * (p.w + Number(alpha)));
      },
      {a, b, c});
}

CGAL::Sign Power_predicates::conflict_sign(int a, int d) const {
  return decide(
      [](const auto& p, const auto& t) {
        using Number = std::decay_t<decltype(p.x)>;
        const Number distance = CGAL_NTS square(t.x - p.x) + CGAL_NTS square(t.y - p.y);
        return CGAL_NTS sign(distance - t.w + p.w);
      },
      {a, d});
}

CGAL::Sign Power_predicates::conflict_sign(int a, int b, int d) const {
  return decide(
      [](const auto& p, const auto& q, const auto& t) {
        using Number = std::decay_t<decltype(p.x)>;
        const Number qx = q.x - p.x;
        const Number qy = q.y - p.y;
        const Number tx = t.x - p.x;
        const Number ty = t.y - p.y;
        const Number d2 = CGAL_NTS square(qx) + CGAL_NTS square(qy);
        return CGAL_NTS sign(d2 * (CGAL_NTS square(tx) + CGAL_NTS square(ty) + p.w - t.w) -
                             (d2 + p.w - q.w) * (qx * tx + qy * ty));
      },
      {a, b, d});
}

}  // namespace mesecina
