// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometries/union_3/medial_values_3.h"

namespace mesecina {

/// Per vertex of a medial axis of a union of balls its scale importance among all vertices, at least 1; +infinity for
/// the largest. Near-linear in practice.
///
/// Of two medial balls that nearly coincide centers and radii as rounded say nothing about d / (r' - r). But no radius
/// grows faster than the distance to a contact does, so quotients are raised to what the contacts of the smaller ball
/// allow (slope_of_vertices, scale_importance): rounding makes no value smaller than that, which is where the quotients
/// with ever nearer medial balls tend to in the direction of fastest growth.
std::vector<double> scale_of_vertices(const Medial_complex_3& complex, Progress& progress);

/// Of faces, and of edges and vertices that bound nothing, the least of their vertices; of the others the largest that
/// they bound.
Medial_values_3 scale_values(const Medial_complex_3& complex, Progress& progress);

}  // namespace mesecina
