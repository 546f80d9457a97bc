// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometries/samples_3/samples_3.h"

namespace mesecina {

/// What can be read off samples, their triangulation and their inner poles.
struct Sampled_balls_3 {
  Surface_samples_3 samples;
  Delaunay_3 delaunay;
  std::vector<int> poles;  ///< per sample its cell, as inner_pole_cells returns
  /// Per sample: add_samples has looked at what is around it, with this pole and spacing.
  std::vector<std::uint8_t> is_settled;
};

/// Triangulates the samples and finds their poles. What is around samples that keep their pole stays settled.
/// O(n log n).
void triangulate_samples(Sampled_balls_3& balls, const Solid_3& solid, Progress& progress);

/// Where a solid is thin: Voronoi vertices inside of it that are less than `factor` spacings away from samples on both
/// sides, which are seen at an angle over 120 degrees and have normals that point apart. By normals, not exactly; near
/// the surface of a solid that is thick there are none. O(n).
std::vector<int> thin_cells(const Surface_samples_3& samples, const Delaunay_3& delaunay, double factor);

/// Per sample the spacing that is wanted around it: half of what is there around samples that have no inner pole and,
/// if asked for, on both sides of thin parts, as far as it is needed; changing slowly from there. At least `finest`.
/// O(n log n).
std::vector<double> wanted_spacing(const Sampled_balls_3& balls, bool also_at_thin_parts, double finest);

/// Adds samples where the surface has none within the wanted spacing, and where it is farther than `gap` away from the
/// spheres of the poles of the samples around; looks only around samples that are not settled. Returns how many. The
/// same for every number of threads. O(triangles + area / spacing^2).
std::size_t add_samples(Sampled_balls_3& balls, const Triangle_mesh_3& surface, const std::vector<double>& wanted,
                        double gap, Progress& progress);

}  // namespace mesecina
