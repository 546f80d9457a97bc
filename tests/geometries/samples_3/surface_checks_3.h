// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/inputs.h"

namespace mesecina::test {

/// Points of the surface, evenly by area.
std::vector<Point_3> random_surface_points(const Triangle_mesh_3& mesh, int count, std::uint64_t seed);

/// By looking at all of them; infinite without points.
double distance_to_nearest(const std::vector<Point_3>& points, const Point_3& p);

/// A column over a polygon in the plane z = 0, counterclockwise, whose first corner sees all of it; oriented outward.
Triangle_mesh_3 column_mesh(const std::vector<Point_2>& polygon, double height);

}  // namespace mesecina::test
