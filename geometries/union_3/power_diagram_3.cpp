// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/power_diagram_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstdint>

#include "core/disjoint_sets.h"
#include "geometries/edge_ring_3.h"
#include "geometries/parallel.h"
#include "geometries/union_3/power_center_3.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Whether the ball of the neighbour across from a place is orthogonal to the power sphere of the cell.
bool have_one_power_sphere(const Regular_3& regular, int cell, int next) {
  const auto weighted = [&](int ball) {
    const auto& [center, radius] = regular.balls[ball];
    return Kernel::Weighted_point_3({center.x, center.y, center.z}, radius * radius);
  };
  const auto& corners = regular.cells[cell];
  const auto& others = regular.cells[next];
  const int* opposite = std::ranges::find_if(others, [&](int ball) { return std::ranges::count(corners, ball) == 0; });
  if (opposite == others.end()) return false;
  return Kernel().power_side_of_oriented_power_sphere_3_object()(weighted(corners[0]), weighted(corners[1]),
                                                                 weighted(corners[2]), weighted(corners[3]),
                                                                 weighted(*opposite)) == CGAL::ON_ORIENTED_BOUNDARY;
}

/// Per cell the least one with the same power sphere.
std::vector<int> cells_by_power_sphere(const Regular_3& regular, Progress& progress) {
  const std::size_t count = regular.cells.size();
  std::vector<std::uint8_t> joined(count, 0);  // a bit per place
  parallel_for(count, progress, [&](std::size_t c) {
    const int cell = static_cast<int>(c);
    if (regular.is_infinite(cell)) return;
    for (int i = 0; i < 4; ++i) {
      const int next = regular.neighbors[c][i];
      if (next > cell && !regular.is_infinite(next) && have_one_power_sphere(regular, cell, next))
        joined[c] = static_cast<std::uint8_t>(joined[c] | 1U << static_cast<unsigned>(i));
    }
  });
  Disjoint_sets spheres(count);
  for (std::size_t c = 0; c < count; ++c)
    for (int i = 0; i < 4; ++i)
      if ((joined[c] >> static_cast<unsigned>(i) & 1U) != 0) spheres.join(static_cast<int>(c), regular.neighbors[c][i]);
  std::vector<int> result(count);
  for (std::size_t c = 0; c < count; ++c) result[c] = spheres.find(static_cast<int>(c));
  return result;
}

void find_vertices(const Regular_3& regular, Power_faces_3& faces, Progress& progress) {
  Box box;
  for (const Ball_3& ball : regular.balls) box.add(ball.center);
  constexpr double allowed_error = 1e-9;
  const double error = allowed_error * box.diagonal();
  std::vector<std::uint8_t> is_used(regular.cells.size(), 0);
  for (const int cell : faces.corners) is_used[cell] = 1;
  faces.vertices.resize(regular.cells.size());
  parallel_for(regular.cells.size(), progress, [&](std::size_t c) {
    if (is_used[c] != 0) faces.vertices[c] = power_center(regular, static_cast<int>(c), error);
  });
}

}  // namespace

Power_faces_3 bounded_power_faces(const Regular_3& regular, Progress& progress) {
  progress.begin_stage("power diagram");
  const std::vector<int> vertex_of_cell = cells_by_power_sphere(regular, progress);
  Power_faces_3 faces;
  faces.offsets.push_back(0);
  const auto add_face = [&](int cell, int i, int j) {
    const std::size_t begin = faces.corners.size();
    const bool is_whole = walk_around_edge(regular.cells, regular.neighbors, cell, i, j, [&](int current) {
      if (current < cell || regular.is_infinite(current)) return false;
      const int vertex = vertex_of_cell[current];
      if (faces.corners.size() == begin || faces.corners.back() != vertex) faces.corners.push_back(vertex);
      return true;
    });
    while (faces.corners.size() > begin + 1 && faces.corners.back() == faces.corners[begin]) faces.corners.pop_back();
    constexpr std::size_t least = 3;
    if (!is_whole || faces.corners.size() < begin + least) {
      faces.corners.resize(begin);
      return;
    }
    faces.balls.push_back({regular.cells[cell][i], regular.cells[cell][j]});
    faces.offsets.push_back(static_cast<int>(faces.corners.size()));
  };
  for (int c = 0; c < static_cast<int>(regular.cells.size()); ++c) {
    constexpr int often = 4096;
    if (c % often == 0) progress.check();
    if (regular.is_infinite(c)) continue;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) add_face(c, i, j);
  }
  find_vertices(regular, faces, progress);
  return faces;
}

std::vector<std::array<int, 2>> edges_of(const Regular_3& regular) {
  std::vector<std::array<int, 2>> edges;
  for (const auto& corners : regular.cells) {
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        const int a = std::min(corners[i], corners[j]);
        const int b = std::max(corners[i], corners[j]);
        if (a >= 0) edges.push_back({a, b});
      }
    }
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace mesecina
