// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/svg_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesecina {
namespace {

Point_2 between(const Point_2& p, const Point_2& q, double t) { return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; }

/// Adds the extreme points of the curve in the direction of one coordinate. The curve's derivative is the quadratic
/// polynomial with the coefficients below.
void add_extremes(Box& box, const Point_2& start, const Svg_curve& curve, double Point_2::*coordinate) {
  const double d0 = curve.control_1.*coordinate - start.*coordinate;
  const double d1 = curve.control_2.*coordinate - curve.control_1.*coordinate;
  const double d2 = curve.end.*coordinate - curve.control_2.*coordinate;
  const double a = d0 - 2 * d1 + d2;
  const double b = d1 - d0;
  const double discriminant = b * b - a * d0;
  if (!(discriminant >= 0)) return;
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  for (const double t : {q / a, d0 / q}) {
    if (!(t > 0 && t < 1)) continue;
    const Point_2 p01 = between(start, curve.control_1, t);
    const Point_2 p12 = between(curve.control_1, curve.control_2, t);
    const Point_2 p23 = between(curve.control_2, curve.end, t);
    box.add(between(between(p01, p12, t), between(p12, p23, t), t));
  }
}

double distance_from_segment(const Point_2& p, const Point_2& from, const Point_2& to) {
  const double squared_length = squared_distance(from, to);
  if (squared_length == 0) return distance(p, from);
  const double along = ((p.x - from.x) * (to.x - from.x) + (p.y - from.y) * (to.y - from.y)) / squared_length;
  return distance(p, between(from, to, std::clamp(along, 0., 1.)));
}

/// A bound on the distance between a curve and its chord: 3/4 of the larger second difference of the control points,
/// or 3/4 of the larger distance of an inner control point from the chord. The second finds straight curves.
double chord_error(const Point_2& start, const Svg_curve& curve) {
  const auto second_difference = [](const Point_2& p, const Point_2& q, const Point_2& r) {
    return std::hypot(p.x - 2 * q.x + r.x, p.y - 2 * q.y + r.y);
  };
  return 0.75 * std::min(std::max(second_difference(start, curve.control_1, curve.control_2),
                                  second_difference(curve.control_1, curve.control_2, curve.end)),
                         std::max(distance_from_segment(curve.control_1, start, curve.end),
                                  distance_from_segment(curve.control_2, start, curve.end)));
}

void flatten_curve(const Point_2& start, const Svg_curve& curve, double tolerance, int depth, Ring_2& ring) {
  if (curve.is_straight || depth == 0 || !(chord_error(start, curve) > tolerance)) {
    ring.push_back(curve.end);
    return;
  }
  const Point_2 p01 = midpoint(start, curve.control_1);
  const Point_2 p12 = midpoint(curve.control_1, curve.control_2);
  const Point_2 p23 = midpoint(curve.control_2, curve.end);
  const Point_2 p012 = midpoint(p01, p12);
  const Point_2 p123 = midpoint(p12, p23);
  const Point_2 middle = midpoint(p012, p123);
  flatten_curve(start, {p01, p012, middle, false}, tolerance, depth - 1, ring);
  flatten_curve(middle, {p123, p23, curve.end, false}, tolerance, depth - 1, ring);
}

}  // namespace

Affine_2 Affine_2::operator*(const Affine_2& right) const {
  return {a * right.a + c * right.b, b * right.a + d * right.b,     a * right.c + c * right.d,
          b * right.c + d * right.d, a * right.e + c * right.f + e, b * right.e + d * right.f + f};
}

void Subpath::add_quadratic(const Point_2& control, const Point_2& to) {
  add_cubic(between(end(), control, 2. / 3), between(to, control, 2. / 3), to);
}

void Subpath::add_arc(const Affine_2& circle_to_plane, double from, double sweep, const Point_2& to) {
  const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 4) - 1e-9)));
  const double step = sweep / pieces;
  const double handle = 4. / 3 * std::tan(step / 4);
  for (int i = 0; i < pieces; ++i) {
    const double begin_angle = from + i * step;
    const double end_angle = from + (i + 1) * step;
    const Point_2 begin_point{std::cos(begin_angle), std::sin(begin_angle)};
    const Point_2 end_point{std::cos(end_angle), std::sin(end_angle)};
    add_cubic(circle_to_plane({begin_point.x - handle * begin_point.y, begin_point.y + handle * begin_point.x}),
              circle_to_plane({end_point.x + handle * end_point.y, end_point.y - handle * end_point.x}),
              i + 1 == pieces ? to : circle_to_plane(end_point));
  }
}

void Subpath::add_svg_arc(double radius_x, double radius_y, double rotation_degrees, bool large, bool positive_sweep,
                          const Point_2& to) {
  const Point_2 from = end();
  radius_x = std::abs(radius_x);
  radius_y = std::abs(radius_y);
  if (from == to) return;
  if (radius_x == 0 || radius_y == 0) {
    add_line(to);
    return;
  }
  const double angle = rotation_degrees * (std::numbers::pi / 180);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const Point_2 half{(from.x - to.x) / 2, (from.y - to.y) / 2};
  Point_2 on_circle{(cosine * half.x + sine * half.y) / radius_x, (cosine * half.y - sine * half.x) / radius_y};
  const double length = std::hypot(on_circle.x, on_circle.y);
  if (length > 1) {
    radius_x *= length;
    radius_y *= length;
    on_circle = {on_circle.x / length, on_circle.y / length};
  }
  const double squared_length = std::min(1., length * length);
  double distance_of_center = std::sqrt(std::max(0., 1 - squared_length) / squared_length);
  if (large == positive_sweep) distance_of_center = -distance_of_center;
  const Point_2 center{distance_of_center * on_circle.y, -distance_of_center * on_circle.x};
  const double from_angle = std::atan2(on_circle.y - center.y, on_circle.x - center.x);
  const double to_angle = std::atan2(-on_circle.y - center.y, -on_circle.x - center.x);
  double sweep = to_angle - from_angle;
  if (positive_sweep && sweep < 0) sweep += 2 * std::numbers::pi;
  if (!positive_sweep && sweep > 0) sweep -= 2 * std::numbers::pi;

  const Point_2 middle = midpoint(from, to);
  const Affine_2 circle_to_plane{cosine * radius_x, sine * radius_x, -sine * radius_y, cosine * radius_y, 0, 0};
  const Point_2 shift = circle_to_plane(center);
  add_arc(Affine_2{1, 0, 0, 1, middle.x + shift.x, middle.y + shift.y} * circle_to_plane, from_angle, sweep, to);
}

Subpath transformed(const Subpath& subpath, const Affine_2& transform) {
  Subpath result{transform(subpath.start), {}, subpath.is_closed};
  result.curves.reserve(subpath.curves.size());
  for (const Svg_curve& curve : subpath.curves) {
    result.curves.push_back(
        {transform(curve.control_1), transform(curve.control_2), transform(curve.end), curve.is_straight});
  }
  return result;
}

bool is_finite(const Subpath& subpath) {
  const auto is_finite_point = [](const Point_2& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  return is_finite_point(subpath.start) && std::ranges::all_of(subpath.curves, [&](const Svg_curve& curve) {
           return is_finite_point(curve.control_1) && is_finite_point(curve.control_2) && is_finite_point(curve.end);
         });
}

Box bounding_box(const Subpath& subpath) {
  Box box;
  box.add(subpath.start);
  Point_2 start = subpath.start;
  for (const Svg_curve& curve : subpath.curves) {
    box.add(curve.end);
    if (!curve.is_straight) {
      add_extremes(box, start, curve, &Point_2::x);
      add_extremes(box, start, curve, &Point_2::y);
    }
    start = curve.end;
  }
  return box;
}

Ring_2 flatten(const Subpath& subpath, double tolerance) {
  constexpr int deepest = 10;
  Ring_2 ring{subpath.start};
  Point_2 start = subpath.start;
  for (const Svg_curve& curve : subpath.curves) {
    flatten_curve(start, curve, tolerance, deepest, ring);
    start = curve.end;
  }
  return ring;
}

}  // namespace mesecina
