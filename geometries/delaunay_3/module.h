// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/delaunay_3/delaunay_3.h"

namespace mesecina {

/// Of the samples of the mesh; without a mesh of the points that were read.
inline constexpr Key<Delaunay_3> delaunay_3_key{"delaunay-triangulation-3"};

/// The points that triangulations and poles are of: the samples of the mesh; without a mesh the points that were read.
/// Throws Unavailable where there are none.
std::vector<Point_3> sample_points(Context& context);
/// Tells the user when `count` of `all` samples are equal to others.
void warn_of_duplicates(Context& context, std::size_t count, std::size_t all);

/// Delaunay triangulation and Voronoi diagram of the samples.
void register_delaunay_3(Registry& registry);

}  // namespace mesecina
