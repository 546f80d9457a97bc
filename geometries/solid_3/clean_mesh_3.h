// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs.h"
#include "geometries/solid_3/mesh_edges_3.h"

namespace mesecina {

/// A mesh of which each vertex is used, no two vertices are at the same place, every triangle has area, and no two
/// triangles have the same corners; and how much of the input that left out.
struct Clean_mesh_3 {
  Triangle_mesh_3 mesh;
  Mesh_edges_3 edges;
  int joined_vertices = 0;      ///< used, but at the place of another one
  int flat_triangles = 0;       ///< without area, exactly
  int endless_triangles = 0;    ///< with a coordinate that is no finite number
  int duplicate_triangles = 0;  ///< with the corners of another one
};

/// Keeps the order of vertices and of triangles. Of triangles with the same corners the first stays; but a patch of
/// them goes as a whole where what is around it is closed without it (a wall between two boxes that share it). O(n).
Clean_mesh_3 clean_mesh(const Triangle_mesh_3& mesh);

/// Per vertex the first one at its place. O(n).
std::vector<int> first_at_place(const std::vector<Point_3>& vertices);

/// Renumbers the others in their order. O(n).
void remove_unused_vertices(Triangle_mesh_3& mesh);

/// Exact.
bool has_area(const Point_3& p, const Point_3& q, const Point_3& r);

}  // namespace mesecina
