// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// Finds the inner poles of samples, and what changes about them when samples are added: per sample the cell of the
/// triangulation whose Voronoi vertex is its inner pole, the farthest inner vertex of its Voronoi cell; -1 for samples
/// without one. Exact up to the rounding of Voronoi vertices. What is found out about sides is kept for later.
/// [N. Amenta, S. Choi, R. Kolluri: The power crust, unions of balls, and the medial axis transform, 2001]
class Inner_poles_3 {
 public:
  /// `renewed` are the cells that are not what they were before, all at first; ascending. Returns the samples whose
  /// poles were looked for, those of these cells. O(n log n) for the first ones, later O(cells) with a small factor.
  std::vector<int> update(const Surface_samples_3& samples, const Delaunay_3& delaunay, std::span<const int> renewed,
                          const Solid_3& solid, Progress& progress);
  const std::vector<int>& cells() const { return poles_; }

 private:
  enum class Side : std::uint8_t { unknown, inner, outer };

  void classify(const Delaunay_3& delaunay, std::span<const int> renewed, double covering_radius, Progress& progress);

  std::vector<int> class_of_cell_;  ///< Voronoi vertices of one class are on the same side
  std::vector<Side> sides_;         ///< per class
  std::vector<int> poles_;
};

/// The poles of all samples at once.
std::vector<int> inner_pole_cells(const Surface_samples_3& samples, const Delaunay_3& delaunay, const Solid_3& solid,
                                  Progress& progress);

/// The balls of these cells, each once, in the order of the cells. Centers are moved by up to `perturbation` times the
/// radius in each coordinate, by a rule that depends on nothing but their order, and radii stay: many of these balls go
/// through one sample, which is degenerate. Negative cells are left out.
std::vector<Ball_3> balls_of_cells(const Delaunay_3& delaunay, std::vector<int> cells, double perturbation);

/// The point, moved by up to `reach` in each coordinate, by a rule that depends on the number only.
Point_3 moved(const Point_3& p, double reach, std::size_t number);

}  // namespace mesecina
