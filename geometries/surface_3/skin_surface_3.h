// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// More are refused: each one takes 2 ms along a medial axis, up to 7 ms in a heap, and 0.2 MB.
inline constexpr std::size_t most_skin_balls = 2000;

/// The skin surface around balls: like the boundary of their union, but smooth, with patches of spheres and
/// hyperboloids. `shrink_factor` in (0, 1): the smaller, the wider the blends. Closed, manifold, oriented outward;
/// vertices are within about a hundredth of the radii of the surface. Throws Unavailable when there are no balls with a
/// radius or too many. It cannot be cancelled while it runs. [H. Edelsbrunner: Deformable smooth surface design, 1999;
/// N. Kruithof, G. Vegter: Meshing skin surfaces with certified topology, 2007]
Triangle_mesh_3 skin_surface(const std::vector<Ball_3>& balls, double shrink_factor, Progress& progress);

}  // namespace mesecina
