// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/samples_3/surface_checks_3.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/geometries/shapes.h"

namespace mesecina::test {

std::vector<Point_3> random_surface_points(const Triangle_mesh_3& mesh, int count, std::uint64_t seed) {
  std::vector<double> areas;
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point_3 normal = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
    sum += std::sqrt(dot(normal, normal));
    areas.push_back(sum);
  }
  Random random(seed);
  std::vector<Point_3> result;
  for (int i = 0; i < count; ++i) {
    const auto place = std::ranges::upper_bound(areas, sum * random.unit());
    const auto& [a, b, c] = mesh.triangles[std::min<std::ptrdiff_t>(place - areas.begin(), std::ssize(areas) - 1)];
    double u = random.unit();
    double v = random.unit();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Point_3& p = mesh.vertices[a];
    result.push_back(p + u * (mesh.vertices[b] - p) + v * (mesh.vertices[c] - p));
  }
  return result;
}

double distance_to_nearest(const std::vector<Point_3>& points, const Point_3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point_3& q : points) least = std::min(least, squared_distance(p, q));
  return std::sqrt(least);
}

Triangle_mesh_3 column_mesh(const std::vector<Point_2>& polygon, double height) {
  Triangle_mesh_3 mesh;
  const int n = static_cast<int>(polygon.size());
  for (const Point_2& p : polygon) mesh.vertices.push_back({p.x, p.y, 0});
  for (const Point_2& p : polygon) mesh.vertices.push_back({p.x, p.y, height});
  for (int i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({n, n + i, n + i + 1});
  }
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
  }
  return mesh;
}

}  // namespace mesecina::test
