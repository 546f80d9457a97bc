// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/clean_mesh_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>

#include "core/disjoint_sets.h"

namespace mesecina {

namespace {

bool is_finite(const Point_3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::uint64_t hash(const Point_3& p) {
  std::uint64_t result = 0;
  for (const double x : {p.x, p.y, p.z}) {
    // Zero has two representations.
    result ^= std::bit_cast<std::uint64_t>(x + 0.0);
    result *= 0x9e3779b97f4a7c15u;
    result ^= result >> 29;
  }
  return result;
}

/// Numbers vertices by their places, in the order of vertices, and leaves out triangles that are none.
void weld(const Triangle_mesh_3& mesh, Clean_mesh_3& result) {
  const std::vector<int> first = first_at_place(mesh.vertices);
  std::vector<std::uint8_t> is_used(mesh.vertices.size(), 0);
  std::vector<std::array<int, 3>>& triangles = result.mesh.triangles;
  triangles.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) {
    if (!is_finite(mesh.vertices[t[0]]) || !is_finite(mesh.vertices[t[1]]) || !is_finite(mesh.vertices[t[2]])) {
      ++result.endless_triangles;
      continue;
    }
    for (const int v : t) is_used[v] = 1;
    if (!has_area(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]])) {
      ++result.flat_triangles;
      continue;
    }
    triangles.push_back({first[t[0]], first[t[1]], first[t[2]]});
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    if (is_used[v] && first[v] != static_cast<int>(v)) ++result.joined_vertices;
  result.mesh.vertices = mesh.vertices;
  remove_unused_vertices(result.mesh);
}

int opposite(const Triangle_mesh_3& mesh, int h) { return mesh.triangles[h / 3][(h + 2) % 3]; }

bool has_duplicates(const Triangle_mesh_3& mesh, const Mesh_edges_3& edges) {
  const int count = static_cast<int>(edges.twin.size());
  for (int h = 0; h < count; ++h)
    if (edges.twin[h] >= 0 && opposite(mesh, h) == opposite(mesh, edges.twin[h])) return true;
  std::vector<int> opposites;
  for (const std::vector<int>& edge : edges.irregular) {
    opposites.clear();
    for (const int h : edge) opposites.push_back(opposite(mesh, h));
    std::ranges::sort(opposites);
    if (std::ranges::adjacent_find(opposites) != opposites.end()) return true;
  }
  return false;
}

void remove_duplicates(Clean_mesh_3& result) {
  Triangle_mesh_3& mesh = result.mesh;
  std::map<std::array<int, 3>, int> first;  // by sorted corners
  std::vector<std::array<int, 3>> kept;
  std::vector<std::uint8_t> was_repeated;
  for (const std::array<int, 3>& t : mesh.triangles) {
    std::array<int, 3> corners = t;
    std::ranges::sort(corners);
    const auto [entry, is_new] = first.try_emplace(corners, static_cast<int>(kept.size()));
    if (is_new) {
      kept.push_back(t);
      was_repeated.push_back(0);
    } else {
      ++result.duplicate_triangles;
      was_repeated[entry->second] = 1;
    }
  }
  mesh.triangles = std::move(kept);
  result.edges = find_edges(mesh);

  const Mesh_edges_3& edges = result.edges;
  Disjoint_sets patches(mesh.triangles.size());
  const int half_edges = static_cast<int>(edges.twin.size());
  for (int h = 0; h < half_edges; ++h)
    if (edges.twin[h] > h && was_repeated[h / 3] && was_repeated[edges.twin[h] / 3])
      patches.join(edges.twin[h] / 3, h / 3);
  // Where a patch ends at least one other triangle is; without the patch their number must be even.
  std::vector<std::uint8_t> has_end(mesh.triangles.size(), 0);
  std::vector<std::uint8_t> is_needed(mesh.triangles.size(), 0);
  for (int h = 0; h < half_edges; ++h) {
    if (edges.twin[h] < 0 || !was_repeated[h / 3] || was_repeated[edges.twin[h] / 3]) continue;
    is_needed[patches.find(h / 3)] = 1;
  }
  for (const std::vector<int>& edge : edges.irregular) {
    const auto others = std::ranges::count_if(edge, [&](int h) { return was_repeated[h / 3] == 0; });
    for (const int h : edge) {
      if (!was_repeated[h / 3]) continue;
      const int patch = patches.find(h / 3);
      if (others > 0 && others % 2 == 0) {
        has_end[patch] = 1;
      } else {
        is_needed[patch] = 1;
      }
    }
  }
  kept.clear();
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const int patch = patches.find(t);
    if (was_repeated[t] && has_end[patch] && !is_needed[patch]) {
      ++result.duplicate_triangles;
    } else {
      kept.push_back(mesh.triangles[t]);
    }
  }
  if (kept.size() < mesh.triangles.size()) {
    mesh.triangles = std::move(kept);
    remove_unused_vertices(mesh);
    result.edges = find_edges(mesh);
  }
}

}  // namespace

std::vector<int> first_at_place(const std::vector<Point_3>& vertices) {
  std::vector<int> table(std::bit_ceil(2 * vertices.size() + 1), -1);
  const std::size_t mask = table.size() - 1;
  std::vector<int> first(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    std::size_t slot = hash(vertices[v]) & mask;
    while (table[slot] >= 0 && vertices[table[slot]] != vertices[v]) slot = (slot + 1) & mask;
    if (table[slot] < 0) table[slot] = static_cast<int>(v);
    first[v] = table[slot];
  }
  return first;
}

void remove_unused_vertices(Triangle_mesh_3& mesh) {
  std::vector<int> number(mesh.vertices.size(), -1);
  for (const std::array<int, 3>& t : mesh.triangles)
    for (const int v : t) number[v] = 0;
  int count = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (number[v] < 0) continue;
    mesh.vertices[count] = mesh.vertices[v];
    number[v] = count++;
  }
  mesh.vertices.resize(count);
  for (std::array<int, 3>& t : mesh.triangles)
    for (int& v : t) v = number[v];
}

bool has_area(const Point_3& p, const Point_3& q, const Point_3& r) {
  const Point_3 u = q - p;
  const Point_3 v = r - p;
  const Point_3 normal = cross(u, v);
  // Far more than rounding errors; they are relative to the coordinates in u and v.
  constexpr double slack = 1e-14;
  const double largest_u = std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)});
  const double largest_v = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const double largest_normal = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  constexpr double smallest_safe = 1e-200;
  if (largest_normal > slack * largest_u * largest_v && largest_normal > smallest_safe) return true;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return !CGAL::collinear(Kernel::Point_3(p.x, p.y, p.z), Kernel::Point_3(q.x, q.y, q.z),
                          Kernel::Point_3(r.x, r.y, r.z));
}

Clean_mesh_3 clean_mesh(const Triangle_mesh_3& mesh) {
  Clean_mesh_3 result;
  weld(mesh, result);
  result.edges = find_edges(result.mesh);
  if (has_duplicates(result.mesh, result.edges)) remove_duplicates(result);
  return result;
}

}  // namespace mesecina
