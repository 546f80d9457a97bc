// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// The skin surface around balls: like the boundary of their union, but smooth, with patches of spheres and
/// hyperboloids. `shrink_factor` in (0, 1): the smaller, the wider the blends. Closed, manifold, oriented outward as a
/// whole; its vertices lie on the skin surface, to rounding, and edges are within about `tolerance` (a positive length)
/// of it. Where patches are narrower than that, a few triangles in a thousand lie backwards, within it. Which parts
/// there are is decided exactly. Tolerances below a ten-millionth of the size are taken for that. Throws Unavailable
/// when no ball has a radius. O(n log n) for n simplices of the regular triangulation and output triangles. [H.
/// Edelsbrunner: Deformable smooth surface design, 1999; N. Kruithof, G. Vegter: Meshing skin surfaces with certified
/// topology, 2007]
Triangle_mesh_3 skin_surface(const std::vector<Ball_3>& balls, double shrink_factor, double tolerance,
                             Progress& progress);

}  // namespace mesecina
