// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/inputs.h"
#include "core/portable_random.h"
#include "core/progress.h"

namespace mesecina {

/// What vertices of a mesh move by. Vertices at one place are one.
struct Mesh_neighbors_3 {
  std::vector<int> first_at_place;  ///< per vertex
  /// Per vertex the others that edges join it to, ascending: offsets and vertices. Where the mesh ends, along edges of
  /// one triangle, only those along its end: so it neither frays nor draws back. None for vertices that are not the
  /// first at their place.
  std::vector<int> offsets;
  std::vector<int> vertices;

  std::span<const int> of(std::size_t vertex) const {
    return std::span(vertices).subspan(offsets[vertex], offsets[vertex + 1] - offsets[vertex]);
  }
};

/// Triangles with a coordinate that is no finite number are left out. O(n log n).
Mesh_neighbors_3 mesh_neighbors(const Triangle_mesh_3& mesh, Progress& progress);

/// Every vertex moves toward the mean of its neighbours by one factor after the other, all at once; vertices without
/// neighbours stay. O(n).
std::vector<Point_3> smoothed(const Triangle_mesh_3& mesh, const Mesh_neighbors_3& neighbors,
                              std::span<const double> factors, Progress& progress);

/// Every vertex moves along its normal, the mean of those of its triangles by their area, by up to `amplitude` times
/// the mean length of the edges to its neighbours to either side, evenly at random. Vertices without neighbours, or
/// where triangles point in opposite directions, stay. O(n).
std::vector<Point_3> with_noise(const Triangle_mesh_3& mesh, const Mesh_neighbors_3& neighbors, double amplitude,
                                Portable_random& random);

}  // namespace mesecina
