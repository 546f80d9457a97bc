// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstdint>

#include "core/disjoint_sets.h"
#include "geometries/delaunay_3/delaunay_3.h"
#include "geometries/edge_ring_3.h"
#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Whether the corner of the neighbour across from a place lies on the sphere of the cell.
bool have_one_sphere(const Delaunay_3& triangulation, int cell, int place) {
  const auto point = [&](int i) {
    const Point_3& p = triangulation.points[i];
    return Kernel::Point_3(p.x, p.y, p.z);
  };
  const auto& corners = triangulation.cells[cell];
  const auto& others = triangulation.cells[triangulation.neighbors[cell][place]];
  const int* opposite =
      std::ranges::find_if(others, [&](int corner) { return std::ranges::count(corners, corner) == 0; });
  return CGAL::side_of_oriented_sphere(point(corners[0]), point(corners[1]), point(corners[2]), point(corners[3]),
                                       point(*opposite)) == CGAL::ON_ORIENTED_BOUNDARY;
}

}  // namespace

std::vector<int> cells_by_sphere(const Delaunay_3& triangulation, Progress& progress) {
  const std::size_t count = triangulation.cells.size();
  std::vector<std::uint8_t> joined(count, 0);  // a bit per place
  parallel_for(count, progress, [&](std::size_t c) {
    for (int i = 0; i < 4; ++i)
      if (triangulation.neighbors[c][i] > static_cast<int>(c) && have_one_sphere(triangulation, static_cast<int>(c), i))
        joined[c] = static_cast<std::uint8_t>(joined[c] | 1U << static_cast<unsigned>(i));
  });
  Disjoint_sets spheres(count);
  for (std::size_t c = 0; c < count; ++c)
    for (int i = 0; i < 4; ++i)
      if ((joined[c] >> static_cast<unsigned>(i) & 1U) != 0)
        spheres.join(static_cast<int>(c), triangulation.neighbors[c][i]);
  std::vector<int> result(count);
  for (std::size_t c = 0; c < count; ++c) result[c] = spheres.find(static_cast<int>(c));
  return result;
}

Voronoi_faces_3 bounded_voronoi_faces(const Delaunay_3& triangulation, Progress& progress) {
  const std::vector<int> vertex_of_cell = cells_by_sphere(triangulation, progress);
  Voronoi_faces_3 faces;
  faces.offsets.push_back(0);
  const auto add_face = [&](int cell, int i, int j) {
    const std::size_t begin = faces.vertices.size();
    const bool is_whole = walk_around_edge(triangulation.cells, triangulation.neighbors, cell, i, j, [&](int current) {
      if (current < cell) return false;
      const int vertex = vertex_of_cell[current];
      if (faces.vertices.size() == begin || faces.vertices.back() != vertex) faces.vertices.push_back(vertex);
      return true;
    });
    while (faces.vertices.size() > begin + 1 && faces.vertices.back() == faces.vertices[begin])
      faces.vertices.pop_back();
    constexpr std::size_t least = 3;
    if (!is_whole || faces.vertices.size() < begin + least) {
      faces.vertices.resize(begin);
      return;
    }
    faces.sites.push_back({triangulation.cells[cell][i], triangulation.cells[cell][j]});
    faces.offsets.push_back(static_cast<int>(faces.vertices.size()));
  };
  for (int c = 0; c < static_cast<int>(triangulation.cells.size()); ++c) {
    constexpr int often = 4096;
    if (c % often == 0) progress.check();
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) add_face(c, i, j);
  }
  return faces;
}

}  // namespace mesecina
