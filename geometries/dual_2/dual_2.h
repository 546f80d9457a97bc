// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/primitives.h"
#include "geometries/regular_2/regular_2.h"

namespace mesecina {

/// What a simplex of the regular triangulation is in the dual complex.
enum class Dual_kind : std::uint8_t {
  outside,   ///< not in the complex
  singular,  ///< in it, and face of nothing larger in it
  regular,   ///< in it, on its boundary, and face of something larger in it
  interior   ///< in it, and all around it are triangles in it
};

/// An edge of the regular triangulation that is in the complex, once. From a to b, `left` is the triangle on its left,
/// -1 outside of the hull (or in dimension 1).
struct Dual_edge {
  int a = 0;
  int b = 0;
  int left = -1;
  int right = -1;
  Dual_kind kind = Dual_kind::singular;
};

/// The dual complex of a union of disks: the simplices of the regular triangulation whose power faces meet the union of
/// the disks with squared radii r^2 + alpha. It has the homotopy type of that union.
/// [H. Edelsbrunner: The union of balls and its dual shape, 1995]
struct Dual_2 {
  std::shared_ptr<const Regular_2> regular;
  double alpha = 0;
  std::vector<std::uint8_t> has_triangle;  ///< per triangle of the regular triangulation
  std::vector<Dual_edge> edges;
  /// Per disk; `outside` for hidden ones and for those that the others cover where their cell is. A regular one may
  /// have singular edges besides its triangles.
  std::vector<Dual_kind> vertices;

  /// Per triangle: its three circles (of squared radii r^2 + alpha) pass through its power vertex, exactly.
  std::vector<std::uint8_t> is_flat;
};

/// Exact for the disks as they are and the given alpha. alpha: in squared units of the input; may be negative. O(n).
Dual_2 dual_complex(std::shared_ptr<const Regular_2> regular, double alpha, Progress& progress);

/// Euler characteristic and Betti numbers b0, b1 of the complex. O(n α(n)).
Topology topology(const Dual_2& dual);

}  // namespace mesecina
