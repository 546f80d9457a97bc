// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/point.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {

using Cloud = std::vector<Point_3>;

/// In the unit cube.
Cloud random_cloud(int count, std::uint64_t seed);
/// With integer coordinates from 0 to `largest`: full of equal points, planes and spheres through many points.
Cloud integer_cloud(int count, int largest, std::uint64_t seed);
/// All integer points from 0 to side - 1.
Cloud lattice(int side);
/// The points of lattice(side) on the boundary of its cube.
Cloud cube_surface(int side);
Cloud sphere_cloud(const Point_3& center, double radius, int count, std::uint64_t seed);
/// No two axes are equal, so that the medial axis is a surface.
Cloud ellipsoid_cloud(int count, std::uint64_t seed);
/// Around the z-axis, evenly.
Cloud torus_cloud(double large, double small, int count, std::uint64_t seed);
Cloud joined(Cloud one, const Cloud& other);
Cloud shuffled(Cloud cloud, std::uint64_t seed);

/// The points in a file of data_folder()/3d; of a mesh its vertices.
Cloud real_cloud(const std::filesystem::path& name);

}  // namespace mesecina::test
