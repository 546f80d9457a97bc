// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/evolutions_3/mesh_vertices_3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "geometries/parallel.h"
#include "geometries/solid_3/clean_mesh_3.h"

namespace mesecina {

namespace {

bool is_finite(const Point_3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

bool is_finite(const Triangle_mesh_3& mesh, const std::array<int, 3>& triangle) {
  return std::ranges::all_of(triangle, [&](int v) { return is_finite(mesh.vertices[v]); });
}

struct Joined {
  int from = 0;
  int to = 0;
  bool is_end = false;  ///< the edge has one triangle
};

/// Both directions of each edge, ascending.
std::vector<Joined> joined_vertices(const Triangle_mesh_3& mesh, const std::vector<int>& first) {
  std::vector<std::array<int, 2>> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) {
    if (!is_finite(mesh, t)) continue;
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(first[t[i]], first[t[(i + 1) % 3]]);
      if (a != b) sides.push_back({a, b});
    }
  }
  std::ranges::sort(sides);
  std::vector<Joined> joined;
  joined.reserve(sides.size());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end] == sides[i]) ++end;
    const auto [a, b] = sides[i];
    joined.push_back({a, b, end == i + 1});
    joined.push_back({b, a, end == i + 1});
    i = end;
  }
  std::ranges::sort(joined, [](const Joined& p, const Joined& q) {
    return std::pair{p.from, p.to} < std::pair{q.from, q.to};
  });
  return joined;
}

}  // namespace

Mesh_neighbors_3 mesh_neighbors(const Triangle_mesh_3& mesh, Progress& progress) {
  Mesh_neighbors_3 result;
  result.first_at_place = first_at_place(mesh.vertices);
  progress.check();
  const std::vector<Joined> joined = joined_vertices(mesh, result.first_at_place);
  progress.check();
  std::vector<std::uint8_t> is_at_end(mesh.vertices.size(), 0);
  for (const Joined& edge : joined)
    if (edge.is_end) is_at_end[edge.from] = 1;
  result.offsets.push_back(0);
  auto edge = joined.begin();
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    for (; edge != joined.end() && edge->from == v; ++edge)
      if (edge->is_end || is_at_end[v] == 0) result.vertices.push_back(edge->to);
    result.offsets.push_back(static_cast<int>(result.vertices.size()));
  }
  return result;
}

std::vector<Point_3> smoothed(const Triangle_mesh_3& mesh, const Mesh_neighbors_3& neighbors,
                              std::span<const double> factors, Progress& progress) {
  std::vector<Point_3> vertices = mesh.vertices;
  for (const double factor : factors) {
    const std::vector<Point_3> before = vertices;
    parallel_for(vertices.size(), progress, [&](std::size_t v) {
      const auto around = neighbors.of(v);
      if (around.empty()) return;
      Point_3 sum;
      for (const int other : around) sum = sum + (before[other] - before[v]);
      vertices[v] = before[v] + (factor / static_cast<double>(around.size())) * sum;
    });
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = vertices[neighbors.first_at_place[v]];
  return vertices;
}

std::vector<Point_3> with_noise(const Triangle_mesh_3& mesh, const Mesh_neighbors_3& neighbors, double amplitude,
                                Portable_random& random) {
  std::vector<Point_3> normals(mesh.vertices.size());
  for (const std::array<int, 3>& t : mesh.triangles) {
    if (!is_finite(mesh, t)) continue;
    const Point_3& corner = mesh.vertices[t[0]];
    const Point_3 normal = cross(mesh.vertices[t[1]] - corner, mesh.vertices[t[2]] - corner);
    for (const int v : t) {
      Point_3& sum = normals[neighbors.first_at_place[v]];
      sum = sum + normal;
    }
  }
  std::vector<Point_3> vertices = mesh.vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const auto around = neighbors.of(v);
    if (around.empty()) continue;
    double length = 0;
    for (const int other : around) length += distance(mesh.vertices[v], mesh.vertices[other]);
    const double part = amplitude * random.within(-1, 1) * length / static_cast<double>(around.size());
    const double norm = std::sqrt(dot(normals[v], normals[v]));
    if (norm > 0) vertices[v] = mesh.vertices[v] + (part / norm) * normals[v];
  }
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = vertices[neighbors.first_at_place[v]];
  return vertices;
}

}  // namespace mesecina
