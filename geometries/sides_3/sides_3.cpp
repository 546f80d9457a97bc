// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/sides_3/sides_3.h"

#include <algorithm>
#include <span>
#include <utility>

#include "geometries/delaunay_parts_3/delaunay_parts_3.h"
#include "geometries/parallel.h"
#include "geometries/power_crust_3/pole_neighbors_3.h"

namespace mesecina {

namespace {

/// What a Voronoi vertex is counts for all cells that have it.
void copy_to_cells(Voronoi_sides_3& sides) {
  for (std::size_t c = 0; c < sides.vertex_of_cell.size(); ++c)
    sides.is_inner[c] = sides.is_inner[sides.vertex_of_cell[c]];
}

/// Finds in which power cell a point lies by going to nearer poles as long as there are any.
class Nearest_pole {
 public:
  explicit Nearest_pole(const Polar_balls_3& polar)
      : balls_(polar.regular->balls),
        neighbors_(neighbors_of_balls(*polar.regular)),
        some_visible_(
            static_cast<int>(std::ranges::find_if(polar.regular->cell_of_ball, [](int cell) { return cell >= 0; }) -
                             polar.regular->cell_of_ball.begin())) {}

  int find(const Point_3& point, int start) const {
    // Hidden poles have no neighbours.
    int nearest = neighbors_.of(start).empty() ? some_visible_ : start;
    double least = power(point, nearest);
    const auto is_nearer = [&](int other) { return power(point, other) < least; };
    while (true) {
      const auto neighbors = neighbors_.of(nearest);
      const auto next = std::ranges::find_if(neighbors, is_nearer);
      if (next == neighbors.end()) return nearest;
      nearest = *next;
      least = power(point, nearest);
    }
  }

 private:
  double power(const Point_3& point, int ball) const {
    const double length = distance(point, balls_[ball].center);
    const double radius = balls_[ball].radius;
    return (length - radius) * (length + radius);
  }

  const std::vector<Ball_3>& balls_;
  Ball_neighbors_3 neighbors_;
  int some_visible_;
};

}  // namespace

Voronoi_sides_3 sides_of_solid(const Delaunay_3& triangulation, const Solid_3& solid, Progress& progress) {
  Voronoi_sides_3 sides{cells_by_sphere(triangulation, progress), {}};
  sides.is_inner = are_inside(solid, triangulation.circumcenters, progress);
  copy_to_cells(sides);
  return sides;
}

Voronoi_sides_3 sides_of_power_crust(const Delaunay_3& triangulation, const Polar_balls_3& polar, Progress& progress) {
  Voronoi_sides_3 sides{cells_by_sphere(triangulation, progress), {}};
  const Nearest_pole poles(polar);
  sides.is_inner.resize(triangulation.cells.size());
  parallel_for(triangulation.cells.size(), progress, [&](std::size_t c) {
    const int start = polar.poles->first[triangulation.cells[c][0]];
    sides.is_inner[c] = polar.is_inner[poles.find(triangulation.circumcenters[c], start)];
  });
  copy_to_cells(sides);
  return sides;
}

std::vector<std::array<int, 3>> boundary_of_inner_cells(const Delaunay_3& triangulation, const Voronoi_sides_3& sides) {
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t c = 0; c < triangulation.cells.size(); ++c) {
    if (sides.is_inner[c] == 0) continue;
    for (int i = 0; i < 4; ++i) {
      const int next = triangulation.neighbors[c][i];
      if (next < 0 || sides.is_inner[next] == 0)
        triangles.push_back(corners_across(triangulation, static_cast<int>(c), i));
    }
  }
  return triangles;
}

Voronoi_faces_3 inner_voronoi_faces(const Delaunay_3& triangulation, const Voronoi_sides_3& sides, Progress& progress) {
  const Voronoi_faces_3 all = bounded_voronoi_faces(triangulation, progress);
  Voronoi_faces_3 inner;
  inner.offsets.push_back(0);
  for (std::size_t f = 0; f < all.size(); ++f) {
    const auto vertices = all.face(f);
    if (!std::ranges::all_of(vertices, [&](int vertex) { return sides.is_inner[vertex] != 0; })) continue;
    inner.sites.push_back(all.sites[f]);
    inner.vertices.insert(inner.vertices.end(), vertices.begin(), vertices.end());
    inner.offsets.push_back(static_cast<int>(inner.vertices.size()));
  }
  return inner;
}

}  // namespace mesecina
