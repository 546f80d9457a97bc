// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/ring_nesting.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <optional>

namespace mesecina {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Whether the point is inside the ring; nothing when it is on it.
std::optional<bool> contains(const Ring_2& ring, const Point_2& point) {
  bool inside = false;
  const Kernel::Point_2 query(point.x, point.y);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point_2& from = ring[i];
    const Point_2& to = ring[(i + 1) % ring.size()];
    if (std::max(from.y, to.y) < point.y || std::min(from.y, to.y) > point.y) continue;
    const int side = CGAL::orientation(Kernel::Point_2(from.x, from.y), Kernel::Point_2(to.x, to.y), query);
    if (side == 0 && std::min(from.x, to.x) <= point.x && point.x <= std::max(from.x, to.x)) return std::nullopt;
    if (from.y <= point.y && to.y > point.y && side > 0) inside = !inside;
    if (to.y <= point.y && from.y > point.y && side < 0) inside = !inside;
  }
  return inside;
}

/// Rings that do not cross touch in single points at most, so a vertex or the middle of a side decides.
bool contains(const Ring_2& ring, const Ring_2& other) {
  for (const Point_2& vertex : other)
    if (const std::optional<bool> inside = contains(ring, vertex)) return *inside;
  for (std::size_t i = 0; i < other.size(); ++i)
    if (const std::optional<bool> inside = contains(ring, midpoint(other[i], other[(i + 1) % other.size()])))
      return *inside;
  return false;
}

Box box_of(const Ring_2& ring) {
  Box box;
  for (const Point_2& vertex : ring) box.add(vertex);
  return box;
}

bool contains(const Box& box, const Box& other) {
  return box.lower.x <= other.lower.x && box.lower.y <= other.lower.y && box.upper.x >= other.upper.x &&
         box.upper.y >= other.upper.y;
}

}  // namespace

std::vector<Polygon_rings> nest_rings(const Outline_2& outline) {
  const std::size_t count = outline.rings.size();
  std::vector<Box> boxes;
  for (const Ring_2& ring : outline.rings) boxes.push_back(box_of(ring));
  std::vector<std::vector<std::size_t>> around(count);
  for (std::size_t inner = 0; inner < count; ++inner) {
    for (std::size_t outer = 0; outer < count; ++outer) {
      if (inner != outer && contains(boxes[outer], boxes[inner]) &&
          contains(outline.rings[outer], outline.rings[inner]))
        around[inner].push_back(outer);
    }
  }

  std::vector<Polygon_rings> polygons;
  std::vector<std::size_t> polygon_of(count);
  const auto is_hole = [&](std::size_t ring) { return around[ring].size() % 2 != 0; };
  const auto start_polygon = [&](std::size_t ring) {
    polygon_of[ring] = polygons.size();
    polygons.push_back({ring});
  };
  for (std::size_t ring = 0; ring < count; ++ring)
    if (!is_hole(ring)) start_polygon(ring);
  for (std::size_t ring = 0; ring < count; ++ring) {
    if (!is_hole(ring)) continue;
    const auto outer = std::ranges::find_if(
        around[ring], [&](std::size_t other) { return around[other].size() + 1 == around[ring].size(); });
    if (outer == around[ring].end())
      start_polygon(ring);
    else
      polygons[polygon_of[*outer]].push_back(ring);
  }
  return polygons;
}

}  // namespace mesecina
