// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/loose_elements.h"

#include <algorithm>
#include <span>

namespace mesecina {
namespace {

std::array<int, 2> ascending(int v, int w) { return {std::min(v, w), std::max(v, w)}; }

void add_sides(std::vector<std::array<int, 2>>& sides, std::span<const int> face) {
  for (std::size_t i = 0; i < face.size(); ++i) sides.push_back(ascending(face[i], face[(i + 1) % face.size()]));
}

}  // namespace

Loose_elements loose_elements(const Primitive_set& set) {
  if (!set.is_complex || set.dimension != 3) return {set.points, set.segments};
  std::vector<std::array<int, 2>> sides;
  for (const auto& triangle : set.triangles) add_sides(sides, triangle);
  for (std::size_t i = 0; i < set.polygon_count(); ++i) add_sides(sides, set.polygon(i));
  std::vector<bool> is_end(set.vertices.size(), false);
  for (const auto& [v, w] : sides) is_end[v] = is_end[w] = true;
  for (const auto& [v, w] : set.segments) is_end[v] = is_end[w] = true;
  std::ranges::sort(sides);

  Loose_elements loose;
  for (const auto& [v, w] : set.segments)
    if (!std::ranges::binary_search(sides, ascending(v, w))) loose.segments.push_back({v, w});
  for (const int vertex : set.points)
    if (!is_end[vertex]) loose.points.push_back(vertex);
  return loose;
}

}  // namespace mesecina
