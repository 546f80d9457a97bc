// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/union_3/vertex_voronoi_3.h"

namespace mesecina {

/// Of the vertices of the union of the balls.
inline constexpr Key<Vertex_voronoi_3> vertex_voronoi_3_key{"vertex-voronoi-3"};

/// What lies between the structures: for who wants to see how one follows from the other.
void register_internals_3(Registry& registry);

}  // namespace mesecina
