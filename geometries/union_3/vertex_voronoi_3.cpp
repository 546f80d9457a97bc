// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/vertex_voronoi_3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "geometries/circumcenter_3.h"
#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using Cell_base =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;

/// Points at equal places become one with the balls of all of them.
void take_points(const Union_vertices_3& vertices, Vertex_voronoi_3& result) {
  std::vector<int> order(vertices.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int i) {
    const Point_3& p = vertices.points[i];
    return std::tuple(p.x, p.y, p.z, i);
  });
  std::vector<int> first(order.size());
  std::vector<std::vector<int>> others;
  std::vector<int> slot(order.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && vertices.points[order[i]] == vertices.points[order[i - 1]];
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
    if (!is_same) continue;
    const int representative = first[order[i]];
    if (slot[representative] < 0) {
      slot[representative] = static_cast<int>(others.size());
      others.emplace_back();
    }
    others[slot[representative]].push_back(order[i]);
  }
  result.ball_offsets.push_back(0);
  for (std::size_t v = 0; v < first.size(); ++v) {
    if (first[v] != static_cast<int>(v)) continue;
    result.points.push_back(vertices.points[v]);
    const auto own = vertices.balls_of(static_cast<int>(v));
    const std::size_t begin = result.balls.size();
    result.balls.insert(result.balls.end(), own.begin(), own.end());
    if (slot[v] >= 0) {
      for (const int other : others[slot[v]]) {
        const auto more = vertices.balls_of(other);
        result.balls.insert(result.balls.end(), more.begin(), more.end());
      }
      const auto start = result.balls.begin() + static_cast<std::ptrdiff_t>(begin);
      std::sort(start, result.balls.end());
      result.balls.erase(std::unique(start, result.balls.end()), result.balls.end());
    }
    result.ball_offsets.push_back(static_cast<int>(result.balls.size()));
  }
}

void triangulate(Vertex_voronoi_3& result) {
  std::vector<std::pair<Kernel::Point_3, int>> points;
  points.reserve(result.points.size());
  for (const Point_3& p : result.points)
    points.emplace_back(Kernel::Point_3(p.x, p.y, p.z), static_cast<int>(points.size()));
  Triangulation triangulation;
  triangulation.infinite_vertex()->info() = -1;
  triangulation.insert(points.begin(), points.end());
  if (triangulation.dimension() < 3) return;
  points = {};
  int next = 0;
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
    cell->info() = next++;
  result.cells.reserve(next);
  result.neighbors.reserve(next);
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell) {
    std::array<int, 4> corners{};
    std::array<int, 4> across{};
    for (int i = 0; i < 4; ++i) {
      corners[i] = cell->vertex(i)->info();
      across[i] = cell->neighbor(i)->info();
    }
    result.cells.push_back(corners);
    result.neighbors.push_back(across);
  }
}

void find_balls_of_cells(Vertex_voronoi_3& result, std::size_t ball_count, Progress& progress) {
  const std::size_t count = result.cells.size();
  result.ball_of_cell.assign(count, -1);
  std::vector<std::uint8_t> has_several(count, 0);
  parallel_for(count, progress, [&](std::size_t c) {
    if (std::ranges::min(result.cells[c]) < 0) return;
    int found = 0;
    result.for_common_balls(result.cells[c], [&](int ball) {
      if (found++ == 0) result.ball_of_cell[c] = ball;
    });
    has_several[c] = found > 1;
  });
  std::vector<std::uint8_t> has_cell(ball_count, 0);
  for (std::size_t c = 0; c < count; ++c)
    if (result.ball_of_cell[c] >= 0 && has_several[c] == 0) has_cell[result.ball_of_cell[c]] = 1;
  parallel_for(count, progress, [&](std::size_t c) {
    if (has_several[c] == 0) return;
    bool is_found = false;
    result.for_common_balls(result.cells[c], [&](int ball) {
      if (has_cell[ball] != 0 && !std::exchange(is_found, true)) result.ball_of_cell[c] = ball;
    });
  });
}

void label_cells(const Dual_3& dual, Vertex_voronoi_3& result, Progress& progress) {
  const Regular_3& regular = *dual.regular;
  const std::size_t count = result.cells.size();
  result.is_inner.assign(count, 0);
  result.centers.assign(count, {});
  parallel_for(count, progress, [&](std::size_t c) {
    const auto& corners = result.cells[c];
    if (std::ranges::min(corners) < 0) return;
    if (result.ball_of_cell[c] >= 0) {
      result.is_inner[c] = 1;
      return;
    }
    const Point_3 center = circumcenter(
        {result.points[corners[0]], result.points[corners[1]], result.points[corners[2]], result.points[corners[3]]});
    const int start = regular.cell_of_ball[result.balls_of(corners[0]).front()];
    const int cell = locate(regular, center, start);
    if (cell < 0 || dual.has_cell[cell] == 0) return;
    result.is_inner[c] = 1;
    result.centers[c] = center;
  });
}

}  // namespace

Vertex_voronoi_3 vertex_voronoi(const Union_vertices_3& vertices, Progress& progress) {
  progress.begin_stage("Voronoi diagram of the vertices of the union");
  Vertex_voronoi_3 result;
  take_points(vertices, result);
  triangulate(result);
  progress.check();
  find_balls_of_cells(result, vertices.dual->regular->balls.size(), progress);
  label_cells(*vertices.dual, result, progress);
  return result;
}

}  // namespace mesecina
