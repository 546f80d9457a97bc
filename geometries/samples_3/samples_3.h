// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometries/delaunay_3/delaunay_3.h"
#include "geometries/solid_3/solid_3.h"

namespace mesecina {

/// Points of a surface, evenly spaced.
struct Surface_samples_3 {
  std::vector<Point_3> points;
  double covering_radius = 0;  ///< every point of the surface is at most this far from one of them
};

/// No two samples are nearer to each other than 0.7 `distance`, and every point of the surface is within `distance` of
/// one. Corners of the mesh come first. O(area / distance^2 + triangles). Throws Unavailable when there would be more
/// than `most_samples`.
Surface_samples_3 sample_surface(const Triangle_mesh_3& surface, double distance, Progress& progress);

/// The inner poles of samples, of which `delaunay` is the triangulation: per sample the farthest inner vertex of its
/// Voronoi cell, each pole once. As balls, they approximate the solid. Centers are moved by up to `perturbation` times
/// the radius, by a rule that depends on nothing but their order, and radii keep the nearest sample on the sphere: many
/// of these balls go through one sample, which is degenerate. O(n log n). Throws Unavailable when there are none. [N.
/// Amenta, S. Choi, R. Kolluri: The power crust, unions of balls, and the medial axis transform, 2001]
std::vector<Ball_3> inner_poles(const Surface_samples_3& samples, const Delaunay_3& delaunay, const Solid_3& solid,
                                double perturbation, Progress& progress);

}  // namespace mesecina
