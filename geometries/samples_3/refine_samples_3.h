// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometries/delaunay_3/growing_delaunay_3.h"
#include "geometries/samples_3/graded_grid_3.h"
#include "geometries/samples_3/samples_3.h"

namespace mesecina {

/// What can be read off samples, their triangulation and their inner poles.
class Sampled_balls_3 {
 public:
  Surface_samples_3 samples;
  /// Per sample: add_samples has looked at what is around it, with this pole and spacing.
  std::vector<std::uint8_t> is_settled;

  const Delaunay_3& delaunay() const { return triangulation_.get(); }
  /// Per sample its cell, as Inner_poles_3 has them.
  const std::vector<int>& poles() const { return poles_.cells(); }
  /// Of all samples in the triangulation, with their numbers; after the first call of triangulate.
  const Graded_grid_3& grid() const { return *grid_; }
  /// Sets the spacing around the samples, all in the triangulation.
  void set_spacing(std::vector<double> spacing);

  /// Adds those samples to the triangulation that are not in it yet, and finds poles. What is around samples that keep
  /// their pole stays settled. Returns the cells that are new or have another number. O(n log n) for the first ones,
  /// later about O(n) with a small factor.
  std::vector<int> triangulate(const Solid_3& solid, Progress& progress);

 private:
  Growing_delaunay_3 triangulation_;
  Inner_poles_3 poles_;
  std::optional<Graded_grid_3> grid_;
};

/// Per sample the spacing that is wanted around it: half of what is there around `crowded` samples and those that have
/// no inner pole; changing slowly from there. At least `finest`. O(n log n).
std::vector<double> wanted_spacing(const Sampled_balls_3& balls, std::span<const int> crowded, double finest);

/// Adds samples where the surface has none within the wanted spacing, and where it is farther than `gap` away from the
/// spheres of the poles of the samples around; looks only around samples that are not settled. Returns how many. The
/// same for every number of threads. O(triangles + area / spacing^2).
std::size_t add_samples(Sampled_balls_3& balls, const Triangle_mesh_3& surface, const std::vector<double>& wanted,
                        double gap, Progress& progress);

}  // namespace mesecina
