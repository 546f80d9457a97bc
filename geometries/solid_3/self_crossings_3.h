// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"
#include "geometries/solid_3/surface_locator_3.h"

namespace mesecina {

/// Pairs of triangles, the lesser first, sorted, that have more in common than corners and edges of both. Stops early
/// with at least `limit` pairs where there are so many; which ones is then not defined. `locator` is that of the mesh,
/// of which all triangles have area. Exact. Near-linear where few boxes of triangles meet.
std::vector<std::array<int, 2>> find_self_crossings(const Triangle_mesh_3& mesh, const Surface_locator_3& locator,
                                                    std::size_t limit, Progress& progress);

}  // namespace mesecina
