// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// A triangulation of CGAL with its point location, behind which the rest of the program need not look.
class Regular_locator_3;

/// The regular (weighted Delaunay) triangulation of balls, weights the squared radii. Exact for the balls as they are.
struct Regular_3 {
  std::vector<Ball_3> balls;
  int dimension = -1;  ///< of the affine hull of the balls that are not hidden
  /// Cells of dimension `dimension`, in space tetrahedra with positive orientation, as balls; -1 in unused places.
  std::vector<std::array<int, 4>> cells;
  /// Per cell the neighbour across from each of its balls; -1 outside of the convex hull.
  std::vector<std::array<int, 4>> neighbors;
  std::vector<std::uint8_t> is_hidden;  ///< per ball: its power cell is empty
  std::shared_ptr<const Regular_locator_3> locator;
};

/// O(n log n) for balls along a surface. Equal balls: the first one stays, the others are hidden.
Regular_3 regular_triangulation(std::vector<Ball_3> balls, Progress& progress);

/// A simplex of the dual complex and how it lies in it.
enum class Simplex_kind_3 : std::uint8_t {
  outside,   ///< not in the complex
  singular,  ///< in it, and face of nothing larger in it
  regular,   ///< in it, on its boundary, and face of something larger in it
  interior   ///< in it, and all around it are tetrahedra in it
};

/// The dual complex of a union of balls: the simplices of the regular triangulation whose power faces meet the union.
/// It has the homotopy type of the union. Simplices are given by their balls.
/// [H. Edelsbrunner: The union of balls and its dual shape, 1995]
struct Dual_3 {
  std::shared_ptr<const Regular_3> regular;
  std::vector<std::uint8_t> has_cell;  ///< per cell of the regular triangulation (when its dimension is 3)
  struct Triangle {
    std::array<int, 3> balls{};
    std::array<int, 2> cells{-1, -1};  ///< on both sides; -1 outside of the hull. The normal of the balls points to [1]
    Simplex_kind_3 kind = Simplex_kind_3::singular;
  };
  struct Edge {
    std::array<int, 2> balls{};
    Simplex_kind_3 kind = Simplex_kind_3::singular;
    bool has_triangle = false;  ///< it is an edge of a triangle of the complex
  };
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
  std::vector<Simplex_kind_3> vertices;  ///< per ball
};

/// Exact for the balls as they are. O(n).
Dual_3 dual_complex(std::shared_ptr<const Regular_3> regular, Progress& progress);

}  // namespace mesecina
