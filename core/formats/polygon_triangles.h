// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "core/inputs.h"

namespace mesecina {

inline constexpr std::size_t most_corners_of_nonconvex_polygons = 10'000;

/// Appends to the mesh the n - 2 triangles of a polygon over its vertices, with the polygon's orientation. The polygon
/// is looked at in the coordinate plane most parallel to it. If it is convex there the triangles are the fan of its
/// first corner; if it is not, ears are cut off, and if it crosses itself the triangles cover it somehow. False, and
/// nothing is appended, if it is not convex and has too many corners. O(n) if convex, else O(n^2).
bool append_triangles(Triangle_mesh_3& mesh, std::span<const int> polygon);

}  // namespace mesecina
