// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/primitives.h"

namespace mesecina {

/// What of a Primitive_set in space is drawn in one way. Arcs are planar and not drawn in space.
enum class Part_3 {
  points,             ///< those that no other primitive of the set ends at
  bounding_points,    ///< the others
  segments,           ///< rays too, and without the edges of triangles and polygons
  bounding_segments,  ///< the edges of triangles and polygons among the segments
  face_edges,         ///< once for each triangle or polygon that has them, in one direction, so to the same depths
  faces               ///< triangles, and polygons as fans of triangles
};

/// x y z 1 of every vertex relative to the origin, then of a far point of every ray.
std::vector<float> places_3(const Primitive_set& set, const Point_3& origin);
/// Four whole numbers for each piece of a part: its one, two or three places, then zeros, at last its element.
std::vector<std::int32_t> pieces_3(const Primitive_set& set, Part_3 part);
/// x y z of the center relative to the origin, and radius.
std::vector<float> balls_3(const Primitive_set& set, const Point_3& origin);

/// x y z 0 of the unit normal of every piece of Part_3::faces; all pieces of a polygon have the same. 0 where there is
/// none.
std::vector<float> face_normals_3(const Primitive_set& set);
/// x y z 0 of the unit normal of every vertex: of the faces around it, by their areas, each on the side on which the
/// first is, so that it does not matter how faces are oriented. 0 where there is none.
std::vector<float> vertex_normals_3(const Primitive_set& set);

/// Whether triangles and polygons bound a solid: every edge is passed as often in one direction as in the other.
/// False without faces. O(n log n), as all above.
bool is_closed_3(const Primitive_set& set);

/// The number of the first ball among the elements.
std::size_t first_ball_3(const Primitive_set& set);

}  // namespace mesecina
