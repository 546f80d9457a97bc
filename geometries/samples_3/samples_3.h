// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometries/delaunay_3/delaunay_3.h"
#include "geometries/solid_3/solid_3.h"

namespace mesecina {

/// Points of a surface.
struct Surface_samples_3 {
  std::vector<Point_3> points;
  std::vector<Point_3> normals;  ///< per sample that of the surface, of length 1; of vertices a mean
  /// Per sample: every point of the surface around it is at most about this far from a sample.
  std::vector<double> spacing;
  double covering_radius = 0;  ///< every point of the surface is at most this far from a sample
};

/// No two samples are nearer to each other than 0.7 `distance`, and every point of the surface is within `distance` of
/// one. Corners of the mesh come first. O(area / distance^2 + triangles). Throws Unavailable when there would be more
/// than `most_samples`.
Surface_samples_3 sample_surface(const Triangle_mesh_3& surface, double distance, Progress& progress);

/// Per sample the cell of the triangulation whose Voronoi vertex is its inner pole, the farthest inner vertex of its
/// Voronoi cell; -1 for samples without one. Exact up to the rounding of Voronoi vertices. O(n log n).
/// [N. Amenta, S. Choi, R. Kolluri: The power crust, unions of balls, and the medial axis transform, 2001]
std::vector<int> inner_pole_cells(const Surface_samples_3& samples, const Delaunay_3& delaunay, const Solid_3& solid,
                                  Progress& progress);

/// The balls of these cells, each once, in the order of the cells. Centers are moved by up to `perturbation` times the
/// radius in each coordinate, by a rule that depends on nothing but their order, and radii stay: many of these balls go
/// through one sample, which is degenerate. Negative cells are left out.
std::vector<Ball_3> balls_of_cells(const Delaunay_3& delaunay, std::vector<int> cells, double perturbation);

}  // namespace mesecina
