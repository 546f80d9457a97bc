// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/union_2/union_boundary_2.h"

namespace mesecina {

/// The Voronoi diagram of the vertices of a union, and which part of it is inside.
struct Union_voronoi_2 {
  std::shared_ptr<const Union_boundary_2> boundary;
  Delaunay_2 delaunay;  ///< of boundary->vertices
  /// Per Delaunay triangle: it lies inside the polygons that the chords of the boundary arcs form; then, and only then,
  /// its Voronoi vertex belongs to the medial axis.
  std::vector<std::uint8_t> is_inner;
  /// Per triangle the disk on whose circle all its corners lie: its center is the Voronoi vertex, exactly. -1 for none.
  std::vector<int> ball_of_triangle;
  std::vector<Point_2> vertices;  ///< per triangle: that center, else the circumcenter
  std::vector<double> radii;      ///< per triangle
  /// Chords of boundary arcs that rounded vertices left out of the triangulation; labels near them may be wrong.
  std::size_t lost_chords = 0;
};

/// O(n log n).
Union_voronoi_2 union_voronoi(std::shared_ptr<const Union_boundary_2> boundary, Progress& progress);

/// How an edge of the medial axis came to be there.
enum class Axis_edge_kind : std::uint8_t {
  complete,    ///< a whole Voronoi edge
  incomplete,  ///< the part of a Voronoi edge that ends at the center of a disk, where it leaves the dual complex
  singular     ///< a singular edge of the dual complex
};

/// Medial axis of a union of disks: the singular faces of the dual complex, and the Voronoi diagram of the vertices of
/// the union inside the rest of it. A graph; its homotopy type is that of the union.
/// [N. Amenta, R. Kolluri: The medial axis of a union of balls, 2001; B. Miklos: The Scale Axis Transform, 2010, 4.2]
struct Union_medial_axis_2 {
  std::shared_ptr<const Union_boundary_2> boundary;
  std::vector<Point_2> centers;           ///< of the medial disks
  std::vector<double> radii;              ///< of the medial disks
  std::vector<int> balls;                 ///< per medial disk the disk of the union that it is; -1 for none
  std::vector<std::array<int, 2>> edges;  ///< pairs of medial disks
  std::vector<std::array<int, 2>>
      contacts;                       ///< per edge the two vertices of the union it lies between, the lesser first
  std::vector<Axis_edge_kind> kinds;  ///< per edge
};

/// complete_only: leaves out incomplete edges, which are all leaves. O(n).
Union_medial_axis_2 union_medial_axis(const Union_voronoi_2& voronoi, bool complete_only, Progress& progress);

/// Per edge: half the distance of its contacts.
std::vector<double> lambda_of_edges(const Union_medial_axis_2& axis);
/// Per edge: the largest angle, in degrees in (0,180], under which its contacts are seen from it; 180 where it passes
/// between them or they are one.
std::vector<double> angle_of_edges(const Union_medial_axis_2& axis);

}  // namespace mesecina
