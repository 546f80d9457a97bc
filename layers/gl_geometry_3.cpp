// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_geometry_3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mesecina {

namespace {

/// Of the set's diagonal.
constexpr double length_of_rays = 16;

using Edge = std::array<int, 2>;

void append_place(std::vector<float>& places, const Point_3& p) {
  places.insert(places.end(), {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), 1});
}

void append_normal(std::vector<float>& normals, const Point_3& p) {
  const double length = std::hypot(p.x, p.y, p.z);
  const Point_3 unit = length > 0 && std::isfinite(length) ? (1 / length) * p : Point_3{};
  normals.insert(normals.end(),
                 {static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z), 0});
}

std::size_t first_triangle(const Primitive_set& set) {
  return set.points.size() + set.segments.size() + set.rays.size() + set.arcs.size();
}

std::size_t first_polygon(const Primitive_set& set) { return first_triangle(set) + set.triangles.size(); }

/// Calls visit(corners, element) for every triangle and polygon.
template <class Visit>
void for_each_face(const Primitive_set& set, const Visit& visit) {
  for (std::size_t i = 0; i < set.triangles.size(); ++i)
    visit(std::span<const int>(set.triangles[i]), first_triangle(set) + i);
  for (std::size_t i = 0; i < set.polygon_count(); ++i) visit(set.polygon(i), first_polygon(set) + i);
}

/// Calls visit(from, to) for every edge of the face in its direction.
template <class Visit>
void for_each_edge(std::span<const int> corners, const Visit& visit) {
  for (std::size_t i = 0; i < corners.size(); ++i) visit(corners[i], corners[(i + 1) % corners.size()]);
}

Edge sorted(int from, int to) { return {std::min(from, to), std::max(from, to)}; }

std::vector<Edge> edges_of_faces(const Primitive_set& set) {
  std::vector<Edge> edges;
  for_each_face(set, [&](std::span<const int> corners, std::size_t) {
    for_each_edge(corners, [&](int from, int to) { edges.push_back(sorted(from, to)); });
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Of the area; half as long is the area of the face.
Point_3 normal_of(const Primitive_set& set, std::span<const int> corners) {
  Point_3 sum;
  const Point_3& first = set.vertices[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum = sum + cross(set.vertices[corners[i]] - first, set.vertices[corners[i + 1]] - first);
  return sum;
}

std::vector<bool> bounding_vertices(const Primitive_set& set) {
  std::vector<bool> is_bounding(set.vertices.size(), false);
  for (const Edge& segment : set.segments) is_bounding[segment[0]] = is_bounding[segment[1]] = true;
  for_each_face(set, [&](std::span<const int> corners, std::size_t) {
    for (const int vertex : corners) is_bounding[vertex] = true;
  });
  return is_bounding;
}

}  // namespace

std::size_t first_ball_3(const Primitive_set& set) { return first_polygon(set) + set.polygon_count(); }

std::vector<float> places_3(const Primitive_set& set, const Point_3& origin) {
  std::vector<float> places;
  places.reserve(4 * (set.vertices.size() + set.rays.size()));
  for (const Point_3& vertex : set.vertices) append_place(places, vertex - origin);
  const double diagonal = set.bounding_box().diagonal();
  const double reach = length_of_rays * (diagonal > 0 ? diagonal : 1);
  for (const Ray& ray : set.rays) append_place(places, set.vertices[ray.from] - origin + reach * ray.direction);
  return places;
}

std::vector<std::int32_t> pieces_3(const Primitive_set& set, Part_3 part) {
  std::vector<std::int32_t> pieces;
  const auto add = [&pieces](int first, int second, int third, std::size_t element) {
    pieces.insert(pieces.end(), {first, second, third, static_cast<std::int32_t>(element)});
  };
  switch (part) {
    case Part_3::points:
    case Part_3::bounding_points: {
      const std::vector<bool> is_bounding = bounding_vertices(set);
      for (std::size_t i = 0; i < set.points.size(); ++i)
        if (is_bounding[set.points[i]] == (part == Part_3::bounding_points)) add(set.points[i], 0, 0, i);
      break;
    }
    case Part_3::segments:
    case Part_3::bounding_segments: {
      const std::vector<Edge> edges = edges_of_faces(set);
      for (std::size_t i = 0; i < set.segments.size(); ++i) {
        const auto [from, to] = set.segments[i];
        const bool is_bounding = std::binary_search(edges.begin(), edges.end(), sorted(from, to));
        if (is_bounding == (part == Part_3::bounding_segments)) add(from, to, 0, set.points.size() + i);
      }
      if (part == Part_3::bounding_segments) break;
      for (std::size_t i = 0; i < set.rays.size(); ++i)
        add(set.rays[i].from, static_cast<int>(set.vertices.size() + i), 0,
            set.points.size() + set.segments.size() + i);
      break;
    }
    case Part_3::face_edges:
      for_each_face(set, [&](std::span<const int> corners, std::size_t element) {
        for_each_edge(corners, [&](int from, int to) { add(std::min(from, to), std::max(from, to), 0, element); });
      });
      break;
    case Part_3::faces:
      for_each_face(set, [&](std::span<const int> corners, std::size_t element) {
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) add(corners[0], corners[i], corners[i + 1], element);
      });
      break;
  }
  return pieces;
}

std::vector<float> balls_3(const Primitive_set& set, const Point_3& origin) {
  std::vector<float> balls;
  balls.reserve(4 * set.balls.size());
  for (const Ball& ball : set.balls) {
    append_place(balls, set.vertices[ball.center] - origin);
    balls.back() = static_cast<float>(ball.radius);
  }
  return balls;
}

std::vector<float> face_normals_3(const Primitive_set& set) {
  std::vector<float> normals;
  for_each_face(set, [&](std::span<const int> corners, std::size_t) {
    if (corners.size() < 3) return;
    const Point_3 normal = normal_of(set, corners);
    for (std::size_t i = 2; i < corners.size(); ++i) append_normal(normals, normal);
  });
  return normals;
}

std::vector<float> vertex_normals_3(const Primitive_set& set) {
  std::vector<Point_3> sums(set.vertices.size());
  for_each_face(set, [&](std::span<const int> corners, std::size_t) {
    if (corners.size() < 3) return;
    const Point_3 normal = normal_of(set, corners);
    for (const int vertex : corners) {
      Point_3& sum = sums[static_cast<std::size_t>(vertex)];
      sum = sum + (dot(sum, normal) < 0 ? -1.0 : 1.0) * normal;
    }
  });
  std::vector<float> normals;
  normals.reserve(4 * sums.size());
  for (const Point_3& sum : sums) append_normal(normals, sum);
  return normals;
}

bool is_closed_3(const Primitive_set& set) {
  std::vector<std::pair<Edge, int>> passes;
  for_each_face(set, [&](std::span<const int> corners, std::size_t) {
    for_each_edge(corners, [&](int from, int to) {
      if (from != to) passes.emplace_back(sorted(from, to), from < to ? 1 : -1);
    });
  });
  std::sort(passes.begin(), passes.end());
  for (std::size_t i = 0; i < passes.size();) {
    int balance = 0;
    const Edge edge = passes[i].first;
    for (; i < passes.size() && passes[i].first == edge; ++i) balance += passes[i].second;
    if (balance != 0) return false;
  }
  return !passes.empty();
}

}  // namespace mesecina
