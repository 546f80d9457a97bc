// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/disjoint_sets.h"
#include "core/outcome.h"
#include "geometries/circumcenter_3.h"
#include "geometries/parallel.h"
#include "geometries/samples_3/samples_3.h"
#include "geometries/scatter.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using Cell_base =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base>>;

enum class Side : std::uint8_t { unknown, inner, outer };

/// The vertices of the Voronoi diagram, and which of them each sample has.
struct Voronoi_vertices {
  std::vector<std::array<int, 4>> samples;
  std::vector<std::array<int, 4>> neighbors;  ///< -1 for infinite ones
  std::vector<Point_3> centers;
  std::vector<double> radii;
};

Voronoi_vertices voronoi_vertices(const std::vector<Point_3>& samples) {
  std::vector<std::pair<Kernel::Point_3, int>> points;
  points.reserve(samples.size());
  for (const Point_3& p : samples) points.emplace_back(Kernel::Point_3(p.x, p.y, p.z), static_cast<int>(points.size()));
  Triangulation triangulation(points.begin(), points.end());
  if (triangulation.dimension() < 3) throw Unavailable("the samples of the surface lie in a plane: there is no solid");
  points = {};
  Voronoi_vertices result;
  int next = 0;
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
    cell->info() = triangulation.is_infinite(cell) ? -1 : next++;
  result.samples.reserve(next);
  result.neighbors.reserve(next);
  result.centers.reserve(next);
  result.radii.reserve(next);
  for (auto cell = triangulation.finite_cells_begin(); cell != triangulation.finite_cells_end(); ++cell) {
    std::array<int, 4> corners{};
    std::array<int, 4> across{};
    for (int i = 0; i < 4; ++i) {
      corners[i] = cell->vertex(i)->info();
      across[i] = cell->neighbor(i)->info();
    }
    const Point_3 center =
        circumcenter({samples[corners[0]], samples[corners[1]], samples[corners[2]], samples[corners[3]]});
    result.samples.push_back(corners);
    result.neighbors.push_back(across);
    result.centers.push_back(center);
    result.radii.push_back(distance(center, samples[corners[0]]));
  }
  return result;
}

/// Voronoi vertices that are on the same side of the surface for certain: no surface comes nearer to a vertex than its
/// radius less the covering radius.
std::vector<int> sides_in_common(const Voronoi_vertices& voronoi, double covering_radius) {
  Disjoint_sets sides(voronoi.samples.size());
  for (std::size_t c = 0; c < sides.size(); ++c) {
    const double free = voronoi.radii[c] - covering_radius;
    if (!(free > 0)) continue;
    for (const int next : voronoi.neighbors[c]) {
      if (next <= static_cast<int>(c) || !(voronoi.radii[next] > covering_radius)) continue;
      const double reach = free + voronoi.radii[next] - covering_radius;
      // Of vertices that are far away coordinates have few digits.
      constexpr double certain = 1 - 1e-9;
      if (distance(voronoi.centers[c], voronoi.centers[next]) < certain * reach) sides.join(static_cast<int>(c), next);
    }
  }
  std::vector<int> side_of_vertex(sides.size());
  for (std::size_t c = 0; c < side_of_vertex.size(); ++c) side_of_vertex[c] = sides.find(static_cast<int>(c));
  return side_of_vertex;
}

}  // namespace

std::vector<Ball_3> inner_poles(const Surface_samples_3& samples, const Solid_3& solid, double perturbation,
                                Progress& progress) {
  progress.begin_stage("inner poles");
  const Voronoi_vertices voronoi = voronoi_vertices(samples.points);
  progress.check();
  const std::size_t count = voronoi.samples.size();
  const std::vector<int> side_class = sides_in_common(voronoi, samples.covering_radius);
  std::vector<Side> sides(count, Side::unknown);  // of classes, at their representatives

  // Per sample its Voronoi vertices, the farthest first.
  std::vector<int> offsets(samples.points.size() + 1, 0);
  for (const auto& corners : voronoi.samples)
    for (const int sample : corners) ++offsets[sample + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> stars(offsets.back());
  {
    std::vector<int> next(offsets.begin(), offsets.end() - 1);
    for (std::size_t c = 0; c < count; ++c)
      for (const int sample : voronoi.samples[c]) stars[next[sample]++] = static_cast<int>(c);
  }
  parallel_for(samples.points.size(), progress, [&](std::size_t s) {
    std::sort(stars.begin() + offsets[s], stars.begin() + offsets[s + 1], [&](int i, int j) {
      return voronoi.radii[i] != voronoi.radii[j] ? voronoi.radii[i] > voronoi.radii[j] : i < j;
    });
  });

  // Only the sides of those vertices are looked up that some sample has as the farthest of an unknown side.
  std::vector<int> at(offsets.begin(), offsets.end() - 1);
  std::vector<int> open(samples.points.size());
  std::iota(open.begin(), open.end(), 0);
  std::vector<std::uint8_t> is_pole(count, 0);
  while (!open.empty()) {
    std::vector<int> asked;
    std::vector<int> still_open;
    for (const int s : open) {
      while (at[s] < offsets[s + 1] && sides[side_class[stars[at[s]]]] == Side::outer) ++at[s];
      if (at[s] == offsets[s + 1]) continue;
      const int vertex = stars[at[s]];
      if (sides[side_class[vertex]] == Side::inner) {
        is_pole[vertex] = 1;
      } else {
        asked.push_back(side_class[vertex]);
        still_open.push_back(s);
      }
    }
    std::ranges::sort(asked);
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    std::vector<Point_3> centers;
    centers.reserve(asked.size());
    for (const int vertex : asked) centers.push_back(voronoi.centers[vertex]);
    const auto inside = are_inside(solid, centers, progress);
    for (std::size_t i = 0; i < asked.size(); ++i) sides[asked[i]] = inside[i] != 0 ? Side::inner : Side::outer;
    open = std::move(still_open);
  }

  std::vector<Ball_3> balls;
  for (std::size_t c = 0; c < count; ++c) {
    if (is_pole[c] == 0) continue;
    const double r = voronoi.radii[c];
    const std::uint64_t number = 3 * balls.size();
    const Point_3 shift{scattered(number), scattered(number + 1), scattered(number + 2)};
    balls.push_back({voronoi.centers[c] + (perturbation * r) * shift, r});
  }
  if (balls.empty())
    throw Unavailable("no Voronoi vertex of the " + std::to_string(samples.points.size()) +
                      " samples lies inside: the solid is thinner than delta; choose a smaller delta");
  return balls;
}

}  // namespace mesecina
