// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/disjoint_sets.h"
#include "geometries/parallel.h"
#include "geometries/scatter.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

namespace {

/// What is compared: components and the Euler characteristic.
using Connectivity = std::array<std::int64_t, 2>;

Connectivity connectivity(const Medial_complex_3& axis) {
  Disjoint_sets parts(axis.centers.size());
  auto components = static_cast<std::int64_t>(parts.size());
  for (const auto& [from, to] : axis.edges)
    if (parts.join(from, to)) --components;
  return {components, static_cast<std::int64_t>(axis.centers.size() + axis.face_count()) -
                          static_cast<std::int64_t>(axis.edges.size())};
}

bool has_face_with_a_vertex_twice(const Medial_complex_3& axis) {
  std::vector<int> last_face(axis.centers.size(), -1);
  for (std::size_t f = 0; f < axis.face_count(); ++f)
    for (const int v : axis.face(f))
      if (std::exchange(last_face[v], static_cast<int>(f)) == static_cast<int>(f)) return true;
  return false;
}

}  // namespace

bool has_topology_of_union(const Medial_complex_3& axis, const Dual_3& dual, const Progress& progress) {
  Topology expected;
  Connectivity found;
  bool is_sound = false;
  const auto look_at_axis = [&] {
    found = connectivity(axis);
    is_sound = !has_face_with_a_vertex_twice(axis);
  };
  at_once(
      progress, [&] { expected = topology(dual); }, look_at_axis);
  return is_sound && found == Connectivity{expected.betti[0], expected.euler};
}

std::vector<Ball_3> perturbed(std::vector<Ball_3> balls, double part) {
  constexpr double growth = 3;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    Ball_3& b = balls[i];
    const Point_3 shift{scattered(4 * i), scattered(4 * i + 1), scattered(4 * i + 2)};
    b.center = b.center + part * b.radius * shift;
    b.radius *= 1 + part * (growth + 0.5 * scattered(4 * i + 3));
  }
  return balls;
}

}  // namespace mesecina
