// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/regular_2/power_predicates.h"

#include <array>
#include <cmath>

namespace mesecina {

namespace {

/// Direct-mapped: decisions about one place ask for the same few disks again and again.
constexpr std::size_t cache_size = 4096;

using Nearest_rounding = CGAL::Protect_FPU_rounding<true>;

template <class Number>
auto sign_of(const Number& number) {
  if constexpr (std::is_same_v<Number, Double_double>) {
    return number.sign();
  } else {
    return CGAL::sign(number);
  }
}

template <class Number>
Number square_of(const Number& number) {
  if constexpr (std::is_same_v<Number, Double_double>) {
    return number * number;
  } else {
    return CGAL::square(number);
  }
}

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
  const Number q2 = square_of(qx) + square_of(qy);
  const Number r2 = square_of(rx) + square_of(ry);
  const Number twice_cross = Number(2) * (qx * ry - qy * rx);
  const Number cx = (ry * q2 - qy * r2) / twice_cross;
  const Number cy = (qx * r2 - rx * q2) / twice_cross;
  return {px + cx, py + cy, square_of(cx) + square_of(cy)};
}

/// To the last of the digits that a Double_double holds, with an error that covers the rest; unknown beyond the range
/// of doubles.
Double_double nearest(const CGAL::Exact_rational& number) {
  const double high = CGAL::to_double(number);
  if (!std::isfinite(high)) return Double_double::about(high, 0);
  const double low = CGAL::to_double(CGAL::Exact_rational(number - CGAL::Exact_rational(high)));
  return Double_double::about(high, low);
}

/// Squared distance of the crossings of two circles from the line of the centers, and where their line cuts that: both
/// relative to the distance of the centers, which are at (0, 0) and (x, y).
template <class Number>
struct Chord {
  Number along;
  Number squared_height;
};
template <class Number>
Chord<Number> common_chord(const Number& x, const Number& y, const Number& wa, const Number& wb, double alpha) {
  const Number d2 = square_of(x) + square_of(y);
  const Number along = (d2 + wa - wb) / (Number(2) * d2);
  const Number w = wa + Number(alpha);
  return {along, w / d2 - square_of(along)};
}

/// From the first of three disks: the power vertex, and its squared distance.
template <class Number, class Lifted>
std::array<Number, 3> relative_power_vertex(const Lifted& p, const Lifted& q, const Lifted& r) {
  const Number qx = q.x - p.x;
  const Number qy = q.y - p.y;
  const Number rx = r.x - p.x;
  const Number ry = r.y - p.y;
  const Number q2 = square_of(qx) + square_of(qy) - q.w + p.w;
  const Number r2 = square_of(rx) + square_of(ry) - r.w + p.w;
  const Number twice_cross = Number(2) * (qx * ry - qy * rx);
  const Number x = (ry * q2 - qy * r2) / twice_cross;
  const Number y = (qx * r2 - rx * q2) / twice_cross;
  const Number squared_distance = square_of(x) + square_of(y);
  return {x, y, squared_distance};
}

}  // namespace

Power_predicates::Power_predicates(const Balls_2& balls, const Progress& progress) : balls_(balls), cache_(cache_size) {
  precise_.reserve(balls.size());
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (b % 4096 == 0) progress.check();
    if (balls.is_circumscribed()) {
      const auto contacts = balls.contacts_of(static_cast<int>(b));
      const auto& samples = *balls.samples;
      const auto circle = circumcircle<Double_double>(samples[contacts[0]], samples[contacts[1]], samples[contacts[2]]);
      precise_.push_back({circle.x, circle.y, circle.squared_radius});
      if (!precise_.back().x.is_known() || !precise_.back().y.is_known() || !precise_.back().w.is_known()) {
        const Lifted<Rational> exact = compute_exact(static_cast<int>(b));
        precise_.back() = {nearest(exact.x), nearest(exact.y), nearest(exact.w)};
      }
    } else {
      const Point_2 rest = balls.center_rests.empty() ? Point_2{} : balls.center_rests[b];
      precise_.push_back({Double_double(balls.centers[b].x, rest.x), Double_double(balls.centers[b].y, rest.y),
                          square_of(Double_double(balls.radii[b]))});
    }
  }
}

Power_predicates::Rounded Power_predicates::rounded(int ball) const {
  const Lifted<Double_double>& precise = precise_[ball];
  return {Split_interval(precise.x), Split_interval(precise.y), Split_interval(precise.w)};
}

Power_predicates::Lifted<Power_predicates::Rational> Power_predicates::compute_exact(int ball) const {
  if (!balls_.is_circumscribed()) {
    const auto& [x, y] = balls_.centers[ball];
    const Point_2 rest = balls_.center_rests.empty() ? Point_2{} : balls_.center_rests[ball];
    return {Rational(x) + Rational(rest.x), Rational(y) + Rational(rest.y), square_of(Rational(balls_.radii[ball]))};
  }
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
  return balls_.common_contact({disks.begin(), disks.size()}) >= 0;
}

bool Power_predicates::touch_common_sample(std::initializer_list<int> disks) const {
  return balls_.is_circumscribed() && have_common_contact(disks);
}

template <class Function, class Is_zero, class... Disks>
CGAL::Sign Power_predicates::decide_unless(const Is_zero& is_zero, const Function& function, Disks... disks) const {
  if (const auto sign = function(rounded(disks)...); CGAL::is_certain(sign)) return CGAL::get_certain(sign);
  if (is_zero()) return CGAL::ZERO;
  {
    const Nearest_rounding rounding(CGAL_FE_TONEAREST);
    if (const auto sign = function(precise_[disks]...); CGAL::is_certain(sign)) return CGAL::get_certain(sign);
  }
  return function(Lifted<Rational>(exact(disks))...);
}

template <class Function, class... Disks>
CGAL::Sign Power_predicates::decide(const Function& function, Disks... disks) const {
  return decide_unless([] { return false; }, function, disks...);
}

Power_predicates::Precise_point Power_predicates::crossing(int a, int b, double alpha, bool on_left) const {
  const Nearest_rounding rounding(CGAL_FE_TONEAREST);
  constexpr double part = 0x1p-80;
  const Lifted<Double_double>& p = precise_[a];
  const Lifted<Double_double>& q = precise_[b];
  Double_double x = q.x - p.x;
  Double_double y = q.y - p.y;
  Chord<Double_double> chord = common_chord(x, y, p.w, q.w, alpha);
  if (!chord.squared_height.is_known_to(part) || !chord.along.is_known_to(part)) {
    const Lifted<Rational> exact_p = compute_exact(a);
    const Lifted<Rational> exact_q = compute_exact(b);
    const Rational exact_x = exact_q.x - exact_p.x;
    const Rational exact_y = exact_q.y - exact_p.y;
    const auto exact_chord = common_chord<Rational>(exact_x, exact_y, exact_p.w, exact_q.w, alpha);
    x = nearest(exact_x);
    y = nearest(exact_y);
    chord = {nearest(exact_chord.along), nearest(exact_chord.squared_height)};
  }
  const Double_double height = sqrt(chord.squared_height);
  const Double_double across = on_left ? height : -height;
  const Double_double result_x = p.x + (chord.along * x - across * y);
  const Double_double result_y = p.y + (chord.along * y + across * x);
  return {{result_x.high(), result_y.high()}, {result_x.low(), result_y.low()}};
}

Power_predicates::Power_vertex Power_predicates::power_vertex(int a, int b, int c) const {
  const Nearest_rounding rounding(CGAL_FE_TONEAREST);
  constexpr double part = 0x1p-50;
  const Lifted<Double_double>& p = precise_[a];
  auto [x, y, d2] = relative_power_vertex<Double_double>(p, precise_[b], precise_[c]);
  Double_double power = d2 - p.w;
  if (!d2.is_known_to(part)) {
    const Lifted<Rational> exact_p = compute_exact(a);
    const auto exact_vertex = relative_power_vertex<Rational>(exact_p, compute_exact(b), compute_exact(c));
    x = nearest(exact_vertex[0]);
    y = nearest(exact_vertex[1]);
    power = nearest(Rational(exact_vertex[2] - exact_p.w));
  }
  return {{(p.x + x).high(), (p.y + y).high()}, power.high()};
}

CGAL::Comparison_result Power_predicates::compare_x(int a, int b) const {
  return decide(
      [](const auto& p, const auto& q) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        return sign_of(Number(p.x - q.x));
      },
      a, b);
}

CGAL::Comparison_result Power_predicates::compare_y(int a, int b) const {
  return decide(
      [](const auto& p, const auto& q) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        return sign_of(Number(p.y - q.y));
      },
      a, b);
}

CGAL::Orientation Power_predicates::orientation(int a, int b, int c) const {
  return decide(
      [](const auto& p, const auto& q, const auto& r) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        return sign_of(Number((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)));
      },
      a, b, c);
}

CGAL::Orientation Power_predicates::orientation(int a, int b, const Point_2& point) const {
  return decide(
      [&point](const auto& p, const auto& q) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        using Coordinate = typename std::decay_t<decltype(p)>::Coordinate;
        return sign_of(Number((q.x - p.x) * (Coordinate(point.y) - p.y) - (q.y - p.y) * (Coordinate(point.x) - p.x)));
      },
      a, b);
}

CGAL::Oriented_side Power_predicates::power_side(int a, int b, int c, int d) const {
  return decide_unless(
      [&] {
        return have_common_contact({a, b, c, d});
      },
      [](const auto& p, const auto& q, const auto& r, const auto& t) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        const Number px = p.x - t.x;
        const Number py = p.y - t.y;
        const Number qx = q.x - t.x;
        const Number qy = q.y - t.y;
        const Number rx = r.x - t.x;
        const Number ry = r.y - t.y;
        const Number p2 = square_of(px) + square_of(py) + (t.w - p.w);
        const Number q2 = square_of(qx) + square_of(qy) + (t.w - q.w);
        const Number r2 = square_of(rx) + square_of(ry) + (t.w - r.w);
        return sign_of(Number((px * qy - py * qx) * r2 + (qx * ry - qy * rx) * p2 + (rx * py - ry * px) * q2));
      },
      a, b, c, d);
}

CGAL::Oriented_side Power_predicates::power_side(int a, int b, int d) const {
  if (touch_common_sample({a, b, d})) return CGAL::ON_ORIENTED_BOUNDARY;
  return -conflict_sign(a, b, d);
}

CGAL::Oriented_side Power_predicates::power_side(int a, int d) const {
  return decide(
      [](const auto& p, const auto& t) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        return sign_of(Number(t.w - p.w));
      },
      a, d);
}

CGAL::Comparison_result Power_predicates::compare_power_distance(int at, int a, int b) const {
  return decide(
      [](const auto& o, const auto& p, const auto& q) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        const Number px = p.x - o.x;
        const Number py = p.y - o.y;
        const Number qx = q.x - o.x;
        const Number qy = q.y - o.y;
        return sign_of(Number(square_of(px) + square_of(py) - square_of(qx) - square_of(qy) + (q.w - p.w)));
      },
      at, a, b);
}

CGAL::Sign Power_predicates::size_sign(int a, double alpha) const {
  if (alpha >= 0) return alpha == 0 && balls_.radii[a] == 0 ? CGAL::ZERO : CGAL::NEGATIVE;
  return decide(
      [alpha](const auto& p) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        return sign_of(Number(-Number(p.w) - Number(alpha)));
      },
      a);
}

CGAL::Sign Power_predicates::size_sign(int a, int b, double alpha) const {
  return decide(
      [alpha](const auto& p, const auto& q) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        const Number x = q.x - p.x;
        const Number y = q.y - p.y;
        const Number d2 = square_of(x) + square_of(y);
        const Number s = d2 + (p.w - q.w);
        return sign_of(Number(square_of(s) - Number(4) * d2 * (Number(p.w) + Number(alpha))));
      },
      a, b);
}

CGAL::Sign Power_predicates::size_sign(int a, int b, int c, double alpha) const {
  if (touch_common_sample({a, b, c})) return CGAL::sign(-alpha);
  return decide(
      [alpha](const auto& p, const auto& q, const auto& r) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        const Number qx = q.x - p.x;
        const Number qy = q.y - p.y;
        const Number rx = r.x - p.x;
        const Number ry = r.y - p.y;
        const Number q2 = square_of(qx) + square_of(qy) + (p.w - q.w);
        const Number r2 = square_of(rx) + square_of(ry) + (p.w - r.w);
        const Number cross = qx * ry - qy * rx;
        const Number x = q2 * ry - r2 * qy;
        const Number y = r2 * qx - q2 * rx;
        return sign_of(
            Number(square_of(x) + square_of(y) - Number(4) * square_of(cross) * (Number(p.w) + Number(alpha))));
      },
      a, b, c);
}

CGAL::Sign Power_predicates::conflict_sign(int a, int d) const {
  return decide(
      [](const auto& p, const auto& t) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        const Number x = t.x - p.x;
        const Number y = t.y - p.y;
        return sign_of(Number(square_of(x) + square_of(y) + (p.w - t.w)));
      },
      a, d);
}

CGAL::Sign Power_predicates::conflict_sign(int a, int b, int d) const {
  return decide(
      [](const auto& p, const auto& q, const auto& t) {
        using Number = typename std::decay_t<decltype(p)>::Number;
        const Number qx = q.x - p.x;
        const Number qy = q.y - p.y;
        const Number tx = t.x - p.x;
        const Number ty = t.y - p.y;
        const Number d2 = square_of(qx) + square_of(qy);
        const Number t2 = square_of(tx) + square_of(ty);
        return sign_of(Number(d2 * (t2 + (p.w - t.w)) - (d2 + (p.w - q.w)) * (qx * tx + qy * ty)));
      },
      a, b, d);
}

}  // namespace mesecina
