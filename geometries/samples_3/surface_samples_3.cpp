// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/outcome.h"
#include "geometries/samples_3/graded_grid_3.h"
#include "geometries/samples_3/samples_3.h"

namespace mesecina {

namespace {

constexpr std::size_t most_samples = 20'000'000;
/// Of the distance within which every point of the surface shall have a sample.
constexpr double spacing_part = 0.7;

/// Takes points that keep their distance from those before.
class Spaced_samples {
 public:
  explicit Spaced_samples(double distance) : spacing_(spacing_part * distance), grid_(spacing_) {
    samples_.covering_radius = distance;
  }

  void add(const Point_3& p, const Point_3& normal) {
    if (grid_.any_near(p, spacing_, [&](int i) { return squared_distance(grid_.point(i), p) < spacing_ * spacing_; }))
      return;
    if (grid_.size() == most_samples)
      throw Unavailable("the surface would get more than " + std::to_string(most_samples) +
                        " samples; choose a larger delta");
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
  std::size_t count = 0;
  for (const auto& triangle : surface.triangles) {
    constexpr std::size_t often = 1024;
    if (++count % often == 0)
      progress.report(static_cast<double>(count) / static_cast<double>(surface.triangles.size()));
    const Point_3& p = surface.vertices[triangle[0]];
    const Point_3 u = surface.vertices[triangle[1]] - p;
    const Point_3 v = surface.vertices[triangle[2]] - p;
    const double longest = std::sqrt(std::max({dot(u, u), dot(v, v), dot(u - v, u - v)}));
    if (longest <= step) continue;
    const double parts = std::ceil(longest / step);
    if (parts * parts > 2.0 * static_cast<double>(most_samples))
      throw Unavailable("the surface would get too many samples; choose a larger delta");
    const int n = static_cast<int>(parts);
    const Point_3 normal = unit(normal_of(triangle));
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n - i; ++j) samples.add(p + (i / parts) * u + (j / parts) * v, normal);
  }
  return samples.take();
}

}  // namespace mesecina
