// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/disjoint_sets.h"
#include "geometries/parallel.h"
#include "geometries/samples_3/samples_3.h"
#include "geometries/scatter.h"

namespace mesecina {

namespace {

/// The cells at some of the samples.
struct Stars {
  std::vector<int> samples;
  std::vector<int> offsets;
  std::vector<int> cells;

  std::span<const int> star(std::size_t i) const {
    return std::span(cells).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
};

/// Of all samples that these cells have.
Stars stars_around(const Delaunay_3& delaunay, std::span<const int> around) {
  Stars stars;
  std::vector<int> slot(delaunay.points.size(), -1);
  for (const int c : around)
    for (const int s : delaunay.cells[c]) slot[s] = 0;
  for (std::size_t s = 0; s < slot.size(); ++s) {
    if (slot[s] < 0) continue;
    slot[s] = static_cast<int>(stars.samples.size());
    stars.samples.push_back(static_cast<int>(s));
  }
  stars.offsets.assign(stars.samples.size() + 1, 0);
  for (const auto& corners : delaunay.cells)
    for (const int s : corners)
      if (slot[s] >= 0) ++stars.offsets[slot[s] + 1];
  std::partial_sum(stars.offsets.begin(), stars.offsets.end(), stars.offsets.begin());
  stars.cells.resize(stars.offsets.back());
  std::vector<int> next(stars.offsets.begin(), stars.offsets.end() - 1);
  for (std::size_t c = 0; c < delaunay.cells.size(); ++c)
    for (const int s : delaunay.cells[c])
      if (slot[s] >= 0) stars.cells[next[slot[s]]++] = static_cast<int>(c);
  return stars;
}

}  // namespace

/// No surface comes nearer to a Voronoi vertex than its radius less the covering radius, so those of which the balls
/// overlap by more are on one side.
void Inner_poles_3::classify(const Delaunay_3& delaunay, std::span<const int> renewed, double covering_radius,
                             Progress& progress) {
  std::vector<std::uint8_t> joined(renewed.size(), 0);  // a bit per place
  parallel_for(renewed.size(), progress, [&](std::size_t i) {
    const int c = renewed[i];
    const double free = delaunay.circumradii[c] - covering_radius;
    if (!(free > 0)) return;
    for (int k = 0; k < 4; ++k) {
      const int next = delaunay.neighbors[c][k];
      if (next < 0 || !(delaunay.circumradii[next] > covering_radius)) continue;
      const double reach = free + delaunay.circumradii[next] - covering_radius;
      // Of vertices that are far away coordinates have few digits.
      constexpr double certain = 1 - 1e-9;
      if (squared_distance(delaunay.circumcenters[c], delaunay.circumcenters[next]) < certain * reach * reach)
        joined[i] = static_cast<std::uint8_t>(joined[i] | 1U << static_cast<unsigned>(k));
    }
  });
  class_of_cell_.resize(delaunay.cells.size(), -1);
  for (const int c : renewed) class_of_cell_[c] = -1;
  std::vector<int> position(delaunay.cells.size(), -1);
  for (std::size_t i = 0; i < renewed.size(); ++i) position[renewed[i]] = static_cast<int>(i);
  Disjoint_sets sets(renewed.size());
  const auto for_joined = [&](std::size_t i, const auto& use) {
    for (int k = 0; k < 4; ++k)
      if ((joined[i] >> static_cast<unsigned>(k) & 1U) != 0) use(delaunay.neighbors[renewed[i]][k]);
  };
  for (std::size_t i = 0; i < renewed.size(); ++i)
    for_joined(i, [&](int next) {
      if (position[next] >= 0) sets.join(static_cast<int>(i), position[next]);
    });
  // A class of before continues in the new cells, one of those whose side is known before others.
  std::vector<int> class_of_set(renewed.size(), -1);
  for (std::size_t i = 0; i < renewed.size(); ++i)
    for_joined(i, [&](int next) {
      if (position[next] >= 0) return;
      int& known = class_of_set[sets.find(static_cast<int>(i))];
      if (known < 0 || sides_[known] == Side::unknown) known = class_of_cell_[next];
    });
  for (std::size_t i = 0; i < renewed.size(); ++i) {
    int& number = class_of_set[sets.find(static_cast<int>(i))];
    if (number < 0) {
      number = static_cast<int>(sides_.size());
      sides_.push_back(Side::unknown);
    }
    class_of_cell_[renewed[i]] = number;
  }
}

std::vector<int> Inner_poles_3::update(const Surface_samples_3& samples, const Delaunay_3& delaunay,
                                       std::span<const int> renewed, const Solid_3& solid, Progress& progress) {
  progress.begin_stage("inner poles");
  Stars stars;
  at_once(
      progress, [&] { classify(delaunay, renewed, samples.covering_radius, progress); },
      [&] { stars = stars_around(delaunay, renewed); });
  poles_.resize(samples.points.size(), -1);

  // Only the sides of those vertices are looked up that some sample has as the farthest of an unknown side.
  std::vector<int> open(stars.samples.size());
  std::iota(open.begin(), open.end(), 0);
  while (!open.empty()) {
    parallel_for(open.size(), progress, [&](std::size_t i) {
      int& farthest = poles_[stars.samples[open[i]]];
      farthest = -1;
      for (const int c : stars.star(open[i])) {
        if (sides_[class_of_cell_[c]] == Side::outer) continue;
        if (farthest < 0 || delaunay.circumradii[c] > delaunay.circumradii[farthest]) farthest = c;
      }
    });
    std::vector<int> asked;  // cells of different classes
    std::vector<int> still_open;
    for (const int i : open) {
      const int pole = poles_[stars.samples[i]];
      if (pole < 0 || sides_[class_of_cell_[pole]] == Side::inner) continue;
      asked.push_back(pole);
      still_open.push_back(i);
    }
    std::ranges::sort(asked, {}, [&](int c) { return std::pair(class_of_cell_[c], c); });
    asked.erase(
        std::unique(asked.begin(), asked.end(), [&](int c, int d) { return class_of_cell_[c] == class_of_cell_[d]; }),
        asked.end());
    std::vector<Point_3> centers;
    centers.reserve(asked.size());
    for (const int c : asked) centers.push_back(delaunay.circumcenters[c]);
    const auto inside = are_inside(solid, centers, progress);
    for (std::size_t i = 0; i < asked.size(); ++i)
      sides_[class_of_cell_[asked[i]]] = inside[i] != 0 ? Side::inner : Side::outer;
    open = std::move(still_open);
  }
  return std::move(stars.samples);
}

std::vector<int> inner_pole_cells(const Surface_samples_3& samples, const Delaunay_3& delaunay, const Solid_3& solid,
                                  Progress& progress) {
  std::vector<int> all(delaunay.cells.size());
  std::iota(all.begin(), all.end(), 0);
  Inner_poles_3 poles;
  poles.update(samples, delaunay, all, solid, progress);
  return poles.cells();
}

Point_3 moved(const Point_3& p, double reach, std::size_t number) {
  const std::uint64_t first = 3 * number;
  return p + reach * Point_3{scattered(first), scattered(first + 1), scattered(first + 2)};
}

std::vector<Ball_3> balls_of_cells(const Delaunay_3& delaunay, std::vector<int> cells, double perturbation) {
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<Ball_3> balls;
  balls.reserve(cells.size());
  for (const int c : cells) {
    if (c < 0) continue;
    const double r = delaunay.circumradii[c];
    balls.push_back({moved(delaunay.circumcenters[c], perturbation * r, balls.size()), r});
  }
  return balls;
}

}  // namespace mesecina
