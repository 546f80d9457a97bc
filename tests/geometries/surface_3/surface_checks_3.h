// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <span>

#include "core/primitives.h"

namespace mesecina::test {

/// Each edge has two triangles, which run through it in opposite directions, the triangles at each vertex are one
/// cycle, no triangle has a vertex twice, and no vertex is unused.
testing::AssertionResult is_closed_manifold(const Triangle_mesh_3& mesh);

/// Euler and Betti numbers of the mesh.
Topology topology(const Triangle_mesh_3& mesh);

/// Of the solid to which the triangles' normals point away.
double signed_volume(const Triangle_mesh_3& mesh);

/// Of a point to the nearest sphere, negative inside of the union.
double distance_to_union(std::span<const Ball_3> balls, const Point_3& point);

/// Points of the boundary of the union: every point of it, except near edges where the spheres meet, is within about
/// `spacing` of one.
std::vector<Point_3> boundary_points(std::span<const Ball_3> balls, double spacing);

/// By trying all triangles.
double distance_to_mesh(const Triangle_mesh_3& mesh, const Point_3& point);

/// Points of each triangle: corners, middles of sides and a few inside.
std::vector<Point_3> mesh_points(const Triangle_mesh_3& mesh);

}  // namespace mesecina::test
