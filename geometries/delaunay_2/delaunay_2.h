// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/point.h"
#include "core/progress.h"

namespace mesecina {

/// Delaunay triangulation of points in the plane, as arrays: structures that are read many times and by index want no
/// handles. Sites are the distinct points; of equal points the one with the least index is the site.
///
/// Edges are named by a triangle t and a corner i: the edge opposite to that corner. The same edge is seen from
/// neighbors[t][i]; `edge_is_listed` chooses one of the two.
struct Delaunay_2 {
  std::vector<Point_2> points;  ///< as given, equal ones included
  std::vector<int> site;        ///< per point: index of the point that is its site (itself unless a duplicate)
  std::size_t site_count = 0;
  int dimension = -1;                         ///< -1 no point, 0 one site, 1 all sites on a line, 2 otherwise
  std::vector<std::array<int, 3>> triangles;  ///< points, counterclockwise
  std::vector<std::array<int, 3>> neighbors;  ///< triangle opposite to the corner; -1: the outside of the hull
  std::vector<int> line;                      ///< dimension 0 and 1: the sites in their order on the line

  Delaunay_2();
  ~Delaunay_2();
  Delaunay_2(Delaunay_2&&) noexcept;
  Delaunay_2& operator=(Delaunay_2&&) noexcept;
  Delaunay_2(const Delaunay_2&) = delete;

  bool edge_is_listed(int triangle, int corner) const { return neighbors[triangle][corner] < triangle; }
  /// The end points of an edge, in counterclockwise order of its triangle.
  std::array<int, 2> edge(int triangle, int corner) const {
    const auto& t = triangles[triangle];
    return {t[(corner + 1) % 3], t[(corner + 2) % 3]};
  }
  /// The corner of neighbors[triangle][corner] that faces the same edge. The neighbour must not be -1.
  int mirror_corner(int triangle, int corner) const {
    const auto& n = neighbors[neighbors[triangle][corner]];
    return n[0] == triangle ? 0 : n[1] == triangle ? 1 : 2;
  }

  struct Dynamic;  ///< CGAL's triangulation, kept for local updates; null unless the dimension is 2
  std::unique_ptr<Dynamic> dynamic;
};

/// Triangulates by exact predicates; the result depends only on the points. Coordinates must be finite.
/// Expected O(n log n), about 250 bytes per point. Throws Cancelled, and Unavailable for more than 300 million points.
Delaunay_2 delaunay(std::span<const Point_2> points, Progress& progress);

/// Changes `triangulation` into one of `points`, by moving, inserting and removing single sites where that is
/// cheaper than starting afresh (up to some hundred changed points), else by `delaunay`. Point i is taken for the old
/// point i after a run of inserted or removed points was matched. The triangles are those of `delaunay(points)` up to
/// their order and the choice among cocircular sites. Returns true when it was done locally. Throws Cancelled, and then
/// leaves something that may only be destroyed or assigned to. Local: O(n) cheap comparisons + O(log n) per change.
bool update(Delaunay_2& triangulation, std::span<const Point_2> points, Progress& progress);

/// Whether a triangle and its neighbour across the edge have one circle, decided exactly. The neighbour must not be -1.
bool have_one_circle(const Delaunay_2& triangulation, int triangle, int corner);

/// Voronoi vertices: per triangle the circumcenter and circumradius.
struct Voronoi_2 {
  std::vector<Point_2> vertices;
  std::vector<double> radii;
};
Voronoi_2 voronoi(const Delaunay_2& triangulation, Progress& progress);

}  // namespace mesecina
