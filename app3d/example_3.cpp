// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/example_3.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mesecina {

Triangle_mesh_3 twisted_ring(int segments) {
  Triangle_mesh_3 mesh;
  const int around = std::max(3, segments);
  const int across = std::max(3, segments / 3);
  constexpr double turn = 2 * std::numbers::pi;
  constexpr double ring_radius = 1.1;
  for (int i = 0; i < around; ++i) {
    const double along = turn * i / around;
    const double swell = 1 + 0.35 * std::cos(3 * along);
    // The cross section looks the same after half a turn, so that the ring closes.
    const double twist = along / 2 * 3;
    for (int j = 0; j < across; ++j) {
      const double angle = turn * j / across;
      const double wide = 0.42 * swell * std::cos(angle);
      const double thick = 0.17 * swell * std::sin(angle);
      const double outward = ring_radius + wide * std::cos(twist) - thick * std::sin(twist);
      mesh.vertices.push_back(
          {outward * std::cos(along), outward * std::sin(along), wide * std::sin(twist) + thick * std::cos(twist)});
    }
  }
  // Where the ring closes, the cross section has made one and a half turns.
  const int half = across / 2;
  const auto vertex = [&](int i, int j) {
    const int shift = i == around ? half : 0;
    return (i % around) * across + (j + shift) % across;
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
    }
  }
  return mesh;
}

}  // namespace mesecina
