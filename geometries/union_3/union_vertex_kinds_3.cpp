// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <numeric>

#include "geometries/union_3/union_3.h"

namespace mesecina {

std::vector<std::uint8_t> have_singular_triangles(const Union_vertices_3& vertices) {
  // Singular triangles by their least ball; its other two.
  std::vector<int> offsets(vertices.dual->regular->balls.size() + 1, 0);
  const auto for_singular = [&](const auto& use) {
    for (const Dual_3::Triangle& triangle : vertices.dual->triangles) {
      if (triangle.kind != Simplex_kind_3::singular) continue;
      std::array<int, 3> balls = triangle.balls;
      std::ranges::sort(balls);
      use(balls);
    }
  };
  for_singular([&](const std::array<int, 3>& balls) { ++offsets[balls[0] + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<std::array<int, 2>> others(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for_singular([&](const std::array<int, 3>& balls) { others[next[balls[0]]++] = {balls[1], balls[2]}; });
  std::vector<std::uint8_t> result(vertices.points.size(), 0);
  for (std::size_t v = 0; v < result.size(); ++v) {
    const auto own = vertices.balls_of(static_cast<int>(v));
    const auto has = [&](const std::array<int, 2>& two) {
      return std::ranges::binary_search(own, two[0]) && std::ranges::binary_search(own, two[1]);
    };
    result[v] = std::ranges::any_of(own, [&](int ball) {
      return std::any_of(others.begin() + offsets[ball], others.begin() + offsets[ball + 1], has);
    });
  }
  return result;
}

}  // namespace mesecina
