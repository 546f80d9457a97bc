// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <vector>

#include "core/inputs.h"
#include "geometries/solid_3/solid_3.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {

/// All of these are oriented outward.
Triangle_mesh_3 box_mesh(const Point_3& lower, const Point_3& upper);
Triangle_mesh_3 sphere_mesh(const Point_3& center, double radius, int rings = 12);
/// Around the z-axis.
Triangle_mesh_3 torus_mesh(double large, double small, int around = 32, int across = 16);
/// In the plane z = 0, of columns x rows squares of two triangles.
Triangle_mesh_3 sheet_mesh(int columns, int rows);

Triangle_mesh_3 joined(const std::vector<Triangle_mesh_3>& meshes);
Triangle_mesh_3 turned(Triangle_mesh_3 mesh);
Triangle_mesh_3 shuffled(Triangle_mesh_3 mesh, std::uint64_t seed);
/// Each triangle has its own three vertices.
Triangle_mesh_3 unwelded(const Triangle_mesh_3& mesh);

Solid_3 solid_of(const Triangle_mesh_3& mesh, Repair repair = Repair::automatic, int threads = 1);
/// The reason why there is no solid; empty where there is one.
std::string reason_of(const Triangle_mesh_3& mesh, Repair repair = Repair::automatic);
std::vector<std::uint8_t> inside_of(const Solid_3& solid, const std::vector<Point_3>& points, int threads = 1);

/// In a box a little larger than that of the mesh.
std::vector<Point_3> points_around(const Triangle_mesh_3& mesh, int count, std::uint64_t seed);
/// Vertices of the mesh, and points of which some coordinates are those of vertices: the rays that are difficult.
std::vector<Point_3> difficult_points(const Triangle_mesh_3& mesh, int count, std::uint64_t seed);

/// Signed volume.
double volume(const Triangle_mesh_3& mesh);
/// Every edge has as many triangles in one direction as in the other.
bool is_closed(const Triangle_mesh_3& mesh);

/// The mesh in a file of data_folder()/3d.
Triangle_mesh_3 real_mesh(const std::filesystem::path& name);

}  // namespace mesecina::test
