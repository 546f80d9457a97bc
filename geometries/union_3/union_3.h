// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// The vertices of the boundary of a union of balls, V(U): where three spheres meet on it. Known by their construction,
/// a triangle of the dual complex and a side of it; spheres that meet in one point, exactly, have one vertex there.
struct Union_vertices_3 {
  std::shared_ptr<const Dual_3> dual;
  std::vector<Point_3> points;
  /// Per vertex the balls on whose spheres it lies, ascending: offsets and balls.
  std::vector<int> ball_offsets;
  std::vector<int> balls;

  std::span<const int> balls_of(int vertex) const {
    return std::span(balls).subspan(ball_offsets[vertex], ball_offsets[vertex + 1] - ball_offsets[vertex]);
  }
};

/// O(n).
Union_vertices_3 union_vertices(std::shared_ptr<const Dual_3> dual, Progress& progress);

/// Per vertex: a singular triangle of the dual complex has three of its balls. The spheres of these three then meet in
/// two vertices; those of other triangles of the boundary in one. O(n) where few balls go through one vertex.
std::vector<std::uint8_t> have_singular_triangles(const Union_vertices_3& vertices);

/// Where the spheres of three balls meet: on the side to which the normal (right-hand rule) of their centers points, or
/// on the other one. To rounding; where they only nearly meet, the point between them.
Point_3 meeting_point(const Ball_3& a, const Ball_3& b, const Ball_3& c, bool is_above);

/// Medial axis of a union of balls, or a part of it: a cell complex with shared vertices. Vertices are medial balls.
struct Medial_complex_3 {
  std::vector<Point_3> centers;
  std::vector<double> radii;
  std::vector<int> balls;         ///< per vertex the ball of the union that it is; -1 for none
  std::vector<int> face_offsets;  ///< #faces + 1, into face_vertices
  std::vector<int> face_vertices;
  std::vector<std::array<Point_3, 2>> contacts;  ///< per face the two points where its medial balls touch the boundary
  std::vector<std::array<int, 2>> edges;         ///< all, those of faces too; the lesser vertex first, ascending

  std::size_t face_count() const { return contacts.size(); }
  std::span<const int> face(std::size_t i) const {
    return std::span(face_vertices).subspan(face_offsets[i], face_offsets[i + 1] - face_offsets[i]);
  }
};

/// What is in a complex besides its faces and what bounds them.
struct Loose_parts_3 {
  std::vector<std::array<int, 2>> edges;  ///< that no face has
  std::vector<int> vertices;              ///< that no edge has
};
/// Ascending. O(n log n) with a small constant.
Loose_parts_3 loose_parts(const Medial_complex_3& complex, Progress& progress);
/// The same on one thread.
Loose_parts_3 loose_parts(const Medial_complex_3& complex);

/// The singular faces of the dual complex, and of the Voronoi diagram of V(U) all cells that lie in the rest of it as a
/// whole ("complete faces"). It has the homotopy type of the union. A Voronoi vertex at the center of a ball, where all
/// its V(U) points lie on one sphere, is that by construction. Where more than three spheres meet in nearly one point,
/// or their vertices lie on one circle, rounded points decide, and parts may be missing or too much;
/// has_topology_of_union tells. O(n log n) along surfaces. [N. Amenta, R. Kolluri: The medial axis of a union of balls,
/// 2001; B. Miklos: The Scale Axis Transform, 2010, 4.2, 6.1.3]
Medial_complex_3 union_medial_axis(const Union_vertices_3& vertices, Progress& progress);

/// Whether the components and the Euler characteristic are those of the union, and each face is a polygon. True for
/// balls in general position. O(n α(n)).
bool has_topology_of_union(const Medial_complex_3& axis, const Dual_3& dual, const Progress& progress = {});

/// Balls with centers moved by up to `part` of their radii in each coordinate and radii larger by about three times
/// that, so that what touched still meets. Depends on nothing but the balls and their order.
std::vector<Ball_3> perturbed(std::vector<Ball_3> balls, double part);

/// Per face: half the distance of its contacts.
std::vector<double> lambda_of_faces(const Medial_complex_3& axis);
/// Per face: the angle, in degrees in (0,180], under which its contacts are seen from the point of the face that is
/// nearest to the middle between them.
std::vector<double> angle_of_faces(const Medial_complex_3& axis, Progress& progress);

}  // namespace mesecina
