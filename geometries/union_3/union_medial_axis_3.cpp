// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <numeric>
#include <set>
#include <span>

#include "geometries/parallel.h"
#include "geometries/union_3/medial_values_3.h"
#include "geometries/union_3/union_3.h"
#include "geometries/union_3/vertex_voronoi_3.h"

namespace mesecina {

namespace {

/// Faces of the Voronoi diagram, and the edges of the Delaunay triangulation that they are dual to.
struct Voronoi_faces {
  std::vector<std::array<int, 2>> points;
  std::vector<int> offsets{0};
  std::vector<int> nodes;
};

/// Ascending, each once. O(n) for edges between near numbers of vertices.
void sort_edges(std::vector<std::array<int, 2>>& edges, std::size_t vertex_count, Progress& progress) {
  std::vector<int> offsets(vertex_count + 1, 0);
  for (const auto& edge : edges) ++offsets[edge[0] + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> others(edges.size());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (const auto& edge : edges) others[next[edge[0]]++] = edge[1];
  std::vector<int> firsts(vertex_count + 1, 0);
  parallel_for(vertex_count, progress, [&](std::size_t v) {
    const auto begin = others.begin() + offsets[v];
    const auto end = others.begin() + offsets[v + 1];
    std::sort(begin, end);
    firsts[v + 1] = static_cast<int>(std::unique(begin, end) - begin);
  });
  std::partial_sum(firsts.begin(), firsts.end(), firsts.begin());
  edges.resize(firsts.back());
  parallel_for(vertex_count, progress, [&](std::size_t v) {
    for (int e = firsts[v]; e < firsts[v + 1]; ++e)
      edges[e] = {static_cast<int>(v), others[offsets[v] + e - firsts[v]]};
  });
}

class Axis_builder {
 public:
  Axis_builder(const Union_vertices_3& vertices, Vertex_voronoi_3 voronoi, Progress& progress)
      : dual_(*vertices.dual), regular_(*dual_.regular), voronoi_(std::move(voronoi)), progress_(progress) {}

  Medial_complex_3 build() {
    progress_.begin_stage("medial axis of the union");
    result_.face_offsets.push_back(0);
    node_of_ball_.assign(regular_.balls.size(), -1);
    node_of_cell_.assign(voronoi_.cells.size(), -1);
    find_singular_nodes();
    find_voronoi_nodes();
    add_singular_faces();
    add_voronoi_faces();
    add_voronoi_edges();
    add_attachments();
    sort_edges(result_.edges, result_.centers.size(), progress_);
    return std::move(result_);
  }

 private:
  int add_node(const Point_3& center, double radius, int ball) {
    result_.centers.push_back(center);
    result_.radii.push_back(radius);
    result_.balls.push_back(ball);
    return static_cast<int>(result_.centers.size()) - 1;
  }
  void need_ball(int ball) {
    if (node_of_ball_[ball] < 0)
      node_of_ball_[ball] = add_node(regular_.balls[ball].center, regular_.balls[ball].radius, ball);
  }
  void add_edge(int a, int b) {
    if (a != b) result_.edges.push_back({std::min(a, b), std::max(a, b)});
  }

  void find_singular_nodes() {
    for (std::size_t v = 0; v < dual_.vertices.size(); ++v)
      if (dual_.vertices[v] == Simplex_kind_3::singular) need_ball(static_cast<int>(v));
    for (const Dual_3::Edge& edge : dual_.edges)
      if (edge.kind == Simplex_kind_3::singular)
        for (const int ball : edge.balls) need_ball(ball);
    for (const Dual_3::Triangle& triangle : dual_.triangles)
      if (triangle.kind == Simplex_kind_3::singular)
        for (const int ball : triangle.balls) need_ball(ball);
    // These want to be joined to the Voronoi diagram where that has no vertex at them.
    is_loose_.assign(regular_.balls.size(), 0);
    for (const int ball : result_.balls) is_loose_[ball] = 1;
  }

  void find_voronoi_nodes() {
    for (std::size_t c = 0; c < voronoi_.cells.size(); ++c) {
      if (voronoi_.is_inner[c] == 0) continue;
      const int ball = voronoi_.ball_of_cell[c];
      if (ball >= 0) {
        need_ball(ball);
        is_loose_[ball] = 0;
        node_of_cell_[c] = node_of_ball_[ball];
      } else {
        const Point_3& center = voronoi_.centers[c];
        node_of_cell_[c] = add_node(center, distance(center, voronoi_.points[voronoi_.cells[c][0]]), -1);
      }
    }
  }

  void add_face(std::span<const int> nodes, const Point_3& contact, const Point_3& other) {
    result_.face_vertices.insert(result_.face_vertices.end(), nodes.begin(), nodes.end());
    result_.face_offsets.push_back(static_cast<int>(result_.face_vertices.size()));
    result_.contacts.push_back({contact, other});
  }

  void add_singular_faces() {
    for (const Dual_3::Edge& edge : dual_.edges)
      if (edge.kind == Simplex_kind_3::singular) add_edge(node_of_ball_[edge.balls[0]], node_of_ball_[edge.balls[1]]);
    for (const Dual_3::Triangle& triangle : dual_.triangles) {
      if (triangle.kind != Simplex_kind_3::singular) continue;
      std::array<int, 3> nodes{};
      for (int i = 0; i < 3; ++i) nodes[i] = node_of_ball_[triangle.balls[i]];
      const auto contacts = contacts_of(triangle);
      add_face(nodes, contacts[0], contacts[1]);
      for (int i = 0; i < 3; ++i) add_edge(nodes[i], nodes[(i + 1) % 3]);
      std::ranges::sort(nodes);
      singular_.insert(nodes);
    }
  }

  /// The two points on all three spheres.
  std::array<Point_3, 2> contacts_of(const Dual_3::Triangle& triangle) const {
    return {meeting_point(regular_.balls[triangle.balls[0]], regular_.balls[triangle.balls[1]],
                          regular_.balls[triangle.balls[2]], false),
            meeting_point(regular_.balls[triangle.balls[0]], regular_.balls[triangle.balls[1]],
                          regular_.balls[triangle.balls[2]], true)};
  }

  /// Appends what lies around the edge between two places of a cell, if all cells there are inner and this is the first
  /// of them.
  void find_face(int cell, int i, int j, Voronoi_faces& faces) const {
    const int a = voronoi_.cells[cell][i];
    const int b = voronoi_.cells[cell][j];
    const std::size_t begin = faces.nodes.size();
    int current = cell;
    int ahead = -1;
    for (int k = 0; k < 4; ++k)
      if (k != i && k != j) ahead = voronoi_.cells[cell][k];
    do {
      if (current < cell || voronoi_.is_inner[current] == 0) {
        faces.nodes.resize(begin);
        return;
      }
      const int node = node_of_cell_[current];
      if (faces.nodes.size() == begin || faces.nodes.back() != node) faces.nodes.push_back(node);
      const auto& corners = voronoi_.cells[current];
      int kept = -1;
      int place = -1;
      for (int k = 0; k < 4; ++k) {
        if (corners[k] == ahead) place = k;
        if (corners[k] != ahead && corners[k] != a && corners[k] != b) kept = corners[k];
      }
      current = voronoi_.neighbors[current][place];
      ahead = kept;
    } while (current != cell);
    while (faces.nodes.size() > begin + 1 && faces.nodes[begin] == faces.nodes.back()) faces.nodes.pop_back();
    if (faces.nodes.size() < begin + 3 || is_singular(std::span(faces.nodes).subspan(begin))) {
      faces.nodes.resize(begin);
      return;
    }
    faces.points.push_back({a, b});
    faces.offsets.push_back(static_cast<int>(faces.nodes.size()));
  }

  void add_voronoi_faces() {
    const std::size_t count = voronoi_.cells.size();
    constexpr std::size_t block = 16384;
    const std::size_t blocks = (count + block - 1) / block;
    std::vector<Voronoi_faces> found(blocks);
    parallel_blocks(blocks, progress_, [&](std::size_t b) {
      for (std::size_t c = b * block; c < std::min(count, (b + 1) * block); ++c) {
        if (voronoi_.is_inner[c] == 0) continue;
        for (int i = 0; i < 4; ++i)
          for (int j = i + 1; j < 4; ++j) find_face(static_cast<int>(c), i, j, found[b]);
      }
    });
    std::vector<std::size_t> first_faces{result_.contacts.size()};
    std::vector<std::size_t> first_nodes{result_.face_vertices.size()};
    for (const Voronoi_faces& part : found) {
      first_faces.push_back(first_faces.back() + part.points.size());
      first_nodes.push_back(first_nodes.back() + part.nodes.size());
    }
    result_.contacts.resize(first_faces.back());
    result_.face_offsets.resize(first_faces.back() + 1);
    result_.face_vertices.resize(first_nodes.back());
    parallel_blocks(blocks, progress_, [&](std::size_t b) {
      const Voronoi_faces& part = found[b];
      std::ranges::copy(part.nodes, result_.face_vertices.begin() + static_cast<std::ptrdiff_t>(first_nodes[b]));
      for (std::size_t f = 0; f < part.points.size(); ++f) {
        const auto [p, q] = part.points[f];
        result_.contacts[first_faces[b] + f] = {voronoi_.points[p], voronoi_.points[q]};
        result_.face_offsets[first_faces[b] + f + 1] = static_cast<int>(first_nodes[b]) + part.offsets[f + 1];
      }
    });
  }

  /// Between the two vertices of a singular triangle lies the triangle itself.
  bool is_singular(std::span<const int> nodes) const {
    if (nodes.size() != 3 || singular_.empty()) return false;
    std::array<int, 3> three{nodes[0], nodes[1], nodes[2]};
    std::ranges::sort(three);
    return singular_.contains(three);
  }

  /// Those of faces are among them.
  void add_voronoi_edges() {
    const std::size_t count = voronoi_.cells.size();
    constexpr std::size_t block = 65536;
    std::vector<std::vector<std::array<int, 2>>> found((count + block - 1) / block);
    parallel_blocks(found.size(), progress_, [&](std::size_t b) {
      for (std::size_t c = b * block; c < std::min(count, (b + 1) * block); ++c) {
        if (voronoi_.is_inner[c] == 0) continue;
        const int node = node_of_cell_[c];
        for (const int next : voronoi_.neighbors[c]) {
          if (static_cast<int>(c) > next || voronoi_.is_inner[next] == 0 || node_of_cell_[next] == node) continue;
          found[b].push_back({std::min(node, node_of_cell_[next]), std::max(node, node_of_cell_[next])});
        }
      }
    });
    for (const auto& part : found) result_.edges.insert(result_.edges.end(), part.begin(), part.end());
  }

  /// A Voronoi edge that leaves the dual complex ends at the center of the ball on whose sphere its three points lie.
  /// It is wanted where a singular face begins there.
  void add_attachments() {
    if (std::ranges::count(is_loose_, 1) == 0) return;
    const auto may_be_attached = [&](int point) {
      return point >= 0 &&
             std::ranges::any_of(voronoi_.balls_of(point), [&](int ball) { return is_loose_[ball] != 0; });
    };
    for (std::size_t c = 0; c < voronoi_.cells.size(); ++c) {
      // Each facet has one of any two points.
      if (voronoi_.is_inner[c] == 0 ||
          !(may_be_attached(voronoi_.cells[c][0]) || may_be_attached(voronoi_.cells[c][1])))
        continue;
      for (int i = 0; i < 4; ++i) {
        std::array<int, 3> points{};
        for (int k = 0; k < 3; ++k) points[k] = voronoi_.cells[c][(i + 1 + k) % 4];
        voronoi_.for_common_balls(points, [&](int ball) {
          if (is_loose_[ball] == 0) return;
          add_edge(node_of_ball_[ball], node_of_cell_[c]);
          is_loose_[ball] = 0;
        });
      }
    }
  }

  const Dual_3& dual_;
  const Regular_3& regular_;
  const Vertex_voronoi_3 voronoi_;
  Progress& progress_;
  std::vector<int> node_of_ball_;
  std::vector<int> node_of_cell_;
  std::vector<std::uint8_t> is_loose_;  ///< per ball
  std::set<std::array<int, 3>> singular_;
  Medial_complex_3 result_;
};

/// Nearest to p on a planar convex polygon.
Point_3 nearest_on_face(const Medial_complex_3& axis, std::size_t face, const Point_3& p) {
  const auto corners = axis.face(face);
  const Point_3& first = axis.centers[corners.front()];
  Point_3 best = first;
  double least = squared_distance(p, first);
  const auto take = [&](const Point_3& q) {
    const double d = squared_distance(p, q);
    if (d < least) {
      least = d;
      best = q;
    }
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point_3& a = axis.centers[corners[i]];
    const Point_3& b = axis.centers[corners[(i + 1) % corners.size()]];
    const Point_3 along = b - a;
    const double square = dot(along, along);
    if (square > 0) take(a + std::clamp(dot(p - a, along) / square, 0.0, 1.0) * along);
  }
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Point_3 u = axis.centers[corners[i]] - first;
    const Point_3 v = axis.centers[corners[i + 1]] - first;
    const Point_3 n = cross(u, v);
    const double square = dot(n, n);
    if (square == 0) continue;
    const Point_3 w = p - first;
    const double s = dot(cross(w, v), n) / square;
    const double t = dot(cross(u, w), n) / square;
    if (s >= 0 && t >= 0 && s + t <= 1) take(first + s * u + t * v);
  }
  return best;
}

}  // namespace

Medial_complex_3 union_medial_axis(const Union_vertices_3& vertices, Progress& progress) {
  Vertex_voronoi_3 voronoi = vertex_voronoi(vertices, progress);
  return Axis_builder(vertices, std::move(voronoi), progress).build();
}

Loose_parts_3 loose_parts(const Medial_complex_3& complex) {
  Progress progress;
  return loose_parts(complex, progress);
}

Loose_parts_3 loose_parts(const Medial_complex_3& complex, Progress& progress) {
  std::vector<std::uint8_t> has_face(complex.edges.size(), 0);
  for (const int edge : edges_of_faces(complex, progress)) has_face[edge] = 1;
  std::vector<std::uint8_t> has_edge(complex.centers.size(), 0);
  Loose_parts_3 parts;
  for (std::size_t e = 0; e < has_face.size(); ++e) {
    const auto& [a, b] = complex.edges[e];
    if (has_face[e] == 0) parts.edges.push_back({a, b});
    has_edge[a] = has_edge[b] = 1;
  }
  for (std::size_t v = 0; v < has_edge.size(); ++v)
    if (has_edge[v] == 0) parts.vertices.push_back(static_cast<int>(v));
  return parts;
}

std::vector<double> lambda_of_faces(const Medial_complex_3& axis) {
  std::vector<double> lambda;
  lambda.reserve(axis.face_count());
  for (const auto& [p, q] : axis.contacts) lambda.push_back(distance(p, q) / 2);
  return lambda;
}

std::vector<double> angle_of_faces(const Medial_complex_3& axis, Progress& progress) {
  std::vector<double> angles(axis.face_count());
  parallel_for(axis.face_count(), progress, [&](std::size_t f) {
    const auto& [p, q] = axis.contacts[f];
    const Point_3 middle = midpoint(p, q);
    const double height = distance(middle, nearest_on_face(axis, f, middle));
    angles[f] = 2 * std::atan2(distance(p, q) / 2, height) * 180 / std::numbers::pi;
  });
  return angles;
}

}  // namespace mesecina
