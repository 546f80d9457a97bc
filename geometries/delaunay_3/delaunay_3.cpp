// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_3/delaunay_3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "core/outcome.h"
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

/// Per point the first one that is equal to it.
std::vector<int> first_of_equal(const std::vector<Point_3>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int i) { return std::tuple(points[i].x, points[i].y, points[i].z, i); });
  std::vector<int> site(points.size());
  int first = -1;
  for (const int i : order) {
    if (first < 0 || !(points[first] == points[i])) first = i;
    site[i] = first;
  }
  return site;
}

/// Along a space-filling curve, each from where the last one lies. Vertices get the number of a point there.
void insert(const std::vector<Point_3>& points, Triangulation& triangulation, Progress& progress) {
  if (points.empty()) return;
  std::vector<Kernel::Point_3> places;
  places.reserve(points.size());
  for (const Point_3& p : points) places.emplace_back(p.x, p.y, p.z);
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  using Traits = CGAL::Spatial_sort_traits_adapter_3<Kernel, CGAL::Pointer_property_map<Kernel::Point_3>::const_type>;
  CGAL::spatial_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(std::as_const(places))));
  Triangulation::Vertex_handle last;
  std::size_t count = 0;
  for (const std::size_t i : order) {
    constexpr std::size_t often = 1024;
    if (++count % often == 0) progress.report(static_cast<double>(count) / static_cast<double>(order.size()));
    last = triangulation.insert(places[i], last);
    last->info() = static_cast<int>(i);
  }
}

std::string why_flat(const Triangulation& triangulation) {
  const std::size_t count = triangulation.number_of_vertices();
  constexpr std::size_t least = 4;
  if (count < least)
    return "needs at least 4 distinct points that are not in one plane; there " +
           (count == 1 ? std::string("is 1") : "are " + std::to_string(count));
  return triangulation.dimension() < 2 ? "all points lie on one line" : "all points lie in one plane";
}

}  // namespace

Delaunay_3 delaunay(std::vector<Point_3> points, Progress& progress) {
  progress.begin_stage("Delaunay triangulation");
  Delaunay_3 result;
  result.points = std::move(points);
  Triangulation triangulation;
  insert(result.points, triangulation, progress);
  progress.check();
  if (triangulation.dimension() < 3) throw Unavailable(why_flat(triangulation));
  result.site_count = triangulation.number_of_vertices();
  if (result.site_count == result.points.size()) {
    result.site.resize(result.points.size());
    std::iota(result.site.begin(), result.site.end(), 0);
  } else {
    result.site = first_of_equal(result.points);
  }

  int next = 0;
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
    cell->info() = triangulation.is_infinite(cell) ? -1 : next++;
  result.cells.reserve(next);
  result.neighbors.reserve(next);
  for (auto cell = triangulation.finite_cells_begin(); cell != triangulation.finite_cells_end(); ++cell) {
    std::array<int, 4> corners{};
    std::array<int, 4> across{};
    for (int i = 0; i < 4; ++i) {
      corners[i] = result.site[cell->vertex(i)->info()];
      across[i] = cell->neighbor(i)->info();
    }
    result.cells.push_back(corners);
    result.neighbors.push_back(across);
  }
  triangulation.clear();
  progress.check();
  result.circumcenters.resize(result.cells.size());
  result.circumradii.resize(result.cells.size());
  parallel_for(result.cells.size(), progress, [&](std::size_t c) {
    const auto& corners = result.cells[c];
    const auto point = [&](int i) { return result.points[corners[i]]; };
    result.circumcenters[c] = circumcenter({point(0), point(1), point(2), point(3)});
    result.circumradii[c] = distance(result.circumcenters[c], point(0));
  });
  return result;
}

}  // namespace mesecina
