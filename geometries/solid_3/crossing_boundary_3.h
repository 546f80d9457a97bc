// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"
#include "geometries/solid_3/surface_locator_3.h"

namespace mesecina {

/// What is inside of triangles that cross each other.
enum class Inside_rule : std::uint8_t {
  as_it_is,  ///< nothing is asked: the triangles of this cluster stay
  positive,  ///< what they wind around a positive number of times
  odd        ///< what they wind around an odd number of times
};

/// Triangles of a mesh, by clusters that do not cross each other.
struct Crossing_clusters_3 {
  std::vector<int> cluster;                   ///< per triangle
  std::vector<Inside_rule> rule;              ///< per cluster
  std::vector<std::array<int, 2>> crossings;  ///< all pairs of triangles that cross
};

/// The boundary of the insides of all clusters, normals outward. What happens where is decided exactly, for the mesh as
/// it is; only then the new vertices are rounded. So the result is closed, and crosses itself by no more than rounding
/// errors, of which some triangles without area may remain. `locator` is that of the mesh, in which every edge of a
/// cluster has an even number of triangles. nullopt where more than about 10000 points are on three triangles each,
/// which would take seconds. O(n + c log n) for c crossings, tens of microseconds each.
std::optional<Triangle_mesh_3> crossing_boundary(const Triangle_mesh_3& mesh, const Crossing_clusters_3& clusters,
                                                 const Surface_locator_3& locator, Progress& progress);

}  // namespace mesecina
