// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/inputs.h"
#include "core/progress.h"
#include "geometries/solid_3/clean_mesh_3.h"

namespace mesecina {

// Each of these looks only at open edges, those with an odd number of triangles, and changes nothing where there are
// none. All are deterministic.

struct Stitched_3 {
  int joined_vertices = 0;  ///< with another one nearby
  int split_edges = 0;      ///< at vertices on them
  double farthest = 0;      ///< that a vertex was from the one, or the edge, it was joined with
};

/// Joins the ends of open edges that are at most `tolerance` from each other, and splits open edges at ends of others
/// that are at most so far from them (T-junctions), and cleans the mesh again. Near-linear where few are near to each
/// other.
Stitched_3 stitch(Clean_mesh_3& clean, double tolerance, Progress& progress);

struct Removed_patches_3 {
  int patches = 0;
  int triangles = 0;
  double area = 0;
};

/// Takes out patches (sets of triangles joined by edges of two) of which all boundary edges are open and at least one
/// has other triangles too: fins on a surface and walls inside of it. Small ones first, each only if it is still so and
/// its area at most `largest` of all. O(n log n).
Removed_patches_3 remove_fins(Clean_mesh_3& clean, double largest);

struct Filled_holes_3 {
  int holes = 0;
  int triangles = 0;
  double area = 0;       ///< of the new triangles, relative to what was there
  double longest = 0;    ///< of the perimeters of the holes
  bool is_done = false;  ///< false: there are holes that cannot be filled, and the mesh is as it was
};

/// Fills holes by surfaces of small area. Holes need a boundary of at most 1000 edges and triangles oriented alike
/// along it. [P. Liepa: Filling Holes in Meshes, 2003]
Filled_holes_3 fill_holes(Clean_mesh_3& clean, Progress& progress);

}  // namespace mesecina
