// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/nesting_3.h"

#include <algorithm>
#include <map>

namespace mesecina {

Nesting_3 find_nesting(const Surface_locator_3& locator, const std::vector<int>& component, int count,
                       Progress& progress) {
  Nesting_3 result{std::vector<std::uint8_t>(count, 0), std::vector<int>(count, 0)};
  const std::vector<int>& order = locator.tree().order();
  std::vector<std::uint8_t> is_done(count, 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int own = component[order[i]];
    if (is_done[own]) continue;
    const Corners_3& triangle = locator.corners()[i];
    const int side = side_of_ray(triangle);
    if (side == 0) continue;
    const Exact_place place = Exact_place::middle_of(triangle);
    progress.check();
    is_done[own] = 1;
    std::map<int, int> winding;
    locator.tree().visit([&](const Box& box) { return may_be_above(box, place.box()); },
                         [&](int j) {
                           const int direction = crossing_above(locator.corners()[j], place).direction;
                           if (direction != 0) winding[component[order[j]]] += direction;
                           return true;
                         });
    // On one side of the triangle it is what the ray says, on the other one the triangle adds to it.
    result.is_inward[own] = std::min(winding[own], winding[own] + side) < 0 ? 1 : 0;
    for (const auto& [other, times] : winding)
      if (other != own && times != 0) ++result.depth[own];
  }
  return result;
}

}  // namespace mesecina
