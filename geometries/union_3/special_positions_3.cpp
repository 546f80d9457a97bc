// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "geometries/union_3/union_3.h"

namespace mesecina {

namespace {

/// What is compared: components and the Euler characteristic.
using Connectivity = std::array<std::int64_t, 2>;

Connectivity connectivity(const Medial_complex_3& axis) {
  std::vector<int> parent(axis.centers.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  auto components = static_cast<std::int64_t>(parent.size());
  for (const auto& edge : axis.edges) {
    const int a = root(edge[0]);
    const int b = root(edge[1]);
    if (a == b) continue;
    parent[b] = a;
    --components;
  }
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

/// In [-1, 1), by nothing but the number: on every machine the same.
double scattered(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15U;
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9U;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111ebU;
  number ^= number >> 31U;
  return static_cast<double>(number >> 11U) * 0x1p-52 - 1;
}

}  // namespace

bool has_topology_of_union(const Medial_complex_3& axis, const Dual_3& dual) {
  const Topology expected = topology(dual);
  return connectivity(axis) == Connectivity{expected.betti[0], expected.euler} && !has_face_with_a_vertex_twice(axis);
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
