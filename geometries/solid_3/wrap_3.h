// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// A closed manifold surface around triangles, without crossings, normals outward: balls of radius `alpha` are kept
/// outside, so holes narrower than 2 alpha are closed, and the surface stays at a distance of about `offset`. At least
/// one triangle has area; both numbers are positive.
/// [C. Portaneri, M. Rouxel-Labbé, M. Hemmer, D. Cohen-Steiner, P. Alliez: Alpha wrapping with an offset, 2022]
Triangle_mesh_3 wrap(const Triangle_mesh_3& mesh, double alpha, double offset, Progress& progress);

}  // namespace mesecina
