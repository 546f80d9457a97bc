// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// Where pieces of a closed surface were triangulated each on its own, two vertices may be joined by more than one
/// edge, and two triangles may have the same three corners. Such edges inside a piece get a point in their middle,
/// which `place` puts where it belongs on the piece. `piece_of_triangle` follows. O(n log n).
void split_double_edges(Triangle_mesh_3& mesh, std::vector<int>& piece_of_triangle,
                        const std::function<Point_3(int piece, const Point_3& middle)>& place);

/// Contracts edges of a closed manifold mesh that are shorter than `limit` to one of their ends, where the topology
/// stays and no triangle turns over, but for those with all sides shorter than that. No vertex comes to stand for one
/// farther away than `limit`. Vertices that are not used any more are removed, and `piece_of_triangle` follows. O(n log
/// n).
void collapse_short_edges(Triangle_mesh_3& mesh, std::vector<int>& piece_of_triangle, double limit, Progress& progress);

}  // namespace mesecina
