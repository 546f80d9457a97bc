// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/inputs.h"
#include "core/primitives.h"
#include "core/progress.h"

namespace mesecina {

/// The regular (weighted Delaunay) triangulation of balls. Weights are the squared radii, rounded; for these it is
/// exact.
struct Regular_3 {
  std::vector<Ball_3> balls;
  /// Tetrahedra with positive orientation, as balls, and around their convex hull infinite ones, which have -1 in place
  /// of a ball (in more than one place only where all balls lie in a plane).
  std::vector<std::array<int, 4>> cells;
  std::vector<std::array<int, 4>> neighbors;  ///< per cell the cell across from each of its places
  std::vector<int> cell_of_ball;              ///< some cell that has it; -1 for hidden balls, whose power cell is empty

  bool is_infinite(int cell) const {
    const auto& c = cells[cell];
    return (c[0] | c[1] | c[2] | c[3]) < 0;
  }
};

/// Of balls with the same center only a largest one, the first of them, is not hidden. The order of cells depends on
/// the balls only. O(n log n) for balls along a surface. Throws Unavailable when there are no balls.
Regular_3 regular_triangulation(std::vector<Ball_3> balls, Progress& progress);

/// The same for sets of balls that become larger: where all balls of the last set are in the next one, in the same
/// order, only the others are inserted, each in O(log n), and cells are written in O(n). What comes out does not depend
/// on that.
class Growing_regular_3 {
 public:
  Growing_regular_3();
  Growing_regular_3(Growing_regular_3&&) noexcept;
  Growing_regular_3& operator=(Growing_regular_3&&) noexcept;
  ~Growing_regular_3();

  /// As regular_triangulation. After an exception only destruction and the next call are of use.
  Regular_3 triangulate(std::vector<Ball_3> balls, Progress& progress);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The finite cell that holds the point (one of them, on a boundary), found by walking from `start`; -1 outside of the
/// convex hull. Safe to call from several threads. Exact.
int locate(const Regular_3& regular, const Point_3& point, int start);

/// How a simplex lies in the dual complex.
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
  struct Triangle {
    std::array<int, 3> balls{};
    /// Cells of the regular triangulation: the normal (right-hand rule) of the balls points into the second one.
    std::array<int, 2> cells{};
    Simplex_kind_3 kind = Simplex_kind_3::singular;
  };
  struct Edge {
    std::array<int, 2> balls{};
    Simplex_kind_3 kind = Simplex_kind_3::singular;
  };

  std::shared_ptr<const Regular_3> regular;
  std::vector<std::uint8_t> has_cell;  ///< per cell of the regular triangulation
  /// Per cell: it is in the complex, and its four spheres meet in one point, exactly.
  std::vector<std::uint8_t> is_flat;
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
  std::vector<Simplex_kind_3> vertices;  ///< per ball
};

/// Exact for the weights of the triangulation. O(n).
Dual_3 dual_complex(std::shared_ptr<const Regular_3> regular, Progress& progress);

/// Of the complex, and so of the union: components, tunnels and cavities. O(n α(n)).
Topology topology(const Dual_3& dual);

}  // namespace mesecina
