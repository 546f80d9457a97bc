// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/outcome.h"
#include "geometries/parallel.h"
#include "geometries/samples_3/graded_grid_3.h"
#include "geometries/samples_3/samples_3.h"

namespace mesecina {

namespace {

constexpr std::size_t most_samples = 20'000'000;
/// Of the distance within which every point of the surface shall have a sample.
constexpr double covering_part = 0.7;

/// Takes points that keep their distance from those before.
class Spaced_samples {
 public:
  explicit Spaced_samples(double distance) : spacing_(covering_part * distance), grid_(spacing_) {
    samples_.covering_radius = distance;
  }

  /// A sample there would be too near to another one.
  bool is_taken(const Point_3& p) const {
    return grid_.any_near(p, spacing_,
                          [&](int i) { return squared_distance(grid_.point(i), p) < spacing_ * spacing_; });
  }
  void add(const Point_3& p, const Point_3& normal) {
    if (is_taken(p)) return;
    if (grid_.size() == most_samples)
      throw Unavailable("the surface would get more than " + std::to_string(most_samples) +
                        " samples; choose a larger {delta}");
    grid_.add(p, spacing_);
    samples_.points.push_back(p);
    samples_.normals.push_back(normal);
  }
  Surface_samples_3 take() {
    samples_.spacing.assign(samples_.points.size(), samples_.covering_radius);
    return std::move(samples_);
  }

 private:
  double spacing_;
  Graded_grid_3 grid_;
  Surface_samples_3 samples_;
};

/// Rows of the grid of a triangle.
struct Rows {
  std::array<int, 3> triangle{};
  int parts = 0;  ///< of each edge
  int first = 0;
  int end = 0;
};

/// Of the grid of a triangle, corners are vertices of the surface.
bool is_corner(const Rows& rows, int i, int j) {
  const int k = rows.parts - i - j;
  return i + j == 0 || j + k == 0 || k + i == 0;
}

Point_3 unit(const Point_3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? (1 / length) * v : v;
}

}  // namespace

Surface_samples_3 sample_surface(const Triangle_mesh_3& surface, double distance, Progress& progress) {
  progress.begin_stage("samples");
  // A point of a triangle is within step / sqrt(3) of its grid.
  constexpr double step_part = 0.5;
  const double step = step_part * distance;
  std::vector<Point_3> normals(surface.vertices.size());
  std::vector<std::uint8_t> is_used(surface.vertices.size(), 0);
  const auto normal_of = [&](const std::array<int, 3>& triangle) {
    const Point_3& p = surface.vertices[triangle[0]];
    return cross(surface.vertices[triangle[1]] - p, surface.vertices[triangle[2]] - p);
  };
  for (const auto& triangle : surface.triangles) {
    const Point_3 normal = normal_of(triangle);
    for (const int v : triangle) {
      normals[v] = normals[v] + normal;
      is_used[v] = 1;
    }
  }

  Spaced_samples samples(distance);
  for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    if (is_used[v] != 0) samples.add(surface.vertices[v], unit(normals[v]));

  std::vector<Rows> pieces;
  std::size_t count = 0;
  // Most places near to samples that are there before are found by all threads, the others one after the other.
  const auto add_pieces = [&] {
    std::vector<std::vector<Point_3>> open(pieces.size());
    constexpr std::size_t block = 64;
    parallel_blocks((pieces.size() + block - 1) / block, progress, [&](std::size_t b) {
      for (std::size_t i = b * block; i < std::min(pieces.size(), (b + 1) * block); ++i) {
        const Rows& rows = pieces[i];
        const Point_3& p = surface.vertices[rows.triangle[0]];
        const Point_3 u = surface.vertices[rows.triangle[1]] - p;
        const Point_3 v = surface.vertices[rows.triangle[2]] - p;
        const double parts = rows.parts;
        for (int row = rows.first; row < rows.end; ++row) {
          for (int j = 0; j <= rows.parts - row; ++j) {
            if (is_corner(rows, row, j)) continue;
            const Point_3 place = p + (row / parts) * u + (j / parts) * v;
            if (!samples.is_taken(place)) open[i].push_back(place);
          }
        }
      }
    });
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (open[i].empty()) continue;
      const Point_3 normal = unit(normal_of(pieces[i].triangle));
      for (const Point_3& place : open[i]) samples.add(place, normal);
    }
    pieces.clear();
    count = 0;
  };
  std::size_t done = 0;
  for (const auto& triangle : surface.triangles) {
    ++done;
    const Point_3& p = surface.vertices[triangle[0]];
    const Point_3 u = surface.vertices[triangle[1]] - p;
    const Point_3 v = surface.vertices[triangle[2]] - p;
    const double longest = std::sqrt(std::max({dot(u, u), dot(v, v), dot(u - v, u - v)}));
    if (longest <= step) continue;
    const double parts = std::ceil(longest / step);
    if (parts * parts > 2.0 * static_cast<double>(most_samples))
      throw Unavailable("the surface would get too many samples; choose a larger {delta}");
    const int n = static_cast<int>(parts);
    constexpr int most_rows = 64;
    for (int row = 0; row <= n; row += most_rows) {
      pieces.push_back({triangle, n, row, std::min(row + most_rows, n + 1)});
      constexpr std::size_t most_places = 500'000;
      count += static_cast<std::size_t>(std::min(n, most_rows)) * n;
      if (count < most_places) continue;
      progress.report(static_cast<double>(done) / static_cast<double>(surface.triangles.size()));
      add_pieces();
    }
  }
  add_pieces();
  return samples.take();
}

}  // namespace mesecina
