// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/regular_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/outcome.h"
#include "geometries/cell_arrays_3.h"
#include "geometries/spatial_order_3.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base =
    CGAL::Triangulation_vertex_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Cell_base =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Triangulation =
    CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;
using Weighted_point = Kernel::Weighted_point_3;

constexpr int infinite = -1;

/// Of each center the first of the largest balls.
std::vector<int> first_of_each_center(const std::vector<Ball_3>& balls) {
  std::vector<int> order(balls.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) {
    const Ball_3& b = balls[i];
    return std::tuple(b.center.x, b.center.y, b.center.z, -b.radius, i);
  };
  std::ranges::sort(order, {}, key);
  std::vector<int> kept;
  for (const int i : order)
    if (kept.empty() || !(balls[kept.back()].center == balls[i].center)) kept.push_back(i);
  std::ranges::sort(kept);
  return kept;
}

/// Far away and with weights so negative that they take no part between the balls, but give the triangulation cells.
void add_surroundings(Triangulation& triangulation, const std::vector<Ball_3>& balls) {
  Box box;
  double radius = 0;
  for (const Ball_3& ball : balls) {
    box.add(ball.center);
    radius = std::max(radius, ball.radius);
  }
  constexpr double far = 64;
  double size = far * std::max(box.diagonal(), radius);
  if (size == 0) size = 1;
  const Point_3 c = midpoint(box.lower, box.upper);
  const double weight = -far * size * size;
  for (const Point_3& d : {Point_3{1, 1, 1}, Point_3{1, -1, -1}, Point_3{-1, 1, -1}, Point_3{-1, -1, 1}}) {
    const Point_3 p = c + size * d;
    const auto vertex = triangulation.insert(Weighted_point({p.x, p.y, p.z}, weight));
    vertex->info() = infinite;
  }
}

}  // namespace

Regular_3 regular_triangulation(std::vector<Ball_3> balls, Progress& progress) {
  if (balls.empty()) throw Unavailable("there are no balls");
  progress.begin_stage("regular triangulation");
  const std::vector<int> kept = first_of_each_center(balls);
  std::vector<Point_3> centers;
  centers.reserve(kept.size());
  for (const int i : kept) centers.push_back(balls[i].center);
  Triangulation triangulation;
  triangulation.infinite_vertex()->info() = infinite;
  Triangulation::Cell_handle last;
  std::size_t inserted = 0;
  for (const std::size_t i : insertion_order(centers)) {
    constexpr std::size_t often = 1024;
    if (++inserted % often == 0) progress.report(static_cast<double>(inserted) / static_cast<double>(kept.size()));
    const auto& [c, r] = balls[kept[i]];
    const Weighted_point point({c.x, c.y, c.z}, r * r);
    Triangulation::Locate_type type{};
    int at = 0;
    int other = 0;
    const auto cell = triangulation.locate(point, type, at, other, last);
    const auto vertex = triangulation.insert(point, type, cell, at, other);
    last = vertex != Triangulation::Vertex_handle() ? vertex->cell() : cell;
    if (vertex != Triangulation::Vertex_handle()) vertex->info() = kept[i];
  }
  progress.check();
  if (triangulation.dimension() < 3) add_surroundings(triangulation, balls);

  Regular_3 result;
  result.balls = std::move(balls);
  result.cell_of_ball.assign(result.balls.size(), -1);
  std::vector<std::size_t> order(centers.size());
  std::iota(order.begin(), order.end(), 0);
  sort_along_hilbert_curve(centers, order);
  std::vector<int> places(result.balls.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) places[kept[order[i]]] = static_cast<int>(i);
  write_cells(triangulation, places, result.cells, result.neighbors, progress);
  for (std::size_t c = 0; c < result.cells.size(); ++c)
    for (const int ball : result.cells[c])
      if (ball >= 0) result.cell_of_ball[ball] = static_cast<int>(c);
  return result;
}

int locate(const Regular_3& regular, const Point_3& point, int start) {
  const Kernel::Point_3 p(point.x, point.y, point.z);
  const auto position = [&](int ball) {
    const Point_3& c = regular.balls[ball].center;
    return Kernel::Point_3(c.x, c.y, c.z);
  };
  int cell = start;
  if (regular.is_infinite(cell)) {
    // Across from its infinite place lies a finite cell, unless all balls lie in a plane.
    const auto& corners = regular.cells[cell];
    for (int i = 0; i < 4; ++i)
      if (corners[i] < 0) cell = regular.neighbors[start][i];
    if (regular.is_infinite(cell)) return -1;
  }
  int previous = -1;
  // A visibility walk in a regular triangulation comes to an end.
  for (;;) {
    const auto& corners = regular.cells[cell];
    std::array<Kernel::Point_3, 4> points{position(corners[0]), position(corners[1]), position(corners[2]),
                                          position(corners[3])};
    int next = -1;
    for (int i = 0; i < 4 && next < 0; ++i) {
      if (regular.neighbors[cell][i] == previous) continue;
      const Kernel::Point_3 corner = std::exchange(points[i], p);
      if (CGAL::orientation(points[0], points[1], points[2], points[3]) == CGAL::NEGATIVE)
        next = regular.neighbors[cell][i];
      points[i] = corner;
    }
    if (next < 0) return cell;
    if (regular.is_infinite(next)) return -1;
    previous = std::exchange(cell, next);
  }
}

}  // namespace mesecina
