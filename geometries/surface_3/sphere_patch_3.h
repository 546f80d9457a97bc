// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// A part of a sphere bounded by loops of points on it, with the patch on the left for who looks from outside.
struct Sphere_patch_3 {
  Ball_3 ball;
  std::vector<std::vector<Point_3>> loops;
  /// Outside of the patch is all of the sphere within some angle of the pole, a unit vector; and that angle's cosine.
  Point_3 pole;
  double cosine = 1;
};

/// Points are those of the loops, one loop after the other, then the inner ones.
struct Patch_mesh_3 {
  std::vector<Point_3> inner_points;  ///< on the sphere
  std::vector<std::array<int, 3>> triangles;
};

/// The Delaunay triangles on the sphere between the loops, with so many inner points that no triangle is farther than
/// `deviation` from the sphere. nullopt where loops, as chords between their points, cross or touch. O(n^2), usually
/// O(n log n).
std::optional<Patch_mesh_3> triangulate_patch(const Sphere_patch_3& patch, double deviation);

/// Triangles with these loops as boundary, whatever they look like: where nothing else is possible. Of the topology of
/// the patch. O(n^3) at worst.
Patch_mesh_3 fill_patch(const Sphere_patch_3& patch);

/// A whole sphere, as a divided octahedron.
Patch_mesh_3 triangulate_sphere(const Ball_3& ball, double deviation);

}  // namespace mesecina
