// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/generators_2.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app2d/edits_2.h"
#include "core/portable_random.h"

namespace mesecina {

namespace {

constexpr double turn = 2 * std::numbers::pi;

double width_of(const Box& box) { return box.upper.x - box.lower.x; }
double height_of(const Box& box) { return box.upper.y - box.lower.y; }
Point_2 center_of(const Box& box) { return {(box.lower.x + box.upper.x) / 2, (box.lower.y + box.upper.y) / 2}; }
double half_side(const Box& box) { return std::min(width_of(box), height_of(box)) / 2; }

Point_2 random_in(Portable_random& random, const Box& box) {
  const double x = random.within(box.lower.x, box.upper.x);
  return {x, random.within(box.lower.y, box.upper.y)};
}

std::vector<Point_2> uniform(const Generator_order_2& order) {
  Portable_random random(order.seed);
  std::vector<Point_2> points;
  points.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i) points.push_back(random_in(random, order.box));
  return points;
}

/// Rows and columns of about square cells; a power of two as step, so that rows and columns are exactly straight.
struct Lattice {
  std::size_t columns = 1;
  std::size_t rows = 1;
  double step = 1;
  Point_2 first;
};
Lattice lattice_of(const Generator_order_2& order) {
  Lattice lattice;
  const double aspect = width_of(order.box) / std::max(height_of(order.box), 1e-300);
  const double wanted = std::max<double>(1, std::round(std::sqrt(static_cast<double>(order.count) * aspect)));
  lattice.columns = std::clamp<std::size_t>(static_cast<std::size_t>(wanted), 1, std::max<std::size_t>(1, order.count));
  lattice.rows = (order.count + lattice.columns - 1) / lattice.columns;
  const double span = std::max(1.0, static_cast<double>(std::max(lattice.columns, lattice.rows)) - 1);
  const double exact = 2 * half_side(order.box) / span;
  // Few significant bits: sums and products with small whole numbers have no rounding.
  const double unit = std::exp2(std::floor(std::log2(exact)) - 6);
  lattice.step = std::floor(exact / unit) * unit;
  const Point_2 center = center_of(order.box);
  const auto snapped = [&](double middle, std::size_t cells) {
    return std::round((middle - (static_cast<double>(cells) - 1) * lattice.step / 2) / unit) * unit;
  };
  lattice.first = {snapped(center.x, lattice.columns), snapped(center.y, lattice.rows)};
  return lattice;
}

std::vector<Point_2> lattice_points(const Generator_order_2& order, double jitter) {
  const Lattice lattice = lattice_of(order);
  Portable_random random(order.seed);
  std::vector<Point_2> points;
  points.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i) {
    const auto column = static_cast<double>(i % lattice.columns);
    const auto row = static_cast<double>(i / lattice.columns);
    Point_2 p{lattice.first.x + column * lattice.step, lattice.first.y + row * lattice.step};
    if (jitter > 0) {
      p.x += random.within(-jitter, jitter) * lattice.step;
      p.y += random.within(-jitter, jitter) * lattice.step;
    }
    points.push_back(p);
  }
  return points;
}

std::vector<Point_2> grid(const Generator_order_2& order) { return lattice_points(order, 0); }
std::vector<Point_2> jittered_grid(const Generator_order_2& order) { return lattice_points(order, 0.4); }

std::vector<Point_2> on_ellipse(const Generator_order_2& order, double radius_x, double radius_y) {
  const Point_2 center = center_of(order.box);
  std::vector<Point_2> points;
  points.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i) {
    const double angle = turn * static_cast<double>(i) / static_cast<double>(order.count);
    points.push_back({center.x + radius_x * std::cos(angle), center.y + radius_y * std::sin(angle)});
  }
  return points;
}

std::vector<Point_2> circle(const Generator_order_2& order) {
  const double radius = half_side(order.box);
  return on_ellipse(order, radius, radius);
}

std::vector<Point_2> ellipse(const Generator_order_2& order) {
  const double radius = half_side(order.box);
  return on_ellipse(order, radius, radius / 2);
}

std::vector<Point_2> wiggly(const Generator_order_2& order) {
  const Point_2 center = center_of(order.box);
  std::vector<Point_2> points = wiggly_curve(order.count, half_side(order.box));
  for (Point_2& p : points) p = {p.x + center.x, p.y + center.y};
  return points;
}

/// At equal distances along all rings.
std::vector<Point_2> on_outline(const Generator_order_2& order) {
  const auto outline = order.inputs.get(outline_input);
  if (!outline || order.count == 0) return {};
  double length = 0;
  const auto for_each_edge = [&](auto visit) {
    for (const Ring_2& ring : outline->rings)
      for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  };
  for_each_edge([&](const Point_2& a, const Point_2& b) { length += distance(a, b); });
  if (!(length > 0)) return {};
  const double step = length / static_cast<double>(order.count);
  std::vector<Point_2> points;
  double walked = 0;
  for_each_edge([&](const Point_2& a, const Point_2& b) {
    const double edge = distance(a, b);
    while (points.size() < order.count && static_cast<double>(points.size()) * step < walked + edge) {
      const double t = (static_cast<double>(points.size()) * step - walked) / edge;
      points.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    walked += edge;
  });
  return points;
}

std::vector<Point_2> noisy_copy(const Generator_order_2& order) {
  std::vector<Point_2> points;
  if (const auto given = order.inputs.get(points_input)) points = *given;
  if (points.empty()) {
    if (const auto outline = order.inputs.get(outline_input))
      for (const Ring_2& ring : outline->rings) points.insert(points.end(), ring.begin(), ring.end());
  }
  Portable_random random(order.seed);
  const double deviation = order.amount * bounding_box(order.inputs).diagonal();
  for (Point_2& p : points) {
    const Point_2 shift = random.normal_pair();
    p = {p.x + deviation * shift.x, p.y + deviation * shift.y};
  }
  return points;
}

/// Exactly on one line: whole multiples of a vector of few bits.
std::vector<Point_2> collinear(const Generator_order_2& order) {
  const double span = std::max<double>(1, static_cast<double>(order.count) - 1);
  const double exact = 2 * half_side(order.box) / span;
  const double unit = std::exp2(std::floor(std::log2(exact)) - 2);
  const double step = std::max(std::floor(exact / unit), 2.0) * unit;
  const Point_2 center = center_of(order.box);
  const auto snapped = [&](double coordinate) { return std::round(coordinate / unit) * unit; };
  const Point_2 first{snapped(center.x - step * span / 2), snapped(center.y - step * span / 4)};
  std::vector<Point_2> points;
  for (std::size_t i = 0; i < order.count; ++i) {
    const auto k = static_cast<double>(i);
    points.push_back({first.x + k * step, first.y + k * step / 2});
  }
  return points;
}

/// Exactly on one circle: the 324 points with whole coordinates at distance 5·13·17·29 from the origin, scaled by a
/// power of two.
std::vector<Point_2> cocircular(const Generator_order_2& order) {
  constexpr std::int64_t radius = 5 * 13 * 17 * 29;
  std::vector<Point_2> circle_points;
  for (std::int64_t x = -radius; x <= radius; ++x) {
    const std::int64_t rest = radius * radius - x * x;
    const auto y = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(rest))));
    if (y * y != rest) continue;
    circle_points.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (y != 0) circle_points.push_back({static_cast<double>(x), static_cast<double>(-y)});
  }
  std::ranges::sort(circle_points, {}, [](const Point_2& p) { return std::atan2(p.y, p.x); });
  const double scale = std::exp2(std::floor(std::log2(half_side(order.box) / static_cast<double>(radius))));
  const Point_2 center = center_of(order.box);
  const Point_2 middle{std::round(center.x / scale) * scale, std::round(center.y / scale) * scale};
  const std::size_t count = std::min(order.count, circle_points.size());
  std::vector<Point_2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Point_2& p = circle_points[i * circle_points.size() / count];
    points.push_back({middle.x + scale * p.x, middle.y + scale * p.y});
  }
  return points;
}

/// Every point three times.
std::vector<Point_2> duplicates(const Generator_order_2& order) {
  constexpr std::size_t copies = 3;
  Generator_order_2 fewer = order;
  fewer.count = std::max<std::size_t>(1, order.count / copies);
  const std::vector<Point_2> once = uniform(fewer);
  std::vector<Point_2> points;
  for (std::size_t i = 0; i < order.count; ++i) points.push_back(once[i % once.size()]);
  return points;
}

std::vector<Disk_2> random_disks(const Generator_order_2& order) {
  Portable_random random(order.seed);
  std::vector<Disk_2> disks;
  disks.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i) {
    const Point_2 center = random_in(random, order.box);
    disks.push_back({center, random.within(order.least_radius, order.greatest_radius)});
  }
  return disks;
}

std::vector<Disk_2> with_radius(const std::vector<Point_2>& centers, double radius) {
  std::vector<Disk_2> disks;
  disks.reserve(centers.size());
  for (const Point_2& center : centers) disks.push_back({center, radius});
  return disks;
}

std::vector<Disk_2> grid_of_disks(const Generator_order_2& order) {
  return with_radius(grid(order), order.relative_radius * lattice_of(order).step);
}

std::vector<Disk_2> ring_of_disks(const Generator_order_2& order) {
  const std::vector<Point_2> centers = circle(order);
  const double step = centers.size() < 2 ? half_side(order.box) : distance(centers[0], centers[1]);
  return with_radius(centers, order.relative_radius * step);
}

}  // namespace

Inputs generated(const Generator_2& generator, const Generator_order_2& order) {
  Inputs inputs;
  if (generator.make) inputs = with_points(inputs, generator.make(order));
  if (generator.make_disks) inputs = with_disks(inputs, generator.make_disks(order));
  return inputs;
}

std::vector<Point_2> wiggly_curve(std::size_t count, double size) {
  std::vector<Point_2> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = turn * static_cast<double>(i) / static_cast<double>(count);
    const double radius =
        size * (0.62 + 0.22 * std::sin(3 * t + 0.6) + 0.12 * std::sin(5 * t) + 0.04 * std::cos(2 * t));
    points.push_back({1.15 * radius * std::cos(t), 0.95 * radius * std::sin(t)});
  }
  return points;
}

const std::vector<Generator_2>& generators_2() {
  constexpr std::size_t usual_grid = 25;
  constexpr std::size_t usual_ring = 12;
  static const std::vector<Generator_2> generators = {
      {"random", QT_TRANSLATE_NOOP("generators", "Random points"),
       QT_TRANSLATE_NOOP("generators", "Points spread evenly at random over the view"), true, true, false, uniform},
      {"grid", QT_TRANSLATE_NOOP("generators", "Grid"),
       QT_TRANSLATE_NOOP("generators", "Points in exact rows and columns"), true, false, false, grid},
      {"jittered-grid", QT_TRANSLATE_NOOP("generators", "Jittered grid"),
       QT_TRANSLATE_NOOP("generators", "A grid whose points are moved at random within their cells"), true, true, false,
       jittered_grid},
      {"circle", QT_TRANSLATE_NOOP("generators", "Circle"),
       QT_TRANSLATE_NOOP("generators", "Points at equal angles on a circle"), true, false, false, circle},
      {"ellipse", QT_TRANSLATE_NOOP("generators", "Ellipse"),
       QT_TRANSLATE_NOOP("generators", "Points on an ellipse, twice as long as wide"), true, false, false, ellipse},
      {"wiggly-curve", QT_TRANSLATE_NOOP("generators", "Wiggly curve"),
       QT_TRANSLATE_NOOP("generators", "Points on a smooth closed curve"), true, false, false, wiggly},
      {"on-outline", QT_TRANSLATE_NOOP("generators", "On the outline"),
       QT_TRANSLATE_NOOP("generators", "Points at equal distances along the outline"), true, false, false, on_outline},
      {"noisy-copy", QT_TRANSLATE_NOOP("generators", "Noisy copy"),
       QT_TRANSLATE_NOOP("generators", "A copy of every point, or vertex of the outline, moved a little at random"),
       false, true, true, noisy_copy},
      {"random-disks", QT_TRANSLATE_NOOP("generators", "Random disks"),
       QT_TRANSLATE_NOOP("generators", "Disks at random places of the view with random radii"), true, true, false,
       nullptr, random_disks, Radii_2::between},
      {"grid-of-disks", QT_TRANSLATE_NOOP("generators", "Grid of disks"),
       QT_TRANSLATE_NOOP("generators",
                         "Equal disks in exact rows and columns; they touch where the radius is half a step"),
       true, false, false, nullptr, grid_of_disks, Radii_2::relative, usual_grid},
      {"ring-of-disks", QT_TRANSLATE_NOOP("generators", "Ring of disks"),
       QT_TRANSLATE_NOOP("generators", "Equal disks around a hole; they touch where the radius is half a step"), true,
       false, false, nullptr, ring_of_disks, Radii_2::relative, usual_ring},
      {"collinear", QT_TRANSLATE_NOOP("generators", "Collinear points"),
       QT_TRANSLATE_NOOP("generators", "Points exactly on one line: a degenerate set"), true, false, false, collinear},
      {"cocircular", QT_TRANSLATE_NOOP("generators", "Cocircular points"),
       QT_TRANSLATE_NOOP("generators", "At most 324 points exactly on one circle: a degenerate set"), true, false,
       false, cocircular},
      {"duplicates", QT_TRANSLATE_NOOP("generators", "Duplicate points"),
       QT_TRANSLATE_NOOP("generators", "Random points, each three times: a degenerate set"), true, true, false,
       duplicates},
  };
  return generators;
}

}  // namespace mesecina
