// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/union_3/axis_checks_3.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>

#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {

namespace {

std::string place(const Point_3& p) {
  std::ostringstream text;
  text.precision(17);
  text << "(" << p.x << ", " << p.y << ", " << p.z << ")";
  return text.str();
}

std::array<int, 2> sorted_edge(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

Point_3 combination(const Medial_complex_3& axis, std::span<const int> vertices, const std::vector<double>& factors) {
  Point_3 result;
  double sum = 0;
  for (const double f : factors) sum += f;
  for (std::size_t i = 0; i < vertices.size(); ++i) result = result + (factors[i] / sum) * axis.centers[vertices[i]];
  return result;
}

double distance_to_complex(const Medial_complex_3& axis, const Point_3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point_3& c : axis.centers) least = std::min(least, distance(c, p));
  for (const auto& [a, b] : axis.edges)
    least = std::min(least, distance_to_segment(p, axis.centers[a], axis.centers[b]));
  for (std::size_t f = 0; f < axis.face_count(); ++f) {
    const auto v = axis.face(f);
    for (std::size_t i = 1; i + 1 < v.size(); ++i)
      least = std::min(least, distance_to_triangle(p, axis.centers[v[0]], axis.centers[v[i]], axis.centers[v[i + 1]]));
  }
  return least;
}

}  // namespace

Axis_3 axis_of(const std::vector<Ball_3>& balls) {
  Progress progress;
  Axis_3 result;
  auto regular = std::make_shared<const Regular_3>(regular_triangulation(balls, progress));
  result.dual = std::make_shared<const Dual_3>(dual_complex(std::move(regular), progress));
  result.vertices = union_vertices(result.dual, progress);
  result.complex = union_medial_axis(result.vertices, progress);
  return result;
}

Connectivity connectivity(const Medial_complex_3& axis) {
  std::vector<int> parent(axis.centers.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int a) {
    while (parent[a] != a) a = parent[a] = parent[parent[a]];
    return a;
  };
  auto components = static_cast<std::int64_t>(parent.size());
  for (const auto& [a, b] : axis.edges) {
    const int x = root(a);
    const int y = root(b);
    if (x == y) continue;
    parent[x] = y;
    --components;
  }
  return {components, static_cast<std::int64_t>(axis.centers.size() + axis.face_count()) -
                          static_cast<std::int64_t>(axis.edges.size())};
}

Topology topology_by_ranks(const Medial_complex_3& axis) {
  std::map<std::array<int, 2>, int> index;
  std::vector<std::vector<int>> ends;
  for (const auto& e : axis.edges) {
    index.emplace(e, static_cast<int>(index.size()));
    ends.push_back({e[0], e[1]});
  }
  std::vector<std::vector<int>> sides;
  for (std::size_t f = 0; f < axis.face_count(); ++f) {
    const auto v = axis.face(f);
    std::map<int, int> count;
    for (std::size_t i = 0; i < v.size(); ++i) ++count[index.at(sorted_edge(v[i], v[(i + 1) % v.size()]))];
    std::vector<int> column;
    for (const auto& [edge, times] : count)
      if (times % 2 == 1) column.push_back(edge);
    sides.push_back(column);
  }
  const auto edge_rank = static_cast<std::int64_t>(rank_mod_2(ends));
  const auto face_rank = static_cast<std::int64_t>(rank_mod_2(sides));
  Topology result;
  result.betti = {static_cast<std::int64_t>(axis.centers.size()) - edge_rank,
                  static_cast<std::int64_t>(axis.edges.size()) - edge_rank - face_rank,
                  static_cast<std::int64_t>(axis.face_count()) - face_rank};
  result.euler = result.betti[0] - result.betti[1] + result.betti[2];
  return result;
}

testing::AssertionResult is_complex(const Axis_3& axis) {
  const Medial_complex_3& complex = axis.complex;
  const auto count = static_cast<int>(complex.centers.size());
  if (complex.radii.size() != complex.centers.size() || complex.balls.size() != complex.centers.size() ||
      complex.face_offsets.size() != complex.face_count() + 1 ||
      complex.face_offsets.back() != static_cast<int>(complex.face_vertices.size()))
    return failure() << "sizes do not fit";
  for (std::size_t i = 0; i < complex.edges.size(); ++i) {
    const auto& e = complex.edges[i];
    if (e[0] < 0 || e[0] >= e[1] || e[1] >= count) return failure() << "an edge is wrong";
    if (i > 0 && !(complex.edges[i - 1] < e)) return failure() << "edges are not in order, or twice";
  }
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    const auto v = complex.face(f);
    std::vector<int> corners(v.begin(), v.end());
    std::ranges::sort(corners);
    if (corners.size() < 3 || std::ranges::adjacent_find(corners) != corners.end())
      return failure() << "a face has less than three vertices, or one twice";
    for (std::size_t i = 0; i < v.size(); ++i)
      if (!std::ranges::binary_search(complex.edges, sorted_edge(v[i], v[(i + 1) % v.size()])))
        return failure() << "an edge of a face is missing";
  }
  std::vector<int> balls;
  for (int i = 0; i < count; ++i) {
    const int ball = complex.balls[i];
    if (ball < 0) continue;
    const Ball_3& b = axis.dual->regular->balls[ball];
    if (b.center != complex.centers[i] || b.radius != complex.radii[i]) return failure() << "not ball " << ball;
    balls.push_back(ball);
  }
  std::ranges::sort(balls);
  if (std::ranges::adjacent_find(balls) != balls.end()) return failure() << "a ball is there twice";
  return testing::AssertionSuccess();
}

testing::AssertionResult is_medial(const Axis_3& axis, const Boundary_oracle_3& boundary, double relative_tolerance) {
  const Medial_complex_3& complex = axis.complex;
  const double tolerance = relative_tolerance * boundary.scale() + 1e3 * boundary.precision();
  const auto differ = [&](double a, double b) { return !(std::abs(a - b) <= tolerance); };
  const auto vertex_distance = [&](const Point_3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const Point_3& v : boundary.vertices()) least = std::min(least, distance(p, v));
    return least;
  };
  for (std::size_t i = 0; i < complex.centers.size(); ++i) {
    const Point_3& c = complex.centers[i];
    if (!boundary.is_inside(c)) return failure() << "vertex " << place(c) << " is outside";
    const double d = boundary.distance_to_boundary(c);
    if (differ(d, complex.radii[i]))
      return failure() << "vertex " << place(c) << " has radius " << complex.radii[i] << " instead of " << d;
  }
  for (const auto& [a, b] : complex.edges) {
    for (const double t : {0.3, 0.5, 0.8}) {
      const Point_3 p = (1 - t) * complex.centers[a] + t * complex.centers[b];
      if (!boundary.is_inside(p)) return failure() << "edge point " << place(p) << " is outside";
      const double d = boundary.distance_to_boundary(p);
      double expected = vertex_distance(p);
      if (complex.balls[a] >= 0 && complex.balls[b] >= 0) {
        // On the line between centers the circle is nearest.
        const Ball_3& ball = axis.dual->regular->balls[complex.balls[a]];
        const Ball_3& other = axis.dual->regular->balls[complex.balls[b]];
        const Point_3 side = other.center - ball.center;
        const double reach = std::sqrt(dot(side, side));
        const double along = (reach + (ball.radius - other.radius) * (ball.radius + other.radius) / reach) / 2;
        const double height = std::sqrt(std::max(0.0, (ball.radius - along) * (ball.radius + along)));
        expected = std::min(expected, std::hypot(height, along - t * reach));
      }
      if (differ(d, expected))
        return failure() << "edge point " << place(p) << " is at " << d << ", not at " << expected;
    }
  }
  Random random(complex.centers.size());
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    const auto corners = complex.face(f);
    const auto& contacts = complex.contacts[f];
    for (const Point_3& contact : contacts)
      if (!boundary.is_on_boundary(contact, 0.01 * tolerance))
        return failure() << "contact " << place(contact) << " is not on the boundary";
    // That corners are as far from both contacts says that they are in a plane, too.
    for (const int corner : corners)
      for (const Point_3& contact : contacts)
        if (differ(distance(complex.centers[corner], contact), complex.radii[corner]))
          return failure() << "contact " << place(contact) << " is at " << distance(complex.centers[corner], contact)
                           << " from a corner of radius " << complex.radii[corner];
    for (int i = 0; i < 4; ++i) {
      std::vector<double> factors;
      for (std::size_t k = 0; k < corners.size(); ++k) factors.push_back(i == 0 ? 1 : random.unit());
      const Point_3 p = combination(complex, corners, factors);
      if (!boundary.is_inside(p)) return failure() << "face point " << place(p) << " is outside";
      const double d = boundary.distance_to_boundary(p);
      for (const Point_3& contact : contacts)
        if (differ(d, distance(p, contact)))
          return failure() << "face point " << place(p) << " is at " << d << ", its contact " << place(contact)
                           << " at " << distance(p, contact);
    }
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult is_whole(const Axis_3& axis, const Boundary_oracle_3& boundary, int points,
                                  std::uint64_t seed) {
  const auto& balls = axis.dual->regular->balls;
  Random random(seed);
  const double tolerance = 1e-10 * boundary.scale() + 30 * boundary.precision();
  const double near = 1e-4 * boundary.scale() + 1e3 * boundary.precision();
  for (int tried = 0; tried < points; ++tried) {
    const Ball_3& ball = balls[random.index(static_cast<int>(balls.size()))];
    const double x = random.uniform(-0.6, 0.6);
    const double y = random.uniform(-0.6, 0.6);
    const double z = random.uniform(-0.6, 0.6);
    const Point_3 start = ball.center + ball.radius * Point_3{x, y, z};
    if (!boundary.is_inside(start)) continue;
    const Point_3 contact = boundary.nearest(start);
    const double depth = distance(start, contact);
    if (depth <= 1e-3 * boundary.scale()) continue;
    const Point_3 direction = (1 / depth) * (start - contact);
    double low = depth;
    double high = 2 * boundary.scale();
    for (int step = 0; step < 60; ++step) {
      const double t = (low + high) / 2;
      const Point_3 p = contact + t * direction;
      (boundary.is_inside(p) && boundary.distance_to_boundary(p) >= t - tolerance ? low : high) = t;
    }
    const Point_3 end = contact + low * direction;
    if (distance_to_complex(axis.complex, end) <= near) continue;
    // The end may be far from where rounding stopped it when the contacts are near each other.
    const Point_3 beyond = boundary.nearest(contact + (low + 1e-3 * boundary.scale()) * direction);
    if (distance(beyond, contact) < 0.02 * low) continue;
    const std::vector<Point_3>& sites = boundary.vertices();
    std::vector<int> nearest;
    for (int k = 0; k < static_cast<int>(sites.size()); ++k)
      if (distance(sites[k], end) <= low + near) nearest.push_back(k);
    bool is_excused = false;
    bool is_complete = false;
    for (const int a : nearest) {
      for (const int b : nearest) {
        if (b >= a) continue;
        const std::vector<Point_3> face = voronoi_face(sites, a, b, 100 * boundary.scale());
        if (face.empty()) continue;
        double away = std::numeric_limits<double>::infinity();
        for (std::size_t k = 1; k + 1 < face.size(); ++k)
          away = std::min(away, distance_to_triangle(end, face[0], face[k], face[k + 1]));
        if (away > near) continue;
        const bool is_cut = std::ranges::any_of(face, [&](const Point_3& p) {
          return !boundary.is_inside(p) || boundary.distance_to_boundary(p) < distance(p, sites[a]) - tolerance;
        });
        (is_cut ? is_excused : is_complete) = true;
      }
    }
    if (is_complete || !is_excused)
      return failure() << "the axis does not have " << place(end) << " at " << low << " from " << place(contact)
                       << ", above " << place(start) << (is_complete ? "; in a complete face" : "; in no face");
  }
  return testing::AssertionSuccess();
}

std::string to_text(const Topology& topology) {
  std::ostringstream text;
  text << "(" << topology.betti[0] << ", " << topology.betti[1] << ", " << topology.betti[2] << "; " << topology.euler
       << ")";
  return text.str();
}

}  // namespace mesecina::test
