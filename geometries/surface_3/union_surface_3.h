// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "geometries/surface_3/union_boundary_3.h"

namespace mesecina {

/// The boundary of a union of balls as triangles.
struct Union_surface_3 {
  Triangle_mesh_3 mesh;
  std::vector<int> ball_of_triangle;  ///< the ball near whose sphere each one lies
  /// No point of the mesh is farther than this from the sphere of its ball, and no arc from its chords: together the
  /// bound of the distance to the boundary that was reached.
  double deviation = 0;
  /// Patches whose loops, as chords, cross however finely they are divided: there triangles may fold over each other,
  /// by less than the tolerance.
  std::size_t folded_patches = 0;
};

/// Each patch of the boundary on its own, along arcs that are divided once for both sides. Closed, manifold and
/// oriented outward, always, with the topology of the boundary of the dual complex: thin parts stay, whatever the
/// tolerance. Vertices lie on the boundary, to rounding; no point of the mesh is farther than `tolerance` (a positive
/// length) from the boundary, nor the other way round. O(n log n) for n patches and output triangles.
Union_surface_3 union_surface(std::shared_ptr<const Dual_3> dual, double tolerance, Progress& progress);

}  // namespace mesecina
