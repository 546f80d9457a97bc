// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/solid_3.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/outcome.h"
#include "geometries/parallel.h"
#include "geometries/solid_3/clean_mesh_3.h"
#include "geometries/solid_3/nesting_3.h"
#include "geometries/solid_3/surface_locator_3.h"

namespace mesecina {

namespace {

/// Every edge has two triangles, and the triangles around each vertex are one fan.
bool is_manifold(const Triangle_mesh_3& mesh, const Mesh_edges_3& edges) {
  if (!edges.irregular.empty()) return false;
  std::vector<int> corners(mesh.vertices.size(), 0);
  for (const std::array<int, 3>& t : mesh.triangles)
    for (const int v : t) ++corners[v];
  std::vector<std::uint8_t> is_seen(mesh.vertices.size(), 0);
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    const int v = half_edge_source(mesh, h);
    if (is_seen[v]) continue;
    is_seen[v] = 1;
    // Around v: the half-edge that arrives at it in the same triangle, and across that edge the next one that leaves
    // it.
    int g = h;
    do {
      const int arriving = 3 * (g / 3) + (g + 2) % 3;
      g = edges.twin[arriving];
      --corners[v];
    } while (g != h);
    if (corners[v] != 0) return false;
  }
  return true;
}

/// Of the solid, from its surface: the boundary of a solid has twice its Euler characteristic.
Topology topology_of(const Triangle_mesh_3& surface, const std::vector<int>& depth) {
  const auto vertices = static_cast<std::int64_t>(surface.vertices.size());
  const auto triangles = static_cast<std::int64_t>(surface.triangles.size());
  Topology result;
  result.euler = (vertices - triangles / 2) / 2;
  result.betti[0] = std::ranges::count_if(depth, [](int d) { return d % 2 == 0; });
  result.betti[2] = std::ranges::count_if(depth, [](int d) { return d % 2 == 1; });
  result.betti[1] = result.betti[0] + result.betti[2] - result.euler;
  return result;
}

}  // namespace

Solid_3 make_solid(std::shared_ptr<const Triangle_mesh_3> mesh, Repair repair, Progress& progress) {
  (void)repair;
  Clean_mesh_3 clean = clean_mesh(*mesh);
  if (clean.mesh.triangles.empty()) throw Unavailable("The mesh has no triangle with area.");
  const Mesh_components_3 parts = orient_components(clean.mesh, clean.edges);
  if (clean.edges.is_open()) throw Unavailable("The mesh is open.");
  for (std::size_t t = 0; t < clean.mesh.triangles.size(); ++t)
    if (parts.flipped[t]) std::swap(clean.mesh.triangles[t][1], clean.mesh.triangles[t][2]);

  Solid_3 solid;
  solid.components = parts.count;
  solid.surface = std::move(clean.mesh);
  auto locator = std::make_shared<Surface_locator_3>(solid.surface, progress);
  const Nesting_3 nesting = find_nesting(*locator, parts.component, parts.count, progress);
  std::vector<std::uint8_t> is_turned(parts.count, 0);
  for (int c = 0; c < parts.count; ++c) is_turned[c] = nesting.is_inward[c] != (nesting.depth[c] % 2 == 1) ? 1 : 0;
  if (std::ranges::count(is_turned, 1) > 0) {
    for (std::size_t t = 0; t < solid.surface.triangles.size(); ++t)
      if (is_turned[parts.component[t]]) std::swap(solid.surface.triangles[t][1], solid.surface.triangles[t][2]);
    locator = std::make_shared<Surface_locator_3>(solid.surface, progress);
  }
  if (parts.turned_triangles > 0 || std::ranges::count(is_turned, 1) > 0) {
    solid.treatment = "oriented";
    clean.edges = find_edges(solid.surface);
  } else {
    solid.treatment = "none";
  }
  if (is_manifold(solid.surface, clean.edges)) solid.topology = topology_of(solid.surface, nesting.depth);
  solid.locator = std::move(locator);
  return solid;
}

std::vector<std::uint8_t> are_inside(const Solid_3& solid, std::span<const Point_3> points, Progress& progress) {
  std::vector<std::uint8_t> result(points.size());
  parallel_for(points.size(), progress, [&](std::size_t i) { result[i] = solid.locator->contains(points[i]) ? 1 : 0; });
  return result;
}

std::vector<double> distances_to_surface(const Solid_3& solid, std::span<const Point_3> points, Progress& progress) {
  std::vector<double> result(points.size());
  parallel_for(points.size(), progress,
               [&](std::size_t i) { result[i] = std::sqrt(solid.locator->squared_distance(points[i])); });
  return result;
}

}  // namespace mesecina
