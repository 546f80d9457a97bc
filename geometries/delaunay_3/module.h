// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/delaunay_3/delaunay_3.h"

namespace mesecina {

/// Of the samples of the mesh; without a mesh of the points that were read.
inline constexpr Key<Delaunay_3> delaunay_3_key{"delaunay-triangulation-3"};

/// The Delaunay triangulation of the samples.
void register_delaunay_3(Registry& registry);

}  // namespace mesecina
