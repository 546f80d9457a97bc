// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/sides_3/sides_3.h"

namespace mesecina {

/// Of the Voronoi vertices of delaunay_3_key: by the solid where there is a mesh, else by the power crust.
inline constexpr Key<Voronoi_sides_3> voronoi_sides_3_key{"voronoi-sides-3"};

/// Which Voronoi vertices of the samples lie inside of the shape, and what follows from that.
void register_sides_3(Registry& registry);

}  // namespace mesecina
