// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/level_surface.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace mesecina {

namespace {

/// A corner of a cell by its bits: 1 for x, 2 for y, 4 for z. An edge goes from a corner to one with more bits.
using Edge = std::array<unsigned, 2>;
using Triangle = std::array<Edge, 3>;
constexpr unsigned corner_count = 8;

Point_3 place_of(unsigned corner) {
  return {corner & 1U ? 1.0 : 0.0, corner & 2U ? 1.0 : 0.0, corner & 4U ? 1.0 : 0.0};
}

Point_3 middle_of(const Edge& edge) { return 0.5 * (place_of(edge[0]) + place_of(edge[1])); }

Edge edge_between(unsigned a, unsigned b) { return {std::min(a, b), std::max(a, b)}; }

/// With the normal away from the corner.
Triangle turned_away(Triangle triangle, unsigned corner) {
  const Point_3 a = middle_of(triangle[0]);
  const Point_3 normal = cross(middle_of(triangle[1]) - a, middle_of(triangle[2]) - a);
  if (dot(normal, a - place_of(corner)) < 0) std::swap(triangle[1], triangle[2]);
  return triangle;
}

void add_triangles_of_tetrahedron(const std::array<unsigned, 4>& corners, unsigned inside,
                                  std::vector<Triangle>& triangles) {
  std::vector<unsigned> in;
  std::vector<unsigned> out;
  for (const unsigned corner : corners) (inside >> corner & 1U ? in : out).push_back(corner);
  if (in.empty() || out.empty()) return;
  std::vector<Edge> ring;
  if (in.size() == 2) {
    ring = {edge_between(in[0], out[0]), edge_between(in[0], out[1]), edge_between(in[1], out[1]),
            edge_between(in[1], out[0])};
  } else {
    for (const unsigned a : in)
      for (const unsigned b : out) ring.push_back(edge_between(a, b));
  }
  for (std::size_t i = 2; i < ring.size(); ++i)
    triangles.push_back(turned_away({ring[0], ring[i - 1], ring[i]}, in[0]));
}

/// Of a cell, by which of its corners are inside. All cells are parted alike, along the diagonal from 0 to 7, so faces
/// of neighbours match.
std::vector<std::vector<Triangle>> triangles_by_corners() {
  std::vector<std::vector<Triangle>> table(1U << corner_count);
  for (unsigned inside = 0; inside < table.size(); ++inside)
    for (const unsigned first : {1U, 2U, 4U})
      for (const unsigned second : {1U, 2U, 4U})
        if (second != first) add_triangles_of_tetrahedron({0, first, first | second, 7}, inside, table[inside]);
  return table;
}

/// Marches through the cells of a grid that has one more layer of numbers all around, which are outside.
class March {
 public:
  March(const Volume_3& volume, double level, std::size_t most_triangles)
      : volume_(volume), level_(level), most_triangles_(most_triangles) {}

  Level_surface_3 run() {
    const auto [x, y, z] = volume_.counts;
    if (volume_.values.empty()) return std::move(surface_);
    for (std::size_t k = 0; k <= z; ++k)
      for (std::size_t j = 0; j <= y; ++j)
        for (std::size_t i = 0; i <= x; ++i) add_cell({i, j, k});
    return std::move(surface_);
  }

 private:
  using Place = std::array<std::size_t, 3>;  ///< in the larger grid

  static Place moved(const Place& cell, unsigned corner) {
    return {cell[0] + (corner & 1U), cell[1] + (corner >> 1U & 1U), cell[2] + (corner >> 2U & 1U)};
  }
  bool is_around(const Place& place) const {
    for (std::size_t axis = 0; axis < place.size(); ++axis)
      if (place[axis] == 0 || place[axis] > volume_.counts[axis]) return true;
    return false;
  }
  double value(const Place& place) const {
    return volume_.values[(place[0] - 1) + volume_.counts[0] * ((place[1] - 1) + volume_.counts[1] * (place[2] - 1))];
  }
  bool is_inside(const Place& place) const { return !is_around(place) && value(place) >= level_; }

  void add_cell(const Place& cell) {
    unsigned inside = 0;
    for (unsigned corner = 0; corner < corner_count; ++corner)
      if (is_inside(moved(cell, corner))) inside |= 1U << corner;
    for (const Triangle& triangle : table_[inside]) {
      if (surface_.mesh.triangles.size() == most_triangles_) throw std::length_error("too many triangles");
      surface_.mesh.triangles.push_back(
          {vertex_on(cell, triangle[0]), vertex_on(cell, triangle[1]), vertex_on(cell, triangle[2])});
    }
  }

  int vertex_on(const Place& cell, const Edge& edge) {
    const Place from = moved(cell, edge[0]);
    const Place to = moved(cell, edge[1]);
    const std::uint64_t number =
        from[0] + (volume_.counts[0] + 2) * (from[1] + (volume_.counts[1] + 2) * std::uint64_t{from[2]});
    const auto [known, is_new] = vertices_.try_emplace(corner_count * number + (edge[0] ^ edge[1]),
                                                       static_cast<int>(surface_.mesh.vertices.size()));
    if (is_new) surface_.mesh.vertices.push_back(crossing(from, to));
    return known->second;
  }

  /// Never at an end, where vertices of several edges would be one.
  Point_3 crossing(const Place& from, const Place& to) {
    double part = 0.5;
    if (is_around(from) || is_around(to)) {
      surface_.meets_border = true;
    } else {
      constexpr double least = 1e-3;
      const double start = value(from);
      part = std::clamp((level_ - start) / (value(to) - start), least, 1 - least);
    }
    const auto along = [&](std::size_t axis, double origin, double spacing) {
      const double steps = static_cast<double>(from[axis]) - 1 +
                           part * (static_cast<double>(to[axis]) - static_cast<double>(from[axis]));
      return origin + steps * spacing;
    };
    return {along(0, volume_.origin.x, volume_.spacing.x), along(1, volume_.origin.y, volume_.spacing.y),
            along(2, volume_.origin.z, volume_.spacing.z)};
  }

  const Volume_3& volume_;
  double level_;
  std::size_t most_triangles_;
  std::vector<std::vector<Triangle>> table_ = triangles_by_corners();
  std::unordered_map<std::uint64_t, int> vertices_;  ///< by edge
  Level_surface_3 surface_;
};

}  // namespace

double otsu_threshold(std::span<const float> values) {
  if (values.empty()) return 0;
  const auto [least, greatest] = std::ranges::minmax(values);
  if (least == greatest) return least;
  constexpr std::size_t bins = 256;
  const double width = (static_cast<double>(greatest) - least) / bins;
  std::array<double, bins> counts{};
  for (const float value : values)
    ++counts[std::min(bins - 1, static_cast<std::size_t>((static_cast<double>(value) - least) / width))];
  double sum = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) sum += static_cast<double>(bin) * counts[bin];
  const double total = static_cast<double>(values.size());
  double below = 0;
  double sum_below = 0;
  double best = -1;
  std::size_t first_best = 0;
  std::size_t last_best = 0;
  for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
    below += counts[bin];
    sum_below += static_cast<double>(bin) * counts[bin];
    if (below == 0 || below == total) continue;
    const double difference = sum_below / below - (sum - sum_below) / (total - below);
    const double between = below * (total - below) * difference * difference;
    if (between > best) {
      best = between;
      first_best = bin;
    }
    if (between >= best) last_best = bin;
  }
  // In the middle of a gap between the classes.
  return least + width * (static_cast<double>(first_best + last_best) / 2 + 1);
}

Level_surface_3 level_surface(const Volume_3& volume, double level, std::size_t most_triangles) {
  return March(volume, level, most_triangles).run();
}

}  // namespace mesecina
