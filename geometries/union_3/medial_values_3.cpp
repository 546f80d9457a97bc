// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/medial_values_3.h"

#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "geometries/parallel.h"
#include "geometries/primitives_3.h"

namespace mesecina {

namespace {

using Plain_kernel = CGAL::Simple_cartesian<double>;
using Smallest_ball = CGAL::Min_sphere_of_spheres_d<CGAL::Min_sphere_of_points_d_traits_3<Plain_kernel, double>>;

/// The circle in which the spheres of the ends of an edge meet.
struct Circle_of_edge {
  double radius = 0;            ///< 0 where they do not
  double distance_to_edge = 0;  ///< of its center
};

Circle_of_edge circle_of(const Medial_complex_3& complex, const std::array<int, 2>& edge) {
  const double first = complex.radii[edge[0]];
  const double second = complex.radii[edge[1]];
  const double length = distance(complex.centers[edge[0]], complex.centers[edge[1]]);
  // Of ends that differ by rounding only the direction is noise; they are one ball.
  constexpr double rounding = 1e-12;
  // From the first end on.
  const double place =
      length > rounding * std::max(first, second) ? (length + (first - second) * (first + second) / length) / 2 : 0;
  Circle_of_edge circle;
  circle.radius = std::sqrt(std::max(0.0, (first - place) * (first + place)));
  circle.distance_to_edge = std::max({0.0, -place, place - length});
  return circle;
}

template <class Of_circle, class Of_vertex>
Medial_values_3 values_of(const Medial_complex_3& complex, std::vector<double> faces, const Of_circle& of_circle,
                          const Of_vertex& of_vertex) {
  const Loose_parts_3 loose = loose_parts(complex);
  std::vector<double> loose_edges;
  std::vector<double> loose_vertices;
  loose_edges.reserve(loose.edges.size());
  loose_vertices.reserve(loose.vertices.size());
  for (const auto& edge : loose.edges) loose_edges.push_back(of_circle(circle_of(complex, edge)));
  for (const int vertex : loose.vertices) loose_vertices.push_back(of_vertex(vertex));
  return values_with_bounds(complex, std::move(faces), loose_edges, loose_vertices);
}

}  // namespace

std::vector<int> edges_of_faces(const Medial_complex_3& complex) {
  Progress progress;
  return edges_of_faces(complex, progress);
}

std::vector<int> edges_of_faces(const Medial_complex_3& complex, Progress& progress) {
  // Edges are ascending: those of each lesser vertex are neighbours.
  std::vector<int> firsts(complex.centers.size() + 1, 0);
  for (const auto& ends : complex.edges) ++firsts[ends[0] + 1];
  std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
  std::vector<int> edges(complex.face_vertices.size());
  parallel_for(complex.face_count(), progress, [&](std::size_t f) {
    const auto corners = complex.face(f);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int a = corners[i];
      const int b = corners[(i + 1) % corners.size()];
      const std::array<int, 2> ends{std::min(a, b), std::max(a, b)};
      const auto it =
          std::lower_bound(complex.edges.begin() + firsts[ends[0]], complex.edges.begin() + firsts[ends[0] + 1], ends);
      edges[complex.face_offsets[f] + i] = static_cast<int>(it - complex.edges.begin());
    }
  });
  return edges;
}

Medial_values_3 values_with_bounds(const Medial_complex_3& complex, std::vector<double> faces,
                                   const std::vector<double>& loose_edges, const std::vector<double>& loose_vertices) {
  constexpr double nothing = -std::numeric_limits<double>::infinity();
  Medial_values_3 values{std::vector<double>(complex.centers.size(), nothing),
                         std::vector<double>(complex.edges.size(), nothing), std::move(faces)};
  const std::vector<int> sides = edges_of_faces(complex);
  std::vector<bool> has_face(complex.edges.size(), false);
  for (std::size_t f = 0; f < values.faces.size(); ++f) {
    for (int i = complex.face_offsets[f]; i < complex.face_offsets[f + 1]; ++i) {
      double& value = values.edges[sides[i]];
      value = std::max(value, values.faces[f]);
      has_face[sides[i]] = true;
    }
  }
  std::vector<bool> has_edge(complex.centers.size(), false);
  auto loose_edge = loose_edges.begin();
  for (std::size_t e = 0; e < complex.edges.size(); ++e) {
    if (!has_face[e]) values.edges[e] = *loose_edge++;
    for (const int v : complex.edges[e]) {
      values.vertices[v] = std::max(values.vertices[v], values.edges[e]);
      has_edge[v] = true;
    }
  }
  auto loose_vertex = loose_vertices.begin();
  for (std::size_t v = 0; v < has_edge.size(); ++v)
    if (!has_edge[v]) values.vertices[v] = *loose_vertex++;
  return values;
}

Medial_values_3 lambda_values(const Medial_complex_3& complex) {
  return values_of(
      complex, lambda_of_faces(complex), [](const Circle_of_edge& circle) { return circle.radius; },
      [&](int vertex) { return complex.radii[vertex]; });
}

Medial_values_3 angle_values(const Medial_complex_3& complex, Progress& progress) {
  constexpr double straight = 180;
  return values_of(
      complex, angle_of_faces(complex, progress),
      [](const Circle_of_edge& circle) {
        if (circle.distance_to_edge == 0) return straight;
        return 2 * std::atan2(circle.radius, circle.distance_to_edge) * straight / std::numbers::pi;
      },
      [](int) { return straight; });
}

std::vector<double> slope_of_vertices(const Medial_complex_3& complex, Progress& progress) {
  // Faces by their vertices.
  std::vector<int> offsets(complex.centers.size() + 1, 0);
  for (const int v : complex.face_vertices) ++offsets[v + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> faces(complex.face_vertices.size());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (std::size_t f = 0; f < complex.face_count(); ++f)
    for (const int v : complex.face(f)) faces[next[v]++] = static_cast<int>(f);

  std::vector<double> slopes(complex.centers.size(), 1);
  constexpr std::size_t block = 2048;
  parallel_blocks((slopes.size() + block - 1) / block, progress, [&](std::size_t b) {
    std::vector<Plain_kernel::Point_3> directions;
    for (std::size_t v = b * block; v < std::min(slopes.size(), (b + 1) * block); ++v) {
      directions.clear();
      for (int i = offsets[v]; i < offsets[v + 1]; ++i) {
        for (const Point_3& contact : complex.contacts[faces[i]]) {
          const Point_3 offset = contact - complex.centers[v];
          const double length = std::sqrt(dot(offset, offset));
          if (length > 0) directions.emplace_back(offset.x / length, offset.y / length, offset.z / length);
        }
      }
      if (directions.empty()) continue;
      // The distance to contacts in directions n grows in direction e by -max n e. The least of that is attained
      // opposite to the point of their convex hull that is nearest to the center, which is the center of the smallest
      // ball around them, as they are equally far.
      Smallest_ball ball(directions.begin(), directions.end());
      const auto center = ball.center_cartesian_begin();
      slopes[v] = std::min(1.0, std::sqrt(center[0] * center[0] + center[1] * center[1] + center[2] * center[2]));
    }
  });
  return slopes;
}

Primitive_set medial_primitives(const Medial_complex_3& complex) {
  Primitive_set set = point_primitives(complex.centers);
  set.radii = complex.radii;
  set.is_complex = true;
  set.segments = complex.edges;
  set.polygon_offsets = complex.face_offsets;
  set.polygon_vertices = complex.face_vertices;
  return set;
}

void add_medial_values(Primitive_set& set, std::string name, std::string unit, const Medial_values_3& values) {
  Values added{std::move(name), std::move(unit), {}};
  added.data.reserve(set.element_count());
  for (const auto* part : {&values.vertices, &values.edges, &values.faces})
    added.data.insert(added.data.end(), part->begin(), part->end());
  set.values.push_back(std::move(added));
}

}  // namespace mesecina
