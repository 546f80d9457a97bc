// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/closed_mesh_3.h"

#include <algorithm>
#include <array>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <tuple>
#include <utility>

namespace mesecina {

namespace {

struct Side {
  int from;  ///< the lesser vertex
  int to;
  int triangle;
  auto operator<=>(const Side&) const = default;
};

std::vector<Side> sorted_sides(const Triangle_mesh_3& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corners = mesh.triangles[t];
    for (int i = 0; i < 3; ++i) {
      const int a = corners[i];
      const int b = corners[(i + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t)});
    }
  }
  std::ranges::sort(sides);
  return sides;
}

/// Replaces the corner `old` of the triangle by `other`.
void replace(std::array<int, 3>& triangle, int old, int other) { std::ranges::replace(triangle, old, other); }

/// Both triangles at an edge inside a piece become two each.
struct Split {
  int from;
  int to;
  std::array<int, 2> triangles;
};

/// The edges to split now, of each triangle at most one.
std::vector<Split> double_edges(const Triangle_mesh_3& mesh, const std::vector<int>& piece_of_triangle) {
  const std::vector<Side> sides = sorted_sides(mesh);
  std::vector<Split> splits;
  std::vector<std::uint8_t> is_taken(mesh.triangles.size(), 0);
  const auto is_same_triangle = [&](int s, int t) {
    auto a = mesh.triangles[s];
    auto b = mesh.triangles[t];
    std::ranges::sort(a);
    std::ranges::sort(b);
    return a == b;
  };
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    while (end < sides.size() && sides[end].from == sides[begin].from && sides[end].to == sides[begin].to) ++end;
    if (end - begin > 2) {
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t j = i + 1; j < end; ++j) {
          const int s = sides[i].triangle;
          const int t = sides[j].triangle;
          if (piece_of_triangle[s] != piece_of_triangle[t] || is_taken[s] != 0 || is_taken[t] != 0) continue;
          is_taken[s] = is_taken[t] = 1;
          splits.push_back({sides[i].from, sides[i].to, {s, t}});
        }
      }
    } else if (end - begin == 2 && is_same_triangle(sides[begin].triangle, sides[begin + 1].triangle)) {
      const int s = sides[begin].triangle;
      if (is_taken[s] == 0) splits.push_back({sides[begin].from, sides[begin].to, {s, -1}});
      is_taken[s] = 1;
    }
    begin = end;
  }
  return splits;
}

class Edge_collapser {
 public:
  Edge_collapser(Triangle_mesh_3& mesh, double limit, Progress& progress)
      : mesh_(mesh),
        limit_(limit),
        progress_(progress),
        triangles_(mesh.vertices.size()),
        drift_(mesh.vertices.size(), 0.0) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const int v : mesh.triangles[t]) triangles_[v].push_back(static_cast<int>(t));
  }

  /// How many edges were contracted.
  std::size_t pass() {
    struct Short_edge {
      double length;
      int from;
      int to;
    };
    std::vector<Short_edge> edges;
    for (const auto& corners : mesh_.triangles) {
      for (int i = 0; i < 3; ++i) {
        const int a = corners[i];
        const int b = corners[(i + 1) % 3];
        // Each edge once: the other triangle has it the other way round.
        if (a >= b) continue;
        if (const double d = distance(mesh_.vertices[a], mesh_.vertices[b]); d < limit_) edges.push_back({d, a, b});
      }
    }
    const auto key = [](const Short_edge& e) { return std::tuple(e.length, e.from, e.to); };
    std::ranges::sort(edges, {}, key);
    std::size_t count = 0;
    constexpr std::size_t block = 4096;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (i % block == 0) progress_.check();
      count += static_cast<std::size_t>(collapse(edges[i].from, edges[i].to));
    }
    return count;
  }

 private:
  bool collapse(int from, int to) {
    if (triangles_[from].empty() || triangles_[to].empty()) return false;
    const double length = distance(mesh_.vertices[from], mesh_.vertices[to]);
    if (!has_link_condition(from, to)) return false;
    return merge(to, from, length) || merge(from, to, length);
  }

  /// The vertices around both ends are the same two that are across from the edge, and more is there than a
  /// tetrahedron.
  bool has_link_condition(int from, int to) {
    around_.clear();
    for (const int t : triangles_[from])
      for (const int v : mesh_.triangles[t])
        if (v != from) around_.push_back(v);
    std::ranges::sort(around_);
    if (!std::ranges::binary_search(around_, to)) return false;
    if (triangles_[from].size() + triangles_[to].size() <= 6) return false;
    common_.clear();
    for (const int t : triangles_[to])
      for (const int v : mesh_.triangles[t])
        if (v != to && v != from && std::ranges::binary_search(around_, v)) common_.push_back(v);
    std::ranges::sort(common_);
    common_.erase(std::unique(common_.begin(), common_.end()), common_.end());
    return common_.size() == 2;
  }

  Point_3 normal(const std::array<int, 3>& triangle) const {
    const Point_3& a = mesh_.vertices[triangle[0]];
    return cross(mesh_.vertices[triangle[1]] - a, mesh_.vertices[triangle[2]] - a);
  }

  bool is_small(const std::array<int, 3>& triangle) const {
    for (int i = 0; i < 3; ++i)
      if (squared_distance(mesh_.vertices[triangle[i]], mesh_.vertices[triangle[(i + 1) % 3]]) >= limit_ * limit_)
        return false;
    return true;
  }

  /// `gone` becomes `kept`; false when a triangle would turn over.
  bool merge(int gone, int kept, double length) {
    if (drift_[gone] + length > limit_) return false;
    for (const int t : triangles_[gone]) {
      auto triangle = mesh_.triangles[t];
      if (std::ranges::count(triangle, kept) != 0) continue;
      const Point_3 before = normal(triangle);
      replace(triangle, gone, kept);
      const Point_3 after = normal(triangle);
      // Triangles with all sides shorter than the limit may lie as they like.
      constexpr double most_turn = 0.5;
      if (dot(before, after) <= most_turn * std::sqrt(dot(before, before) * dot(after, after)) &&
          !(is_small(mesh_.triangles[t]) && is_small(triangle)))
        return false;
    }
    drift_[kept] = std::max(drift_[kept], drift_[gone] + length);
    for (const int t : triangles_[gone]) {
      auto& triangle = mesh_.triangles[t];
      if (std::ranges::count(triangle, kept) == 0) {
        replace(triangle, gone, kept);
        triangles_[kept].push_back(t);
        continue;
      }
      for (const int v : triangle)
        if (v != gone) triangles_[v].erase(std::ranges::find(triangles_[v], t));
      triangle.fill(-1);
    }
    triangles_[gone].clear();
    return true;
  }

  Triangle_mesh_3& mesh_;
  double limit_;
  Progress& progress_;
  std::vector<boost::container::small_vector<int, 8>> triangles_;  ///< per vertex
  std::vector<double> drift_;                                      ///< per vertex, how far away is what it stands for
  std::vector<int> around_;
  std::vector<int> common_;
};

void remove_unused(Triangle_mesh_3& mesh, std::vector<int>& piece_of_triangle) {
  std::vector<int> renumbered(mesh.vertices.size(), -1);
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangles[t][0] < 0) continue;
    for (const int v : mesh.triangles[t]) renumbered[v] = 0;
    piece_of_triangle[kept] = piece_of_triangle[t];
    mesh.triangles[kept++] = mesh.triangles[t];
  }
  mesh.triangles.resize(kept);
  piece_of_triangle.resize(kept);
  int next = 0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (renumbered[v] < 0) continue;
    mesh.vertices[next] = mesh.vertices[v];
    renumbered[v] = next++;
  }
  mesh.vertices.resize(next);
  for (auto& triangle : mesh.triangles)
    for (int& v : triangle) v = renumbered[v];
}

}  // namespace

void split_double_edges(Triangle_mesh_3& mesh, std::vector<int>& piece_of_triangle,
                        const std::function<Point_3(int piece, const Point_3& middle)>& place) {
  for (;;) {
    const std::vector<Split> splits = double_edges(mesh, piece_of_triangle);
    if (splits.empty()) return;
    for (const auto& [from, to, triangles] : splits) {
      const int middle = static_cast<int>(mesh.vertices.size());
      const int piece = piece_of_triangle[triangles[0]];
      if (triangles[1] < 0) {
        const auto [a, b, c] = mesh.triangles[triangles[0]];
        mesh.vertices.push_back(place(piece, (1.0 / 3) * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c])));
        mesh.triangles[triangles[0]] = {a, b, middle};
        mesh.triangles.push_back({b, c, middle});
        mesh.triangles.push_back({c, a, middle});
        piece_of_triangle.insert(piece_of_triangle.end(), 2, piece);
        continue;
      }
      mesh.vertices.push_back(place(piece, midpoint(mesh.vertices[from], mesh.vertices[to])));
      for (const int t : triangles) {
        auto half = mesh.triangles[t];
        replace(half, from, middle);
        replace(mesh.triangles[t], to, middle);
        mesh.triangles.push_back(half);
        piece_of_triangle.push_back(piece);
      }
    }
  }
}

void collapse_short_edges(Triangle_mesh_3& mesh, std::vector<int>& piece_of_triangle, double limit,
                          Progress& progress) {
  Edge_collapser collapser(mesh, limit, progress);
  constexpr int most_passes = 8;
  for (int pass = 0; pass < most_passes; ++pass)
    if (collapser.pass() == 0) break;
  remove_unused(mesh, piece_of_triangle);
}

}  // namespace mesecina
