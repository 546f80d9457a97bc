// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// How the triangles of a mesh are joined. Half-edge 3t + k of triangle t goes from its corner k to its corner k + 1.
struct Mesh_edges_3 {
  /// Per half-edge the other one of its edge, in whatever direction; -1 where the edge has not exactly two.
  std::vector<int> twin;
  /// The half-edges of each edge that has not exactly two, ascending.
  std::vector<std::vector<int>> irregular;

  bool is_open() const;  ///< some edge has an odd number of triangles
};

/// O(n) for vertices with a bounded number of triangles.
Mesh_edges_3 find_edges(const Triangle_mesh_3& mesh);

inline int half_edge_source(const Triangle_mesh_3& mesh, int h) { return mesh.triangles[h / 3][h % 3]; }
inline int half_edge_target(const Triangle_mesh_3& mesh, int h) { return mesh.triangles[h / 3][(h + 1) % 3]; }

/// Sets of triangles joined by edges, each with the turns that orient it.
struct Mesh_components_3 {
  int count = 0;
  std::vector<int> component;         ///< per triangle; numbered by their first triangles
  std::vector<std::uint8_t> flipped;  ///< per triangle: turned around against the input
  /// Per component: after the turns each edge has as many triangles in one direction as in the other.
  std::vector<std::uint8_t> is_oriented;
  int turned_triangles = 0;  ///< against most of their component
};

/// Orients across edges of two triangles. Components whose input is oriented already stay as they are; in others most
/// triangles do. O(n).
Mesh_components_3 orient_components(const Triangle_mesh_3& mesh, const Mesh_edges_3& edges);

}  // namespace mesecina
