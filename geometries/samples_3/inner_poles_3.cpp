// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "core/disjoint_sets.h"
#include "geometries/parallel.h"
#include "geometries/samples_3/samples_3.h"
#include "geometries/scatter.h"

namespace mesecina {

namespace {

enum class Side : std::uint8_t { unknown, inner, outer };

/// Voronoi vertices that are on the same side of the surface for certain: no surface comes nearer to a vertex than its
/// radius less the covering radius.
std::vector<int> sides_in_common(const Delaunay_3& delaunay, double covering_radius) {
  Disjoint_sets sides(delaunay.cells.size());
  for (std::size_t c = 0; c < sides.size(); ++c) {
    const double free = delaunay.circumradii[c] - covering_radius;
    if (!(free > 0)) continue;
    for (const int next : delaunay.neighbors[c]) {
      if (next <= static_cast<int>(c) || !(delaunay.circumradii[next] > covering_radius)) continue;
      const double reach = free + delaunay.circumradii[next] - covering_radius;
      // Of vertices that are far away coordinates have few digits.
      constexpr double certain = 1 - 1e-9;
      if (distance(delaunay.circumcenters[c], delaunay.circumcenters[next]) < certain * reach)
        sides.join(static_cast<int>(c), next);
    }
  }
  std::vector<int> side_of_vertex(sides.size());
  for (std::size_t c = 0; c < side_of_vertex.size(); ++c) side_of_vertex[c] = sides.find(static_cast<int>(c));
  return side_of_vertex;
}

}  // namespace

std::vector<int> inner_pole_cells(const Surface_samples_3& samples, const Delaunay_3& delaunay, const Solid_3& solid,
                                  Progress& progress) {
  progress.begin_stage("inner poles");
  const std::size_t count = delaunay.cells.size();
  const std::vector<int> side_class = sides_in_common(delaunay, samples.covering_radius);
  std::vector<Side> sides(count, Side::unknown);  // of classes, at their representatives

  // Per sample its Voronoi vertices, the farthest first.
  std::vector<int> offsets(samples.points.size() + 1, 0);
  for (const auto& corners : delaunay.cells)
    for (const int sample : corners) ++offsets[sample + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> stars(offsets.back());
  {
    std::vector<int> next(offsets.begin(), offsets.end() - 1);
    for (std::size_t c = 0; c < count; ++c)
      for (const int sample : delaunay.cells[c]) stars[next[sample]++] = static_cast<int>(c);
  }
  parallel_for(samples.points.size(), progress, [&](std::size_t s) {
    std::sort(stars.begin() + offsets[s], stars.begin() + offsets[s + 1], [&](int i, int j) {
      return delaunay.circumradii[i] != delaunay.circumradii[j] ? delaunay.circumradii[i] > delaunay.circumradii[j]
                                                                : i < j;
    });
  });

  // Only the sides of those vertices are looked up that some sample has as the farthest of an unknown side.
  std::vector<int> at(offsets.begin(), offsets.end() - 1);
  std::vector<int> open(samples.points.size());
  std::iota(open.begin(), open.end(), 0);
  std::vector<int> poles(samples.points.size(), -1);
  while (!open.empty()) {
    std::vector<int> asked;
    std::vector<int> still_open;
    for (const int s : open) {
      while (at[s] < offsets[s + 1] && sides[side_class[stars[at[s]]]] == Side::outer) ++at[s];
      if (at[s] == offsets[s + 1]) continue;
      const int vertex = stars[at[s]];
      if (sides[side_class[vertex]] == Side::inner) {
        poles[s] = vertex;
      } else {
        asked.push_back(side_class[vertex]);
        still_open.push_back(s);
      }
    }
    std::ranges::sort(asked);
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    std::vector<Point_3> centers;
    centers.reserve(asked.size());
    for (const int vertex : asked) centers.push_back(delaunay.circumcenters[vertex]);
    const auto inside = are_inside(solid, centers, progress);
    for (std::size_t i = 0; i < asked.size(); ++i) sides[asked[i]] = inside[i] != 0 ? Side::inner : Side::outer;
    open = std::move(still_open);
  }

  return poles;
}

std::vector<Ball_3> balls_of_cells(const Delaunay_3& delaunay, std::vector<int> cells, double perturbation) {
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<Ball_3> balls;
  balls.reserve(cells.size());
  for (const int c : cells) {
    if (c < 0) continue;
    const double r = delaunay.circumradii[c];
    const std::uint64_t number = 3 * balls.size();
    const Point_3 shift{scattered(number), scattered(number + 1), scattered(number + 2)};
    balls.push_back({delaunay.circumcenters[c] + (perturbation * r) * shift, r});
  }
  return balls;
}

}  // namespace mesecina
