// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "geometries/union_3/rounded_axis_3.h"
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

/// How far balls are moved, and how much they grow, relative to their radii.
struct Motion {
  double reach;
  double growth;
};
/// Growing keeps together what touches. Only cavities and tunnels as small as that need shrinking.
constexpr std::array<Motion, 5> motions{{{1e-7, 3e-7}, {1e-6, 3e-6}, {1e-5, 3e-5}, {1e-7, -3e-7}, {1e-6, -3e-6}}};

/// Balls that are hidden become points, which are hidden too.
std::vector<Ball_3> moved_balls(const Regular_3& regular, const Motion& motion) {
  std::vector<Ball_3> balls = regular.balls;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    Ball_3& b = balls[i];
    if (regular.cell_of_ball[i] < 0) {
      b.radius = 0;
      continue;
    }
    const double reach = motion.reach * b.radius;
    b.center = b.center + reach * Point_3{scattered(4 * i), scattered(4 * i + 1), scattered(4 * i + 2)};
    b.radius *= 1 + motion.growth + 0.5 * motion.reach * scattered(4 * i + 3);
  }
  return balls;
}

}  // namespace

Medial_complex_3 union_medial_axis(const Union_vertices_3& vertices, Progress& progress) {
  Medial_complex_3 axis = rounded_medial_axis(vertices, progress);
  const Topology topology_of_union = topology(*vertices.dual);
  const Connectivity expected{topology_of_union.betti[0], topology_of_union.euler};
  const auto is_sound = [&expected](const Medial_complex_3& some) {
    return connectivity(some) == expected && !has_face_with_a_vertex_twice(some);
  };
  if (is_sound(axis)) return axis;
  // Spheres meet in special positions. Balls in general position have an axis that rounding does not change.
  const Regular_3& regular = *vertices.dual->regular;
  for (const Motion& motion : motions) {
    auto moved = std::make_shared<const Regular_3>(regular_triangulation(moved_balls(regular, motion), progress));
    auto dual = std::make_shared<const Dual_3>(dual_complex(std::move(moved), progress));
    Medial_complex_3 other = rounded_medial_axis(union_vertices(std::move(dual), progress), progress);
    if (!is_sound(other)) continue;
    for (std::size_t v = 0; v < other.balls.size(); ++v) {
      const int ball = other.balls[v];
      if (ball < 0) continue;
      other.centers[v] = regular.balls[ball].center;
      other.radii[v] = regular.balls[ball].radius;
    }
    return other;
  }
  return axis;
}

}  // namespace mesecina
