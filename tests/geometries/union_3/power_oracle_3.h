// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/primitives.h"
#include "tests/geometries/oracles.h"

/// The dual complex of at most 32 balls, and the vertices of their union, by definition: every set of up to four balls
/// is tried against every ball, in exact rationals. Weights are the squares of the radii, rounded.
namespace mesecina::test {

/// Balls as bits.
using Ball_set = std::uint32_t;

std::vector<int> members(Ball_set set);

inline Ball_set bit(int ball) { return Ball_set{1} << ball; }
template <class Balls>
Ball_set set_of(const Balls& balls) {
  Ball_set result = 0;
  for (const int i : balls) result |= bit(i);
  return result;
}

/// Sign of the volume of the tetrahedron of centers: 1 if the normal (right-hand rule) of the first three points to the
/// fourth one.
int orientation(const Ball_3& a, const Ball_3& b, const Ball_3& c, const Ball_3& d);

/// Sign of the power of a ball to the orthogonal sphere of a cell of four, whose centers must not be in a plane:
/// negative where the ball is in conflict with it.
int power_sign(std::span<const Ball_3> balls, const std::array<int, 4>& cell, int ball);

/// The first of the largest of the balls with a common center; hidden are the others, which are left out below.
std::vector<std::uint8_t> are_concentric_with_another(std::span<const Ball_3> balls);

/// A point of least power on a face of the power diagram that lies in the union.
struct Power_minimum {
  Ball_set simplex = 0;        ///< the balls whose smallest common orthogonal sphere it is the center of
  Ball_set nearest = 0;        ///< all balls to which it has the same power, which is the least
  bool is_on_spheres = false;  ///< the power is 0, exactly
};

/// Of every set of up to four balls with affinely independent centers. A simplex is in the dual complex iff it is part
/// of a `nearest`: the least power on its face of the power diagram is then that of one of these points. O(n^5).
std::vector<Power_minimum> power_minima(std::span<const Ball_3> balls);

/// No point is as near to more balls than general position allows: the dual complex is that of every regular
/// triangulation.
bool is_general(std::span<const Power_minimum> minima);

/// All simplices of up to four balls in the nerve of the power cells, each cut off by its ball; sorted. The nerve has
/// the homotopy type of the union. It is the dual complex where `is_general`.
std::vector<Ball_set> nerve(std::span<const Power_minimum> minima);

/// Of a complex of simplices with up to four vertices, in Betti numbers over the field with two elements.
Topology topology_of_simplices(const std::vector<Ball_set>& simplices);

/// Rank over the field with two elements; each column by its rows.
std::size_t rank_mod_2(std::vector<std::vector<int>> columns);

/// A point in no ball's interior where three spheres with centers that are not on a line meet.
struct Oracle_vertex_3 {
  Ball_set balls = 0;  ///< all on whose spheres it lies
  Point_3 point;
  bool is_on_boundary = true;  ///< of the union; false where balls surround the point
};
/// All of them. O(n^4).
std::vector<Oracle_vertex_3> vertices_by_definition(std::span<const Ball_3> balls);

}  // namespace mesecina::test
