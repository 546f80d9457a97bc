// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/clip_2.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace mesecina {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// Parameters of the part of from + t * direction, t in [0, longest], in the box (Liang and Barsky 1984).
std::optional<std::array<double, 2>> clip_line(const Point_2& from, const Point_2& direction, double longest,
                                               const Pixel_box& box) {
  double first = 0;
  double last = longest;
  const auto cut = [&](double start, double step, double low, double high) {
    if (step == 0) return start >= low && start <= high;
    double enter = (low - start) / step;
    double leave = (high - start) / step;
    if (enter > leave) std::swap(enter, leave);
    first = std::max(first, enter);
    last = std::min(last, leave);
    return first <= last;
  };
  if (!cut(from.x, direction.x, box.left, box.right) || !cut(from.y, direction.y, box.top, box.bottom))
    return std::nullopt;
  return std::array{first, last};
}

bool is_finite(const Point_2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

template <class Inside, class Cross>
std::vector<Point_2> clip_half_plane(const std::vector<Point_2>& ring, Inside inside, Cross cross) {
  std::vector<Point_2> result;
  result.reserve(ring.size() + 2);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point_2& p = ring[i];
    const Point_2& q = ring[(i + 1) % ring.size()];
    if (inside(p)) result.push_back(p);
    if (inside(p) != inside(q)) result.push_back(cross(p, q));
  }
  return result;
}

/// Angles where the circle crosses the lines that bound the box.
std::vector<double> crossing_angles(const Point_2& center, double radius, const Pixel_box& box) {
  std::vector<double> angles;
  for (const double x : {box.left, box.right}) {
    const double dx = x - center.x;
    if (std::abs(dx) >= radius) continue;
    const double dy = std::sqrt((radius - dx) * (radius + dx));
    angles.push_back(std::atan2(dy, dx));
    angles.push_back(std::atan2(-dy, dx));
  }
  for (const double y : {box.top, box.bottom}) {
    const double dy = y - center.y;
    if (std::abs(dy) >= radius) continue;
    const double dx = std::sqrt((radius - dy) * (radius + dy));
    angles.push_back(std::atan2(dy, dx));
    angles.push_back(std::atan2(dy, -dx));
  }
  return angles;
}

/// `angle` plus whole turns, in [0, full_turn).
double normalized(double angle) {
  angle = std::fmod(angle, full_turn);
  return angle < 0 ? angle + full_turn : angle;
}

}  // namespace

Pixel_box box_of(std::span<const Point_2> points) {
  Pixel_box box{points[0].x, points[0].y, points[0].x, points[0].y};
  for (const Point_2& p : points) {
    box.left = std::min(box.left, p.x);
    box.right = std::max(box.right, p.x);
    box.top = std::min(box.top, p.y);
    box.bottom = std::max(box.bottom, p.y);
  }
  if (!std::all_of(points.begin(), points.end(), is_finite))
    box.left = box.top = box.right = box.bottom = std::numeric_limits<double>::quiet_NaN();
  return box;
}

bool Pixel_arc::is_whole_circle() const { return std::abs(sweep) == full_turn; }

Pixel_arc whole_circle(const Point_2& center, double radius) {
  Pixel_arc circle{center, radius, 0, full_turn, {}, {}};
  circle.from = circle.to = {center.x + radius, center.y};
  return circle;
}

Pixel_arc arc_between(const Point_2& center, double radius, const Point_2& from, const Point_2& to,
                      bool counterclockwise) {
  Pixel_arc arc{center, radius, std::atan2(from.y - center.y, from.x - center.x), 0, from, to};
  const double end = std::atan2(to.y - center.y, to.x - center.x);
  if (from == to) return arc;
  arc.sweep = counterclockwise ? -normalized(arc.start - end) : normalized(end - arc.start);
  return arc;
}

void Pixel_rings::add(std::span<const Point_2> ring) {
  if (ring.size() < 3) return;
  points.insert(points.end(), ring.begin(), ring.end());
  ends.push_back(points.size());
}

std::optional<std::array<Point_2, 2>> clip_segment(const Point_2& from, const Point_2& to, const Pixel_box& box) {
  if (!is_finite(from) || !is_finite(to)) return std::nullopt;
  const Point_2 step{to.x - from.x, to.y - from.y};
  const auto part = clip_line(from, step, 1, box);
  if (!part) return std::nullopt;
  const auto at = [&](double t) { return Point_2{from.x + t * step.x, from.y + t * step.y}; };
  return std::array{(*part)[0] == 0 ? from : at((*part)[0]), (*part)[1] == 1 ? to : at((*part)[1])};
}

std::optional<std::array<Point_2, 2>> clip_ray(const Point_2& from, const Point_2& direction, const Pixel_box& box) {
  if (!is_finite(from) || !is_finite(direction) || (direction.x == 0 && direction.y == 0)) return std::nullopt;
  const auto part = clip_line(from, direction, std::numeric_limits<double>::infinity(), box);
  if (!part) return std::nullopt;
  const auto at = [&](double t) { return Point_2{from.x + t * direction.x, from.y + t * direction.y}; };
  return std::array{(*part)[0] == 0 ? from : at((*part)[0]), at((*part)[1])};
}

std::vector<Point_2> clip_ring(std::span<const Point_2> ring, const Pixel_box& box) {
  std::vector<Point_2> result(ring.begin(), ring.end());
  if (!std::all_of(result.begin(), result.end(), is_finite)) return {};
  const auto cross_x = [](double x) {
    return [x](const Point_2& p, const Point_2& q) {
      return Point_2{x, p.y + (q.y - p.y) * ((x - p.x) / (q.x - p.x))};
    };
  };
  const auto cross_y = [](double y) {
    return [y](const Point_2& p, const Point_2& q) {
      return Point_2{p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)), y};
    };
  };
  result = clip_half_plane(
      result, [&](const Point_2& p) { return p.x >= box.left; }, cross_x(box.left));
  result = clip_half_plane(
      result, [&](const Point_2& p) { return p.x <= box.right; }, cross_x(box.right));
  result = clip_half_plane(
      result, [&](const Point_2& p) { return p.y >= box.top; }, cross_y(box.top));
  return clip_half_plane(
      result, [&](const Point_2& p) { return p.y <= box.bottom; }, cross_y(box.bottom));
}

std::vector<Pixel_arc> clip_arc(const Pixel_arc& arc, const Pixel_box& box) {
  const double length = std::abs(arc.sweep);
  const double sign = arc.sweep < 0 ? -1 : 1;
  std::vector<double> offsets{0, length};
  for (const double angle : crossing_angles(arc.center, arc.radius, box)) {
    const double offset = normalized(sign * (angle - arc.start));
    if (offset < length) offsets.push_back(offset);
  }
  std::sort(offsets.begin(), offsets.end());
  std::vector<Pixel_arc> pieces;
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
    const double first = offsets[i];
    const double last = offsets[i + 1];
    if (first == last || !box.contains(arc.at(arc.start + sign * (first + last) / 2))) continue;
    const double start = arc.start + sign * first;
    pieces.push_back({arc.center, arc.radius, start, sign * (last - first), first == 0 ? arc.from : arc.at(start),
                      last == length ? arc.to : arc.at(arc.start + sign * last)});
  }
  return pieces;
}

void append_polyline(const Pixel_arc& arc, const Pixel_box& box, double tolerance, std::vector<Point_2>& points) {
  struct Piece {
    double end = 0;  ///< part of the sweep
    Point_2 to;
  };
  constexpr double smallest_part = 1e-9;
  std::vector<Piece> ahead{{1, arc.to}};
  double begin = 0;
  Point_2 from = arc.from;
  while (!ahead.empty()) {
    const auto [end, to] = ahead.back();
    const double angle = std::abs(arc.sweep) * (end - begin);
    const double half_sine = std::sin(angle / 4);
    const double height = 2 * arc.radius * half_sine * half_sine;
    const Pixel_box around{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x),
                           std::max(from.y, to.y)};
    const bool is_fine = height <= tolerance || end - begin < smallest_part;
    if (is_fine || (angle < full_turn / 4 && !box.meets(around.grown(height)))) {
      points.push_back(to);
      begin = end;
      from = to;
      ahead.pop_back();
    } else {
      const double middle = (begin + end) / 2;
      ahead.push_back({middle, arc.at(arc.start + arc.sweep * middle)});
    }
  }
}

std::vector<Point_2> clip_disk(const Point_2& center, double radius, const Pixel_box& box) {
  constexpr double tolerance = 0.01;
  std::vector<Point_2> points;
  for (const Point_2& corner : {Point_2{box.left, box.top}, Point_2{box.right, box.top}, Point_2{box.right, box.bottom},
                                Point_2{box.left, box.bottom}})
    if (distance(corner, center) <= radius) points.push_back(corner);
  const double step = std::sqrt(8 * tolerance / radius);
  for (const Pixel_arc& piece : clip_arc(whole_circle(center, radius), box)) {
    const double count = std::ceil(piece.sweep / step);
    for (double i = 0; i <= count; ++i) points.push_back(piece.at(piece.start + piece.sweep * (i / count)));
  }
  if (points.size() < 3) return {};
  Point_2 middle;
  for (const Point_2& p : points) {
    middle.x += p.x / static_cast<double>(points.size());
    middle.y += p.y / static_cast<double>(points.size());
  }
  std::sort(points.begin(), points.end(), [&](const Point_2& p, const Point_2& q) {
    return std::atan2(p.y - middle.y, p.x - middle.x) < std::atan2(q.y - middle.y, q.x - middle.x);
  });
  return points;
}

std::vector<Bezier> to_beziers(const Pixel_arc& arc) {
  // A cubic over the angle a leaves the circle by about 2.7e-4 (a / 90°)^6 of the radius.
  constexpr double tolerance = 0.005;
  const double quarter = full_turn / 4;
  const double widest = quarter * std::min(1.0, std::pow(tolerance / (2.7e-4 * std::max(arc.radius, 1e-9)), 1.0 / 6));
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(arc.sweep) / widest - 1e-9)));
  const double angle = arc.sweep / count;
  const double reach = arc.radius * 4 / 3 * std::tan(angle / 4);
  std::vector<Bezier> curves;
  curves.reserve(static_cast<std::size_t>(count));
  Point_2 from = arc.from;
  for (int i = 0; i < count; ++i) {
    const double a = arc.start + angle * i;
    const double b = arc.start + angle * (i + 1);
    const Point_2 to = i + 1 == count ? arc.to : arc.at(b);
    curves.push_back({{from.x - reach * std::sin(a), from.y + reach * std::cos(a)},
                      {to.x + reach * std::sin(b), to.y - reach * std::cos(b)},
                      to});
    from = to;
  }
  return curves;
}

}  // namespace mesecina
