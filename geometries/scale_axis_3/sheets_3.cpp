// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

#include "core/disjoint_sets.h"
#include "geometries/parallel.h"
#include "geometries/scale_axis_3/scale_axis_3.h"

namespace mesecina {

namespace {

/// Which edges each face has and which faces each edge, and how many edges each vertex.
struct Incidences {
  Incidences(const Medial_complex_3& complex, Progress& progress)
      : edges_of_faces(mesecina::edges_of_faces(complex, progress)) {
    face_offsets.assign(complex.edges.size() + 1, 0);
    edge_degrees.assign(complex.centers.size(), 0);
    for (const int edge : edges_of_faces) ++face_offsets[edge + 1];
    std::partial_sum(face_offsets.begin(), face_offsets.end(), face_offsets.begin());
    faces_of_edges.resize(edges_of_faces.size());
    std::vector<int> next(face_offsets.begin(), face_offsets.end() - 1);
    for (std::size_t f = 0; f < complex.face_count(); ++f)
      for (const int e : edges_of(complex, static_cast<int>(f))) faces_of_edges[next[e]++] = static_cast<int>(f);
    for (const auto& ends : complex.edges)
      for (const int v : ends) ++edge_degrees[v];
  }
  std::span<const int> edges_of(const Medial_complex_3& complex, int face) const {
    return std::span(edges_of_faces)
        .subspan(complex.face_offsets[face], complex.face_offsets[face + 1] - complex.face_offsets[face]);
  }
  std::span<const int> faces_of(int edge) const {
    return std::span(faces_of_edges).subspan(face_offsets[edge], face_offsets[edge + 1] - face_offsets[edge]);
  }

  std::vector<int> edges_of_faces;
  std::vector<int> face_offsets;
  std::vector<int> faces_of_edges;
  std::vector<int> edge_degrees;  ///< per vertex
};

/// Numbered by their first faces.
Sheets_3 sheets_of(const Medial_complex_3& complex, const Incidences& incidences) {
  Disjoint_sets sets(complex.face_count());
  for (std::size_t e = 0; e < complex.edges.size(); ++e)
    if (const auto faces = incidences.faces_of(static_cast<int>(e)); faces.size() == 2) sets.join(faces[0], faces[1]);
  Sheets_3 result;
  result.sheet_of_face.reserve(complex.face_count());
  for (int f = 0; f < static_cast<int>(complex.face_count()); ++f) {
    const int first = sets.find(f);
    result.sheet_of_face.push_back(first == f ? result.count++ : result.sheet_of_face[first]);
  }
  return result;
}

/// Removes sheets from a complex, whole ones, by collapses only.
class Pruner {
 public:
  Pruner(const Medial_complex_3& complex, const std::vector<double>& angles, Progress& progress)
      : complex_(complex),
        incidences_(complex, progress),
        has_face_(complex.face_count(), 1),
        has_edge_(complex.edges.size(), 1),
        has_vertex_(complex.centers.size(), 1),
        edge_degrees_(incidences_.edge_degrees) {
    face_degrees_.reserve(complex.edges.size());
    for (std::size_t e = 0; e < complex.edges.size(); ++e)
      face_degrees_.push_back(static_cast<int>(incidences_.faces_of(static_cast<int>(e)).size()));
    Sheets_3 parts = sheets_of(complex, incidences_);
    sheet_of_face_ = std::move(parts.sheet_of_face);
    faces_.resize(parts.count);
    sheet_angles_.assign(parts.count, 0);
    for (std::size_t f = 0; f < complex.face_count(); ++f) {
      faces_[sheet_of_face_[f]].push_back(static_cast<int>(f));
      sheet_angles_[sheet_of_face_[f]] = std::max(sheet_angles_[sheet_of_face_[f]], angles[f]);
    }
  }

  void prune(double min_angle, Progress& progress) {
    using Item = std::pair<double, int>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    for (std::size_t s = 0; s < faces_.size(); ++s)
      if (sheet_angles_[s] < min_angle) queue.push({sheet_angles_[s], static_cast<int>(s)});
    while (!queue.empty()) {
      progress.check();
      const auto [angle, sheet] = queue.top();
      queue.pop();
      if (faces_[sheet].empty() || angle != sheet_angles_[sheet] || !remove(sheet)) continue;
      for (const int joined : join_across_seams(sheet))
        if (sheet_angles_[joined] < min_angle) queue.push({sheet_angles_[joined], joined});
      faces_[sheet].clear();
    }
  }

  Pruned_complex_3 result(Progress& progress) const {
    Pruned_complex_3 pruned;
    Medial_complex_3& result = pruned.complex;
    std::vector<int> renamed(complex_.centers.size(), -1);
    const auto take_vertices = [&] {
      const auto count = static_cast<std::size_t>(std::ranges::count(has_vertex_, 1));
      result.centers.reserve(count);
      result.radii.reserve(count);
      result.balls.reserve(count);
      for (std::size_t v = 0; v < renamed.size(); ++v) {
        if (has_vertex_[v] == 0) continue;
        renamed[v] = static_cast<int>(result.centers.size());
        result.centers.push_back(complex_.centers[v]);
        result.radii.push_back(complex_.radii[v]);
        result.balls.push_back(complex_.balls[v]);
      }
    };
    const auto take_faces = [&] {
      const auto count = static_cast<std::size_t>(std::ranges::count(has_face_, 1));
      pruned.faces.reserve(count);
      pruned.sheets.sheet_of_face.reserve(count);
      result.contacts.reserve(count);
      result.face_offsets.reserve(count + 1);
      result.face_offsets.push_back(0);
      std::vector<int> renumbered(faces_.size(), -1);
      for (std::size_t f = 0; f < has_face_.size(); ++f) {
        if (has_face_[f] == 0) continue;
        pruned.faces.push_back(static_cast<int>(f));
        int& sheet = renumbered[sheet_of_face_[f]];
        if (sheet < 0) sheet = pruned.sheets.count++;
        pruned.sheets.sheet_of_face.push_back(sheet);
        result.face_offsets.push_back(result.face_offsets.back() + static_cast<int>(complex_.face(f).size()));
        result.contacts.push_back(complex_.contacts[f]);
      }
      result.face_vertices.resize(result.face_offsets.back());
    };
    at_once(progress, take_faces, take_vertices);
    const auto take_edges = [&] {
      result.edges.reserve(static_cast<std::size_t>(std::ranges::count(has_edge_, 1)));
      for (std::size_t e = 0; e < has_edge_.size(); ++e)
        if (has_edge_[e] != 0) result.edges.push_back({renamed[complex_.edges[e][0]], renamed[complex_.edges[e][1]]});
    };
    const auto take_corners = [&] {
      for (std::size_t f = 0; f < pruned.faces.size(); ++f)
        std::ranges::transform(complex_.face(pruned.faces[f]), result.face_vertices.begin() + result.face_offsets[f],
                               [&](int v) { return renamed[v]; });
    };
    at_once(progress, take_corners, take_edges);
    return pruned;
  }

 private:
  bool remove(int sheet) {
    removed_faces_.clear();
    removed_edges_.clear();
    removed_vertices_.clear();
    std::vector<int>& free_edges = edge_buffer_;
    free_edges.clear();
    for (const int f : faces_[sheet])
      for (const int e : incidences_.edges_of(complex_, f))
        if (face_degrees_[e] == 1) free_edges.push_back(e);
    while (!free_edges.empty()) {
      const int e = free_edges.back();
      free_edges.pop_back();
      if (has_edge_[e] == 0 || face_degrees_[e] != 1) continue;
      const int f = only_face_of(e);
      if (sheet_of_face_[f] != sheet) continue;
      take_face(f);
      take_edge(e);
      for (const int other : incidences_.edges_of(complex_, f))
        if (has_edge_[other] != 0 && face_degrees_[other] == 1) free_edges.push_back(other);
    }
    const bool is_whole = removed_faces_.size() == faces_[sheet].size() && take_remaining_edges(sheet);
    if (!is_whole) put_back();
    return is_whole;
  }

  /// Edges of the sheet that no face has any more, from free vertices on. False when some are left.
  bool take_remaining_edges(int sheet) {
    std::vector<int>& left = edge_buffer_;
    left.clear();
    for (const int f : faces_[sheet])
      for (const int e : incidences_.edges_of(complex_, f))
        if (has_edge_[e] != 0 && face_degrees_[e] == 0) left.push_back(e);
    std::ranges::sort(left);
    left.erase(std::unique(left.begin(), left.end()), left.end());
    std::size_t taken = 0;
    std::vector<int>& open = open_;
    open.clear();
    const auto free_end = [&](int e) {
      const auto& ends = complex_.edges[e];
      return edge_degrees_[ends[0]] == 1 ? ends[0] : edge_degrees_[ends[1]] == 1 ? ends[1] : -1;
    };
    std::vector<std::pair<int, int>>& edges_at = edges_at_;
    edges_at.clear();
    for (const int e : left) {
      for (const int v : complex_.edges[e]) edges_at.emplace_back(v, e);
      if (free_end(e) >= 0) open.push_back(e);
    }
    std::ranges::sort(edges_at);
    while (!open.empty()) {
      const int e = open.back();
      open.pop_back();
      const int free = has_edge_[e] != 0 ? free_end(e) : -1;
      if (free < 0) continue;
      take_edge(e);
      has_vertex_[free] = 0;
      removed_vertices_.push_back(free);
      ++taken;
      const int other = complex_.edges[e][complex_.edges[e][0] == free ? 1 : 0];
      if (edge_degrees_[other] == 1)
        for (auto at = std::lower_bound(edges_at.begin(), edges_at.end(), std::pair(other, 0));
             at != edges_at.end() && at->first == other; ++at)
          if (has_edge_[at->second] != 0) open.push_back(at->second);
    }
    return taken == left.size();
  }

  int only_face_of(int edge) const {
    for (const int f : incidences_.faces_of(edge))
      if (has_face_[f] != 0) return f;
    return -1;
  }
  void take_face(int f) {
    has_face_[f] = 0;
    removed_faces_.push_back(f);
    for (const int e : incidences_.edges_of(complex_, f)) --face_degrees_[e];
  }
  void take_edge(int e) {
    has_edge_[e] = 0;
    removed_edges_.push_back(e);
    for (const int v : complex_.edges[e]) --edge_degrees_[v];
  }
  void put_back() {
    for (const int v : removed_vertices_) has_vertex_[v] = 1;
    for (const int e : removed_edges_) {
      has_edge_[e] = 1;
      for (const int v : complex_.edges[e]) ++edge_degrees_[v];
    }
    for (const int f : removed_faces_) {
      has_face_[f] = 1;
      for (const int e : incidences_.edges_of(complex_, f)) ++face_degrees_[e];
    }
  }

  /// Sheets that have become one since this one went, by the numbers under which they go on.
  std::vector<int> join_across_seams(int gone) {
    std::vector<int> joined;
    for (const int f : faces_[gone]) {
      for (const int e : incidences_.edges_of(complex_, f)) {
        if (has_edge_[e] == 0 || face_degrees_[e] != 2) continue;
        std::array<int, 2> two{};
        int found = 0;
        for (const int other : incidences_.faces_of(e))
          if (has_face_[other] != 0 && found < 2) two[found++] = sheet_of_face_[other];
        if (two[0] != two[1]) joined.push_back(join(two[0], two[1]));
      }
    }
    std::erase_if(joined, [&](int s) { return faces_[s].empty(); });
    std::ranges::sort(joined);
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    return joined;
  }
  int join(int a, int b) {
    if (faces_[a].size() < faces_[b].size() || (faces_[a].size() == faces_[b].size() && b < a)) std::swap(a, b);
    for (const int f : faces_[b]) sheet_of_face_[f] = a;
    faces_[a].insert(faces_[a].end(), faces_[b].begin(), faces_[b].end());
    faces_[b].clear();
    sheet_angles_[a] = std::max(sheet_angles_[a], sheet_angles_[b]);
    return a;
  }

  const Medial_complex_3& complex_;
  Incidences incidences_;
  std::vector<std::uint8_t> has_face_;
  std::vector<std::uint8_t> has_edge_;
  std::vector<std::uint8_t> has_vertex_;
  std::vector<int> edge_degrees_;
  std::vector<int> face_degrees_;
  std::vector<int> sheet_of_face_;
  std::vector<std::vector<int>> faces_;  ///< per sheet
  std::vector<double> sheet_angles_;
  std::vector<int> removed_faces_;
  std::vector<int> removed_edges_;
  std::vector<int> removed_vertices_;
  // Memory for what a sheet needs.
  std::vector<int> edge_buffer_;
  std::vector<int> open_;
  std::vector<std::pair<int, int>> edges_at_;  ///< vertices with their edges
};

}  // namespace

std::vector<Ball_3> grown(const std::vector<Ball_3>& balls, double scale) {
  std::vector<Ball_3> result = balls;
  for (Ball_3& ball : result) ball.radius *= scale;
  return result;
}

Sheets_3 sheets(const Medial_complex_3& complex) {
  Progress progress;
  return sheets_of(complex, Incidences(complex, progress));
}

Medial_values_3 sheet_values(const Medial_complex_3& complex) {
  constexpr double none = -1;
  constexpr double unknown = -2;
  Medial_values_3 values;
  const std::vector<int> of_faces = sheets(complex).sheet_of_face;
  values.faces.assign(of_faces.begin(), of_faces.end());
  values.edges.assign(complex.edges.size(), unknown);
  values.vertices.assign(complex.centers.size(), unknown);
  const auto meet = [](double& value, double sheet) { value = value == unknown || value == sheet ? sheet : none; };
  const std::vector<int> sides = edges_of_faces(complex);
  for (std::size_t f = 0; f < values.faces.size(); ++f) {
    for (int i = complex.face_offsets[f]; i < complex.face_offsets[f + 1]; ++i) {
      meet(values.edges[sides[i]], values.faces[f]);
      meet(values.vertices[complex.face_vertices[i]], values.faces[f]);
    }
  }
  std::ranges::replace(values.edges, unknown, none);
  std::ranges::replace(values.vertices, unknown, none);
  return values;
}

Pruned_complex_3 without_small_sheets(const Medial_complex_3& complex, const std::vector<double>& angles,
                                      double min_angle, Progress& progress) {
  progress.begin_stage("pruning");
  Pruner pruner(complex, angles, progress);
  pruner.prune(min_angle, progress);
  return pruner.result(progress);
}

Medial_complex_3 with_smooth_rims(Medial_complex_3 complex, int steps) {
  Progress progress;
  const Incidences incidences(complex, progress);
  std::vector<std::array<int, 2>> neighbors(complex.centers.size(), {-1, -1});
  std::vector<int> rim_degrees(complex.centers.size(), 0);
  for (std::size_t e = 0; e < complex.edges.size(); ++e) {
    if (incidences.faces_of(static_cast<int>(e)).size() != 1) continue;
    for (int end = 0; end < 2; ++end) {
      const int v = complex.edges[e][end];
      if (rim_degrees[v] < 2) neighbors[v][rim_degrees[v]] = complex.edges[e][1 - end];
      ++rim_degrees[v];
    }
  }
  for (int step = 0; step < steps; ++step) {
    const std::vector<Point_3> centers = complex.centers;
    const std::vector<double> radii = complex.radii;
    for (std::size_t v = 0; v < centers.size(); ++v) {
      if (rim_degrees[v] != 2) continue;
      const Point_3 moved = midpoint(centers[v], midpoint(centers[neighbors[v][0]], centers[neighbors[v][1]]));
      double radius = radii[v] - distance(moved, centers[v]);
      for (const int other : neighbors[v]) radius = std::max(radius, radii[other] - distance(moved, centers[other]));
      if (radius <= 0) continue;
      complex.centers[v] = moved;
      complex.radii[v] = radius;
    }
  }
  return complex;
}

}  // namespace mesecina
