// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/union_surface_3.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometries/parallel.h"
#include "geometries/surface_3/closed_mesh_3.h"
#include "geometries/surface_3/sphere_patch_3.h"

namespace mesecina {

namespace {

/// Of the tolerance: for chords beside arcs, and again for triangles below spheres. What is left is for short edges.
constexpr double part_of_deviation = 0.45;
constexpr double part_of_short_edges = 0.1;
/// How often arcs are halved where chords of a patch cross.
constexpr int most_rounds = 5;
constexpr std::size_t block = 256;

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

  void triangulate() {
    const std::size_t count = boundary_.patch_count();
    meshes_.resize(count);
    std::vector<std::uint8_t> is_open(count, 1);
    for (int round = 0;; ++round) {
      std::vector<int> todo;
      for (std::size_t p = 0; p < count; ++p)
        if (is_open[p] != 0) todo.push_back(static_cast<int>(p));
      std::vector<std::uint8_t> has_failed(todo.size(), 0);
      parallel_blocks((todo.size() + block - 1) / block, progress_, [&](std::size_t b) {
        for (std::size_t i = b * block; i < std::min(todo.size(), (b + 1) * block); ++i) {
          auto mesh = triangulated(todo[i]);
          has_failed[i] = mesh ? 0 : 1;
          if (mesh) {
            meshes_[todo[i]] = std::move(*mesh);
          } else if (round == most_rounds) {
            meshes_[todo[i]] = fill_patch(outline(todo[i]));
          }
        }
      });
      const auto failures = std::ranges::count(has_failed, 1);
      if (round == most_rounds) result_.folded_patches = static_cast<std::size_t>(failures);
      if (failures == 0 || round == most_rounds) return;
      std::vector<std::uint8_t> is_halved(steps_.size(), 0);
      for (std::size_t i = 0; i < todo.size(); ++i) {
        if (has_failed[i] == 0) continue;
        for_each_side(todo[i], [&](const Union_boundary_3::Side& side) { is_halved[side.arc] = 1; });
      }
      for (std::size_t a = 0; a < steps_.size(); ++a) steps_[a] *= 1 + is_halved[a];
      for (std::size_t p = 0; p < count; ++p) {
        is_open[p] = 0;
        for_each_side(static_cast<int>(p),
                      [&](const Union_boundary_3::Side& side) { is_open[p] |= is_halved[side.arc]; });
      }
    }
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
    double deepest = 2;
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
        if (height < deepest) {
          deepest = height;
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
  }

  const Union_boundary_3& boundary_;
  double deviation_;
  double tolerance_;
  Progress& progress_;
  std::vector<int> steps_;  ///< per arc
  std::vector<Patch_mesh_3> meshes_;
  Union_surface_3 result_;
};

}  // namespace

Union_surface_3 union_surface(std::shared_ptr<const Dual_3> dual, double tolerance, Progress& progress) {
  const Union_boundary_3 boundary = union_boundary(std::move(dual), progress);
  return Surface_builder(boundary, tolerance, progress).build();
}

}  // namespace mesecina
