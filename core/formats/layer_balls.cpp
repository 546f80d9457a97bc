// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/layer_balls.h"

#include <algorithm>

namespace mesecina {

std::vector<double> vertex_radii(const Primitive_set& set) {
  if (!set.radii.empty() || set.balls.empty()) return set.radii;
  std::vector<double> radii(set.vertices.size(), 0);
  for (const Ball& ball : set.balls) radii[ball.center] = std::max(radii[ball.center], ball.radius);
  return radii;
}

std::vector<Ball_3> layer_balls(const Primitive_set& set) {
  std::vector<Ball_3> balls;
  if (set.radii.empty()) {
    for (const Ball& ball : set.balls) balls.push_back({set.vertices[ball.center], ball.radius});
  } else {
    for (std::size_t i = 0; i < set.radii.size(); ++i) balls.push_back({set.vertices[i], set.radii[i]});
  }
  return balls;
}

}  // namespace mesecina
