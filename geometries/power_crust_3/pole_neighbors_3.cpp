// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/power_crust_3/pole_neighbors_3.h"

#include <algorithm>
#include <numeric>

namespace mesecina {

Ball_neighbors_3 neighbors_of_balls(const Regular_3& regular) {
  const auto for_each_pair = [&](const auto& function) {
    for (const auto& corners : regular.cells)
      for (const int a : corners)
        for (const int b : corners)
          if (a >= 0 && b >= 0 && a != b) function(a, b);
  };
  const std::size_t count = regular.balls.size();
  std::vector<int> offsets(count + 1, 0);
  for_each_pair([&](int a, int) { ++offsets[a + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  // Each pair as often as there are cells around it.
  std::vector<int> repeated(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for_each_pair([&](int a, int b) { repeated[next[a]++] = b; });
  Ball_neighbors_3 result;
  result.offsets.push_back(0);
  for (std::size_t ball = 0; ball < count; ++ball) {
    const auto begin = repeated.begin() + offsets[ball];
    const auto end = repeated.begin() + offsets[ball + 1];
    std::sort(begin, end);
    result.balls.insert(result.balls.end(), begin, std::unique(begin, end));
    result.offsets.push_back(static_cast<int>(result.balls.size()));
  }
  return result;
}

}  // namespace mesecina
