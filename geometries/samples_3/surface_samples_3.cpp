// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/outcome.h"
#include "geometries/samples_3/samples_3.h"

namespace mesecina {

namespace {

constexpr std::size_t most_samples = 20'000'000;

/// Points that keep a distance from each other, in a hashed grid with cells of that size.
class Spaced_points {
 public:
  Spaced_points(const Box& box, double spacing) : lower_(box.lower), spacing_(spacing) { slots_.assign(1024, -1); }

  void add(const Point_3& p) {
    const Cell cell = cell_of(p);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz)
          if (has_near({cell.x + dx, cell.y + dy, cell.z + dz}, p)) return;
    if (points_.size() == most_samples)
      throw Unavailable("the surface would get more than " + std::to_string(most_samples) +
                        " samples; choose a larger delta");
    if (2 * (cells_.size() + 1) > slots_.size()) grow();
    const std::size_t slot = slot_of(cell);
    if (slots_[slot] < 0) {
      slots_[slot] = static_cast<int>(cells_.size());
      cells_.push_back({cell, -1});
    }
    Entry& entry = cells_[slots_[slot]];
    next_.push_back(entry.last);
    entry.last = static_cast<int>(points_.size());
    points_.push_back(p);
  }
  std::vector<Point_3> take() { return std::move(points_); }

 private:
  struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
  };
  struct Entry {
    Cell cell;
    int last = -1;
  };

  Cell cell_of(const Point_3& p) const {
    return {static_cast<std::int64_t>(std::floor((p.x - lower_.x) / spacing_)),
            static_cast<std::int64_t>(std::floor((p.y - lower_.y) / spacing_)),
            static_cast<std::int64_t>(std::floor((p.z - lower_.z) / spacing_))};
  }
  /// Where the cell is, or would be put.
  std::size_t slot_of(const Cell& cell) const {
    constexpr std::uint64_t mix = 0x9E3779B97F4A7C15U;
    std::uint64_t hash = static_cast<std::uint64_t>(cell.x) * mix;
    hash = (std::rotl(hash, 23) ^ static_cast<std::uint64_t>(cell.y)) * mix;
    hash = (std::rotl(hash, 23) ^ static_cast<std::uint64_t>(cell.z)) * mix;
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash >> 20U) & mask;
    while (slots_[slot] >= 0 && !(cells_[slots_[slot]].cell == cell)) slot = (slot + 1) & mask;
    return slot;
  }
  bool has_near(const Cell& cell, const Point_3& p) const {
    const int found = slots_[slot_of(cell)];
    if (found < 0) return false;
    for (int i = cells_[found].last; i >= 0; i = next_[i])
      if (squared_distance(points_[i], p) < spacing_ * spacing_) return true;
    return false;
  }
  void grow() {
    slots_.assign(2 * slots_.size(), -1);
    for (std::size_t i = 0; i < cells_.size(); ++i) slots_[slot_of(cells_[i].cell)] = static_cast<int>(i);
  }

  Point_3 lower_;
  double spacing_;
  std::vector<int> slots_;  ///< into cells_; a power of two
  std::vector<Entry> cells_;
  std::vector<int> next_;  ///< per point the next one of its cell
  std::vector<Point_3> points_;
};

}  // namespace

Surface_samples_3 sample_surface(const Triangle_mesh_3& surface, double distance, Progress& progress) {
  progress.begin_stage("samples");
  // A point of a triangle is within step / sqrt(3) of its grid.
  constexpr double spacing_part = 0.7;
  constexpr double step_part = 0.5;
  const double step = step_part * distance;
  Box box;
  for (const Point_3& p : surface.vertices) box.add(p);
  Spaced_points points(box, spacing_part * distance);

  std::vector<std::uint8_t> is_used(surface.vertices.size(), 0);
  for (const auto& triangle : surface.triangles)
    for (const int v : triangle) is_used[v] = 1;
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    if (is_used[v] != 0) points.add(surface.vertices[v]);
  std::size_t count = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    constexpr std::size_t often = 1024;
    if (++count % often == 0)
      progress.report(static_cast<double>(count) / static_cast<double>(surface.triangles.size()));
    const Point_3& p = surface.vertices[a];
    const Point_3 u = surface.vertices[b] - p;
    const Point_3 v = surface.vertices[c] - p;
    const double longest = std::sqrt(std::max({dot(u, u), dot(v, v), dot(u - v, u - v)}));
    if (longest <= step) continue;
    const double parts = std::ceil(longest / step);
    if (parts * parts > 2.0 * static_cast<double>(most_samples))
      throw Unavailable("the surface would get too many samples; choose a larger delta");
    const int n = static_cast<int>(parts);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n - i; ++j) points.add(p + (i / parts) * u + (j / parts) * v);
  }
  return {points.take(), distance};
}

}  // namespace mesecina
