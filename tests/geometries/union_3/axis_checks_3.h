// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "geometries/union_3/union_3.h"
#include "tests/geometries/union_3/boundary_oracle_3.h"

/// What is true of a medial axis of a union of balls, by definition.
namespace mesecina::test {

struct Axis_3 {
  std::shared_ptr<const Dual_3> dual;
  Union_vertices_3 vertices;
  Medial_complex_3 complex;
};
/// The whole way from the balls.
Axis_3 axis_of(const std::vector<Ball_3>& balls);

/// Components by union-find, the Euler characteristic by counting.
struct Connectivity {
  std::int64_t components = 0;
  std::int64_t euler = 0;
  bool operator==(const Connectivity&) const = default;
};
Connectivity connectivity(const Medial_complex_3& axis);
/// By ranks of boundary matrices.
Topology topology_by_ranks(const Medial_complex_3& axis);

/// Indices are valid, edges are sorted and each there once, those of faces too; each face has three or more different
/// vertices; balls are those of the union, each once.
testing::AssertionResult is_complex(const Axis_3& axis);

/// Every vertex, and points along every edge and on every face, are as far from the boundary as the radii say; contacts
/// of faces are boundary points at that distance; faces are planar. `tolerance` relative to the size of the union.
testing::AssertionResult is_medial(const Axis_3& axis, const Boundary_oracle_3& boundary, double tolerance);

/// From random points of the union away from the nearest boundary point, as long as that is the nearest one: it ends on
/// the complex, or in a Voronoi face of two vertices of the union that is not medial as a whole.
testing::AssertionResult is_whole(const Axis_3& axis, const Boundary_oracle_3& boundary, int points,
                                  std::uint64_t seed);

std::string to_text(const Topology& topology);

}  // namespace mesecina::test
