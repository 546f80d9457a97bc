// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/solid_3/solid_oracle_3.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tests/geometries/shapes.h"

namespace mesecina::test {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_3 convert(const Point_3& p) { return {p.x, p.y, p.z}; }

Kernel::Triangle_3 triangle_of(const Triangle_mesh_3& mesh, const std::array<int, 3>& t) {
  return {convert(mesh.vertices[t[0]]), convert(mesh.vertices[t[1]]), convert(mesh.vertices[t[2]])};
}

/// How often the ray crosses the surface; nullopt when it meets an edge or lies in a triangle.
std::optional<int> crossings(const Triangle_mesh_3& mesh, const Kernel::Point_3& from, const Kernel::Point_3& far) {
  int result = 0;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Kernel::Triangle_3 triangle = triangle_of(mesh, t);
    const auto a = triangle.vertex(0);
    const auto b = triangle.vertex(1);
    const auto c = triangle.vertex(2);
    const std::array sides{CGAL::orientation(from, far, a, b), CGAL::orientation(from, far, b, c),
                           CGAL::orientation(from, far, c, a)};
    const bool has_left = std::ranges::count(sides, CGAL::POSITIVE) > 0;
    const bool has_right = std::ranges::count(sides, CGAL::NEGATIVE) > 0;
    if (has_left && has_right) continue;
    const auto side_of_from = CGAL::orientation(a, b, c, from);
    const auto side_of_far = CGAL::orientation(a, b, c, far);
    if (side_of_from == side_of_far && side_of_from != CGAL::COPLANAR) continue;
    if (std::ranges::count(sides, CGAL::COPLANAR) > 0) return std::nullopt;
    ++result;
  }
  return result;
}

}  // namespace

Place place_of(const Triangle_mesh_3& closed_mesh, const Point_3& p) {
  const Kernel::Point_3 place = convert(p);
  for (const std::array<int, 3>& t : closed_mesh.triangles)
    if (triangle_of(closed_mesh, t).has_on(place)) return Place::on_surface;
  Random random(7);
  constexpr double far_away = 1e6;
  for (;;) {
    const Kernel::Point_3 far(random.uniform(-far_away, far_away), random.uniform(-far_away, far_away),
                              random.uniform(-far_away, far_away));
    if (const auto count = crossings(closed_mesh, place, far)) return *count % 2 == 1 ? Place::inside : Place::outside;
  }
}

double distance_to(const Triangle_mesh_3& mesh, const Point_3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Point_3& a = mesh.vertices[t[0]];
    const Point_3 normal = cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
    bool is_above = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point_3& from = mesh.vertices[t[k]];
      const Point_3 along = mesh.vertices[t[(k + 1) % 3]] - from;
      is_above = is_above && dot(cross(normal, along), p - from) >= 0;
      const double where = std::clamp(dot(along, p - from) / dot(along, along), 0.0, 1.0);
      least = std::min(least, distance(p, from + where * along));
    }
    if (is_above) least = std::min(least, std::abs(dot(normal, p - a)) / std::sqrt(dot(normal, normal)));
  }
  return least;
}

std::vector<std::array<int, 2>> crossing_pairs(const Triangle_mesh_3& mesh) {
  std::vector<std::array<int, 2>> result;
  const int count = static_cast<int>(mesh.triangles.size());
  for (int s = 0; s < count; ++s) {
    for (int t = s + 1; t < count; ++t) {
      const auto common =
          CGAL::intersection(triangle_of(mesh, mesh.triangles[s]), triangle_of(mesh, mesh.triangles[t]));
      if (!common) continue;
      const auto shared = std::ranges::count_if(
          mesh.triangles[s], [&](int v) { return std::ranges::find(mesh.triangles[t], v) != mesh.triangles[t].end(); });
      const bool is_point = boost::get<Kernel::Point_3>(&*common) != nullptr;
      const bool is_segment = boost::get<Kernel::Segment_3>(&*common) != nullptr;
      if ((shared == 1 && is_point) || (shared == 2 && is_segment)) continue;
      result.push_back({s, t});
    }
  }
  return result;
}

}  // namespace mesecina::test
