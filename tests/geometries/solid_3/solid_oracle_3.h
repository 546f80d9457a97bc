// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/inputs.h"

namespace mesecina::test {

/// By the definition, in rational numbers and with rays in random directions, over all triangles.
enum class Place { outside, on_surface, inside };
Place place_of(const Triangle_mesh_3& closed_mesh, const Point_3& p);

/// To the nearest triangle, by the nearest point of its plane or of its edges.
double distance_to(const Triangle_mesh_3& mesh, const Point_3& p);

/// Pairs of triangles whose intersection, constructed exactly, is more than what they share.
std::vector<std::array<int, 2>> crossing_pairs(const Triangle_mesh_3& mesh);

}  // namespace mesecina::test
