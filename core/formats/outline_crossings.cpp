// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/outline_crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace mesecina {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::size_t most_crossings = 1000000;

struct Too_many {};

/// A box as CGAL::box_self_intersection_d wants it; the id is the number of the side.
class Side_box {
 public:
  using NT = double;
  using ID = std::size_t;
  Side_box(const Point_2& p, const Point_2& q, std::size_t id)
      : lower_{std::min(p.x, q.x), std::min(p.y, q.y)}, upper_{std::max(p.x, q.x), std::max(p.y, q.y)}, id_(id) {}
  static int dimension() { return 2; }
  std::size_t id() const { return id_; }
  double min_coord(int i) const { return lower_[static_cast<std::size_t>(i)]; }
  double max_coord(int i) const { return upper_[static_cast<std::size_t>(i)]; }

 private:
  std::array<double, 2> lower_;
  std::array<double, 2> upper_;
  std::size_t id_;
};

struct Side {
  Point_2 from;
  Point_2 to;
  Outline_side name;
};

int turn(const Point_2& p, const Point_2& q, const Point_2& r) {
  return CGAL::orientation(Kernel::Point_2(p.x, p.y), Kernel::Point_2(q.x, q.y), Kernel::Point_2(r.x, r.y));
}

/// Along a common line, points are ordered as their coordinates (x, y) are.
bool lies_before(const Point_2& p, const Point_2& q) { return std::pair(p.x, p.y) < std::pair(q.x, q.y); }

/// A point near the common part of the two sides if their interiors meet.
std::optional<Point_2> crossing(const Side& a, const Side& b) {
  const int b_from = turn(a.from, a.to, b.from);
  const int b_to = turn(a.from, a.to, b.to);
  if (b_from * b_to > 0) return std::nullopt;
  if (b_from == 0 && b_to == 0) {
    const auto [a_low, a_high] = std::minmax(a.from, a.to, lies_before);
    const auto [b_low, b_high] = std::minmax(b.from, b.to, lies_before);
    const Point_2 low = std::max(a_low, b_low, lies_before);
    const Point_2 high = std::min(a_high, b_high, lies_before);
    if (!lies_before(low, high)) return std::nullopt;
    return midpoint(low, high);
  }
  if (b_from * b_to == 0 || turn(b.from, b.to, a.from) * turn(b.from, b.to, a.to) >= 0) return std::nullopt;
  const double dx = b.to.x - b.from.x;
  const double dy = b.to.y - b.from.y;
  const double from_area = dx * (a.from.y - b.from.y) - dy * (a.from.x - b.from.x);
  const double to_area = dx * (a.to.y - b.from.y) - dy * (a.to.x - b.from.x);
  const double t = from_area == to_area ? 0.5 : std::clamp(from_area / (from_area - to_area), 0., 1.);
  return Point_2{a.from.x + t * (a.to.x - a.from.x), a.from.y + t * (a.to.y - a.from.y)};
}

std::vector<Side> sides_of(const Outline_2& outline) {
  std::vector<Side> sides;
  for (std::size_t r = 0; r < outline.rings.size(); ++r) {
    const Ring_2& ring = outline.rings[r];
    for (std::size_t i = 0; i < ring.size(); ++i) sides.push_back({ring[i], ring[(i + 1) % ring.size()], {r, i}});
  }
  return sides;
}

}  // namespace

Outline_crossings find_crossings(const Outline_2& outline) {
  const std::vector<Side> sides = sides_of(outline);
  std::vector<Side_box> boxes;
  boxes.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size(); ++i) boxes.emplace_back(sides[i].from, sides[i].to, i);

  Outline_crossings result;
  const auto examine = [&](const Side_box& one, const Side_box& other) {
    const Side& a = sides[std::min(one.id(), other.id())];
    const Side& b = sides[std::max(one.id(), other.id())];
    const std::optional<Point_2> place = crossing(a, b);
    if (!place) return;
    if (result.count == 0 || std::pair(a.name, b.name) < std::pair(result.first, result.second)) {
      result.first = a.name;
      result.second = b.name;
      result.place = *place;
    }
    if (++result.count == most_crossings) throw Too_many();
  };
  try {
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), examine);
  } catch (const Too_many&) {
    result.is_complete = false;
  }
  return result;
}

}  // namespace mesecina
