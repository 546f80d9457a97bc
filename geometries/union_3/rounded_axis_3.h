// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometries/union_3/union_3.h"

namespace mesecina {

/// The medial axis of a union of balls as the rounded points of V(U) say. Where more spheres than three meet in nearly
/// one point, or vertices of the union lie on a circle, parts of it may be missing or too much.
Medial_complex_3 rounded_medial_axis(const Union_vertices_3& vertices, Progress& progress);

}  // namespace mesecina
