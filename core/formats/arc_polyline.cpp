// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/arc_polyline.h"

#include <cmath>
#include <numbers>

namespace mesecina {

std::vector<Point_3> points_inside_arc(const Primitive_set& set, const Arc& arc) {
  constexpr double full_turn = 2 * std::numbers::pi;
  const auto angle_of = [&](int vertex) {
    return std::atan2(set.vertices[vertex].y - arc.center.y, set.vertices[vertex].x - arc.center.x);
  };
  const double from = angle_of(arc.from);
  double sweep = arc.from == arc.to ? full_turn : angle_of(arc.to) - from;
  if (arc.from == arc.to && !arc.counterclockwise) sweep = -sweep;
  if (arc.counterclockwise && sweep < 0) sweep += full_turn;
  if (!arc.counterclockwise && sweep > 0) sweep -= full_turn;

  const int segments = static_cast<int>(std::ceil(std::abs(sweep) * (360 / full_turn) - 1e-9));
  std::vector<Point_3> points;
  for (int i = 1; i < segments; ++i) {
    const double angle = from + sweep * i / segments;
    points.push_back({arc.center.x + arc.radius * std::cos(angle), arc.center.y + arc.radius * std::sin(angle), 0});
  }
  return points;
}

}  // namespace mesecina
