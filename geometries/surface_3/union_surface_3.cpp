// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/union_surface_3.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "geometries/parallel.h"
#include "geometries/surface_3/closed_mesh_3.h"
#include "geometries/surface_3/sphere_patch_3.h"

namespace mesecina {

namespace {

/// Of the tolerance: for chords beside arcs, and again for triangles below spheres. What is left is for short edges.
constexpr double part_of_deviation = 0.5;
constexpr double part_of_short_edges = 1e-9;
/// How often an arc is halved where chords of a patch cross.
constexpr std::uint8_t most_halvings = 8;
constexpr std::size_t block = 256;

double distance_to_segment(const Point_3& p, const Point_3& a, const Point_3& b) {
  const Point_3 along = b - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return distance(p, a + t * along);
}

double distance_to_triangle(const Point_3& p, const std::array<Point_3, 3>& corners) {
  const Point_3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  double least = std::numeric_limits<double>::infinity();
  bool is_above = dot(normal, normal) > 0;
  for (int i = 0; i < 3; ++i) {
    const Point_3& a = corners[i];
    const Point_3& b = corners[(i + 1) % 3];
    is_above = is_above && dot(cross(normal, b - a), p - a) >= 0;
    least = std::min(least, distance_to_segment(p, a, b));
  }
  return is_above ? std::abs(dot(normal, p - corners[0])) / std::sqrt(dot(normal, normal)) : least;
}

class Surface_builder {
 public:
  Surface_builder(const Union_boundary_3& boundary, double tolerance, Progress& progress)
      : boundary_(boundary), deviation_(part_of_deviation * tolerance), tolerance_(tolerance), progress_(progress) {}

  Union_surface_3 build() {
    progress_.begin_stage("surface of the union");
    divide_arcs();
    triangulate();
    assemble();
    return std::move(result_);
  }

 private:
  /// Steps per arc, so that arcs between the same two vertices are not one edge.
  void divide_arcs() {
    steps_.resize(boundary_.arcs.size());
    struct Chord {
      int from;
      int to;
      int arc;
    };
    std::vector<Chord> chords;
    for (std::size_t a = 0; a < steps_.size(); ++a) {
      const auto& arc = boundary_.arcs[a];
      const double longest =
          2 * std::acos(std::max(std::numbers::sqrt2 / 2, 1 - deviation_ / std::max(arc.radius, deviation_)));
      steps_[a] = std::max(1, static_cast<int>(std::ceil(arc.angle / longest)));
      if (arc.from < 0) steps_[a] = std::max(steps_[a], 4);
      if (steps_[a] == 1)
        chords.push_back({std::min(arc.from, arc.to), std::max(arc.from, arc.to), static_cast<int>(a)});
    }
    const auto key = [](const Chord& c) { return std::array<int, 3>{c.from, c.to, c.arc}; };
    std::ranges::sort(chords, {}, key);
    for (std::size_t i = 1; i < chords.size(); ++i) {
      if (chords[i].from != chords[i - 1].from || chords[i].to != chords[i - 1].to) continue;
      steps_[chords[i].arc] = steps_[chords[i - 1].arc] = 2;
    }
  }

  /// Where chords cross, arcs are halved and patches on both sides are triangulated again.
  void triangulate() {
    const std::size_t count = boundary_.patch_count();
    meshes_.resize(count);
    halvings_.assign(steps_.size(), 0);
    std::vector<std::uint8_t> is_filled(count, 0);
    std::vector<int> open(count);
    std::iota(open.begin(), open.end(), 0);
    while (!open.empty()) {
      std::vector<std::uint8_t> has_failed(open.size(), 0);
      parallel_blocks((open.size() + block - 1) / block, progress_, [&](std::size_t b) {
        for (std::size_t i = b * block; i < std::min(open.size(), (b + 1) * block); ++i) {
          auto mesh = triangulated(open[i]);
          has_failed[i] = mesh ? 0 : 1;
          if (mesh) meshes_[open[i]] = std::move(*mesh);
        }
      });
      std::vector<std::uint8_t> is_halved(steps_.size(), 0);
      for (std::size_t i = 0; i < open.size(); ++i) {
        is_filled[open[i]] = 0;
        if (has_failed[i] == 0 || choose_arcs(open[i], is_halved)) continue;
        is_filled[open[i]] = 1;
        meshes_[open[i]] = fill_patch(outline(open[i]));
      }
      for (std::size_t a = 0; a < steps_.size(); ++a) {
        steps_[a] *= 1 + is_halved[a];
        halvings_[a] += is_halved[a];
      }
      open.clear();
      for (std::size_t p = 0; p < count; ++p) {
        bool is_touched = false;
        for_each_side(static_cast<int>(p),
                      [&](const Union_boundary_3::Side& side) { is_touched = is_touched || is_halved[side.arc] != 0; });
        if (is_touched) open.push_back(static_cast<int>(p));
      }
    }
    result_.folded_patches = static_cast<std::size_t>(std::ranges::count(is_filled, 1));
  }

  /// Of the arcs around the patch those whose chords are farthest from them; false when they were halved often enough,
  /// or the difference is nothing.
  bool choose_arcs(int patch, std::vector<std::uint8_t>& is_halved) const {
    constexpr double comparable = 0.25;
    constexpr double negligible = 1e-9;
    double most = 0;
    for_each_side(patch, [&](const Union_boundary_3::Side& side) {
      if (halvings_[side.arc] < most_halvings) most = std::max(most, sagitta(side.arc));
    });
    if (most < negligible * tolerance_) return false;
    for_each_side(patch, [&](const Union_boundary_3::Side& side) {
      if (halvings_[side.arc] < most_halvings && sagitta(side.arc) >= comparable * most) is_halved[side.arc] = 1;
    });
    return true;
  }

  template <class Body>
  void for_each_side(int patch, const Body& body) const {
    for (int l = boundary_.patch_offsets[patch]; l < boundary_.patch_offsets[patch + 1]; ++l)
      for (const auto& side : boundary_.loop(l)) body(side);
  }

  std::optional<Patch_mesh_3> triangulated(int patch) const {
    const Ball_3& ball = boundary_.dual->regular->balls[boundary_.patch_balls[patch]];
    if (boundary_.patch_offsets[patch] == boundary_.patch_offsets[patch + 1])
      return triangulate_sphere(ball, deviation_);
    return triangulate_patch(outline(patch), deviation_);
  }

  Sphere_patch_3 outline(int patch) const {
    Sphere_patch_3 result;
    const int number = boundary_.patch_balls[patch];
    result.ball = boundary_.dual->regular->balls[number];
    // Around it, the largest part of the sphere is in one other ball.
    result.cosine = 2;
    for (int l = boundary_.patch_offsets[patch]; l < boundary_.patch_offsets[patch + 1]; ++l) {
      result.loops.emplace_back();
      for (const auto& side : boundary_.loop(l)) {
        const auto& arc = boundary_.arcs[side.arc];
        const int n = steps_[side.arc];
        if (arc.from >= 0) result.loops.back().push_back(boundary_.vertices[side.is_forward ? arc.from : arc.to]);
        for (int k = arc.from >= 0 ? 1 : 0; k < n; ++k)
          result.loops.back().push_back(arc.point((side.is_forward ? k : n - k) % n, n));
        const auto& balls = boundary_.dual->regular->balls;
        const Point_3 toward = balls[arc.balls[0] == number ? arc.balls[1] : arc.balls[0]].center - result.ball.center;
        const double apart = std::sqrt(dot(toward, toward));
        const double height = dot(arc.center - result.ball.center, toward) / (apart * result.ball.radius);
        if (height < result.cosine) {
          result.cosine = height;
          result.pole = (1 / apart) * toward;
        }
      }
    }
    return result;
  }

  /// Vertices of the union first, then points of arcs, then inner points.
  void assemble() {
    Triangle_mesh_3& mesh = result_.mesh;
    mesh.vertices = boundary_.vertices;
    std::vector<int> first_of_arc(steps_.size());
    for (std::size_t a = 0; a < steps_.size(); ++a) {
      const auto& arc = boundary_.arcs[a];
      first_of_arc[a] = static_cast<int>(mesh.vertices.size());
      for (int k = arc.from >= 0 ? 1 : 0; k < steps_[a]; ++k) mesh.vertices.push_back(arc.point(k, steps_[a]));
    }
    std::vector<int> patch_of_triangle;
    std::vector<int> names;
    for (std::size_t p = 0; p < meshes_.size(); ++p) {
      names.clear();
      for_each_side(static_cast<int>(p), [&](const Union_boundary_3::Side& side) {
        const auto& arc = boundary_.arcs[side.arc];
        const int n = steps_[side.arc];
        const bool is_circle = arc.from < 0;
        if (!is_circle) names.push_back(side.is_forward ? arc.from : arc.to);
        for (int k = is_circle ? 0 : 1; k < n; ++k) {
          const int step = side.is_forward ? k : n - k;
          names.push_back(first_of_arc[side.arc] + (is_circle ? step % n : step - 1));
        }
      });
      for (const Point_3& point : meshes_[p].inner_points) {
        names.push_back(static_cast<int>(mesh.vertices.size()));
        mesh.vertices.push_back(point);
      }
      for (const auto& [a, b, c] : meshes_[p].triangles) {
        mesh.triangles.push_back({names[a], names[b], names[c]});
        patch_of_triangle.push_back(static_cast<int>(p));
      }
      meshes_[p] = {};
    }
    split_double_edges(mesh, patch_of_triangle, [&](int patch, const Point_3& p) {
      const Ball_3& ball = boundary_.dual->regular->balls[boundary_.patch_balls[patch]];
      const Point_3 direction = p - ball.center;
      const double size = std::sqrt(dot(direction, direction));
      return size > 0 ? ball.center + (ball.radius / size) * direction : p;
    });
    collapse_short_edges(mesh, patch_of_triangle, part_of_short_edges * tolerance_, progress_);
    result_.ball_of_triangle.reserve(patch_of_triangle.size());
    for (const int patch : patch_of_triangle) result_.ball_of_triangle.push_back(boundary_.patch_balls[patch]);
    measure();
  }

  void measure() {
    double of_arcs = 0;
    for (std::size_t a = 0; a < steps_.size(); ++a) of_arcs = std::max(of_arcs, sagitta(static_cast<int>(a)));
    double of_triangles = 0;
    for (std::size_t t = 0; t < result_.mesh.triangles.size(); ++t) {
      const auto& [center, radius] = boundary_.dual->regular->balls[result_.ball_of_triangle[t]];
      const auto& [a, b, c] = result_.mesh.triangles[t];
      const auto& points = result_.mesh.vertices;
      of_triangles = std::max(of_triangles, radius - distance_to_triangle(center, {points[a], points[b], points[c]}));
    }
    result_.deviation = of_arcs + of_triangles;
  }

  /// How far the chords of an arc are from it.
  double sagitta(int arc) const {
    const double half = std::sin(boundary_.arcs[arc].angle / (4 * steps_[arc]));
    return 2 * boundary_.arcs[arc].radius * half * half;
  }

  const Union_boundary_3& boundary_;
  double deviation_;
  double tolerance_;
  Progress& progress_;
  std::vector<int> steps_;              ///< per arc
  std::vector<std::uint8_t> halvings_;  ///< per arc
  std::vector<Patch_mesh_3> meshes_;
  Union_surface_3 result_;
};

}  // namespace

Union_surface_3 union_surface(std::shared_ptr<const Dual_3> dual, double tolerance, Progress& progress) {
  const Union_boundary_3 boundary = union_boundary(std::move(dual), progress);
  return Surface_builder(boundary, tolerance, progress).build();
}

}  // namespace mesecina
