// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/progress.h"
#include "geometries/solid_3/solid_3.h"
#include "geometries/surface_3/union_boundary_3.h"

namespace mesecina {

/// Hausdorff distance between the surface of a solid and the boundary of a union of balls, relative to the diagonal of
/// the surface's bounding box.
struct Surface_error_3 {
  double from_input = 0;  ///< largest distance of a point of the surface to the boundary of the union
  double to_input = 0;    ///< largest distance of a point of the boundary of the union to the surface
  double resolution = 0;  ///< both may be too small by at most this

  double hausdorff() const { return std::max(from_input, to_input); }
};

/// Both are distances of real points, found by refining only pieces of the two surfaces of which no bound shows that
/// they hold none of the farthest points, until what is left is less than `resolution` (relative to the diagonal,
/// positive). Where this would take more than some ten million pieces, it stops with a larger one. The same result for
/// every number of threads. Near-linear in balls and triangles when `resolution` is about a tenth of the result.
Surface_error_3 surface_error(const Solid_3& solid, const Union_boundary_3& boundary, double resolution,
                              Progress& progress);

}  // namespace mesecina
