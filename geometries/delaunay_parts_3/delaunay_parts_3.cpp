// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_parts_3/delaunay_parts_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr std::array<std::array<int, 2>, 6> edge_places{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

class Gabriel_finder {
 public:
  Gabriel_finder(const Delaunay_3& triangulation, Progress& progress)
      : triangulation_(triangulation), progress_(progress) {}

  Gabriel_complex_3 find() {
    find_triangles();
    find_edges();
    return std::move(result_);
  }

 private:
  Kernel::Point_3 point(int site) const {
    const Point_3& p = triangulation_.points[site];
    return {p.x, p.y, p.z};
  }

  /// The nearest sites on both sides of a triangle tell.
  bool is_gabriel_triangle(int cell, int place) const {
    const auto triangle = corners_across(triangulation_, cell, place);
    const auto is_taken_by = [&](int site) {
      return CGAL::side_of_bounded_sphere(point(triangle[0]), point(triangle[1]), point(triangle[2]), point(site)) ==
             CGAL::ON_BOUNDED_SIDE;
    };
    const auto& corners = triangulation_.cells[cell];
    if (is_taken_by(corners[place])) return false;
    const int next = triangulation_.neighbors[cell][place];
    if (next < 0) return true;
    const auto& others = triangulation_.cells[next];
    return !is_taken_by(*std::ranges::find_if(others, [&](int s) { return std::ranges::count(corners, s) == 0; }));
  }

  void find_triangles() {
    const std::size_t count = triangulation_.cells.size();
    std::vector<std::uint8_t> found(count, 0);  // a bit per place
    parallel_for(count, progress_, [&](std::size_t c) {
      const int cell = static_cast<int>(c);
      for (int i = 0; i < 4; ++i)
        if (triangulation_.neighbors[c][i] < cell && is_gabriel_triangle(cell, i))
          found[c] = static_cast<std::uint8_t>(found[c] | 1U << static_cast<unsigned>(i));
    });
    for (std::size_t c = 0; c < count; ++c)
      for (int i = 0; i < 4; ++i)
        if ((found[c] >> static_cast<unsigned>(i) & 1U) != 0)
          result_.triangles.push_back(corners_across(triangulation_, static_cast<int>(c), i));
  }

  /// The sites that have a triangle with an edge tell.
  void find_edges() {
    const std::size_t count = triangulation_.cells.size();
    // Lesser site, other site, whether a site of the cell is inside.
    std::vector<std::array<int, 3>> edges(edge_places.size() * count);
    parallel_for(count, progress_, [&](std::size_t c) {
      const auto& corners = triangulation_.cells[c];
      for (std::size_t e = 0; e < edge_places.size(); ++e) {
        const int a = corners[edge_places[e][0]];
        const int b = corners[edge_places[e][1]];
        const bool is_taken = std::ranges::any_of(corners, [&](int site) {
          return site != a && site != b &&
                 CGAL::side_of_bounded_sphere(point(a), point(b), point(site)) == CGAL::ON_BOUNDED_SIDE;
        });
        edges[edge_places.size() * c + e] = {std::min(a, b), std::max(a, b), is_taken ? 1 : 0};
      }
    });
    std::ranges::sort(edges);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      const bool is_last = e + 1 == edges.size() || edges[e + 1][0] != edges[e][0] || edges[e + 1][1] != edges[e][1];
      if (is_last && edges[e][2] == 0) result_.edges.push_back({edges[e][0], edges[e][1]});
    }
  }

  const Delaunay_3& triangulation_;
  Progress& progress_;
  Gabriel_complex_3 result_;
};

}  // namespace

double circle_radius(const Point_3& a, const Point_3& b, const Point_3& c) {
  const Point_3 normal = cross(b - a, c - a);
  const double doubled_area = std::sqrt(dot(normal, normal));
  if (doubled_area == 0) return std::numeric_limits<double>::infinity();
  return distance(a, b) * distance(b, c) * distance(c, a) / (2 * doubled_area);
}

std::array<int, 3> corners_across(const Delaunay_3& triangulation, int cell, int place) {
  constexpr std::array<std::array<int, 3>, 4> places{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  const auto& corners = triangulation.cells[cell];
  return {corners[places[place][0]], corners[places[place][1]], corners[places[place][2]]};
}

std::vector<std::array<int, 3>> hull_triangles(const Delaunay_3& triangulation) {
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t c = 0; c < triangulation.cells.size(); ++c)
    for (int i = 0; i < 4; ++i)
      if (triangulation.neighbors[c][i] < 0) triangles.push_back(corners_across(triangulation, static_cast<int>(c), i));
  return triangles;
}

Gabriel_complex_3 gabriel_complex(const Delaunay_3& triangulation, Progress& progress) {
  progress.begin_stage("Gabriel complex");
  return Gabriel_finder(triangulation, progress).find();
}

}  // namespace mesecina
