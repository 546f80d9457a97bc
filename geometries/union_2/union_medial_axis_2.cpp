// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_2/union_medial_axis_2.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace mesecina {

namespace {

/// Pairs of sites that mean something, found from either end.
class Pairs {
 public:
  struct Entry {
    int other = -1;
    int ball = -1;  ///< of the arc whose chord this is; -1 for the two vertices of a singular edge
  };

  explicit Pairs(const Union_voronoi_2& voronoi) {
    const Union_boundary_2& boundary = *voronoi.boundary;
    const auto& site = voronoi.delaunay.site;
    struct Pair {
      int p;
      int q;
      int ball;
    };
    std::vector<Pair> pairs;
    for (const Boundary_arc& arc : boundary.arcs)
      if (arc.from >= 0 && site[arc.from] != site[arc.to]) pairs.push_back({site[arc.from], site[arc.to], arc.ball});
    chord_count_ = pairs.size();
    for (std::size_t e = 0; e < boundary.vertices_of_edge.size(); ++e) {
      const auto [left, right] = boundary.vertices_of_edge[e];
      if (left >= 0 && right >= 0 && site[left] != site[right]) pairs.push_back({site[left], site[right], -1});
    }
    offsets_.assign(site.size() + 1, 0);
    for (const Pair& pair : pairs) {
      ++offsets_[pair.p + 1];
      ++offsets_[pair.q + 1];
    }
    for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
    entries_.resize(2 * pairs.size());
    std::vector<int> next(offsets_.begin(), offsets_.end() - 1);
    for (const Pair& pair : pairs) {
      entries_[next[pair.p]++] = {pair.q, pair.ball};
      entries_[next[pair.q]++] = {pair.p, pair.ball};
    }
  }

  struct Answer {
    int chords = 0;
    int ball = -1;        ///< of the last of these
    int first_ball = -1;  ///< of the first of these
    bool is_singular = false;
  };
  Answer find(int p, int q) const {
    Answer answer;
    for (int i = offsets_[p]; i < offsets_[p + 1]; ++i) {
      const Entry& entry = entries_[i];
      if (entry.other != q) continue;
      if (entry.ball < 0) {
        answer.is_singular = true;
      } else {
        ++answer.chords;
        answer.ball = entry.ball;
        if (answer.first_ball < 0) answer.first_ball = entry.ball;
      }
    }
    return answer;
  }
  std::size_t chord_count() const { return chord_count_; }

 private:
  std::vector<int> offsets_;
  std::vector<Entry> entries_;
  std::size_t chord_count_ = 0;
};

/// Labels by parity from the outside, across chords. Every site has an even number of chords, so all ways agree.
void label_triangles(Union_voronoi_2& voronoi, const Pairs& pairs, const Progress& progress) {
  const Delaunay_2& delaunay = voronoi.delaunay;
  const int count = static_cast<int>(delaunay.triangles.size());
  voronoi.is_inner.assign(count, 0);
  std::vector<std::uint8_t> changes(3 * static_cast<std::size_t>(count), 0);
  std::size_t found = 0;
  std::vector<int> waiting;
  std::vector<std::uint8_t> is_known(count, 0);
  for (int t = 0; t < count; ++t) {
    if (t % 8192 == 0) progress.check();
    for (int i = 0; i < 3; ++i) {
      const auto [p, q] = delaunay.edge(t, i);
      const int chords = pairs.find(p, q).chords;
      changes[3 * static_cast<std::size_t>(t) + i] = chords % 2;
      if (delaunay.edge_is_listed(t, i)) found += chords;
      if (delaunay.neighbors[t][i] >= 0 || is_known[t] != 0) continue;
      is_known[t] = 1;
      voronoi.is_inner[t] = chords % 2;
      waiting.push_back(t);
    }
  }
  for (std::size_t i = 1; i < delaunay.line.size(); ++i)
    found += pairs.find(delaunay.line[i - 1], delaunay.line[i]).chords;
  voronoi.lost_chords = pairs.chord_count() - found;
  while (!waiting.empty()) {
    const int t = waiting.back();
    waiting.pop_back();
    for (int i = 0; i < 3; ++i) {
      const int u = delaunay.neighbors[t][i];
      if (u < 0 || is_known[u] != 0) continue;
      is_known[u] = 1;
      voronoi.is_inner[u] = voronoi.is_inner[t] ^ changes[3 * static_cast<std::size_t>(t) + i];
      waiting.push_back(u);
    }
  }
}

/// Per vertex the disks whose circles pass through it, or through another vertex with the same site.
struct Sources_of_sites {
  std::vector<int> offsets;
  std::vector<int> disks;
  Sources_of_sites(const Union_boundary_2& boundary, const std::vector<int>& site) {
    const auto count = static_cast<int>(site.size());
    bool has_joined = false;
    for (int v = 0; v < count; ++v) has_joined = has_joined || site[v] != v;
    if (!has_joined) {
      offsets = boundary.source_offsets;
      disks = boundary.sources;
      return;
    }
    std::vector<std::vector<int>> lists(site.size());
    for (int v = 0; v < count; ++v) {
      const auto own = boundary.sources_of(v);
      lists[site[v]].insert(lists[site[v]].end(), own.begin(), own.end());
    }
    offsets.push_back(0);
    for (int v = 0; v < count; ++v) {
      auto& list = lists[site[v]];
      std::ranges::sort(list);
      list.erase(std::unique(list.begin(), list.end()), list.end());
      disks.insert(disks.end(), list.begin(), list.end());
      offsets.push_back(static_cast<int>(disks.size()));
    }
  }
  std::span<const int> of(int vertex) const {
    return std::span(disks).subspan(offsets[vertex], offsets[vertex + 1] - offsets[vertex]);
  }
};

int common_source(const Sources_of_sites& sources, const std::array<int, 3>& corners) {
  for (const int disk : sources.of(corners[0])) {
    const auto touches = [&](int site) { return std::ranges::binary_search(sources.of(site), disk); };
    if (touches(corners[1]) && touches(corners[2])) return disk;
  }
  return -1;
}

/// The graph that is dual to the inner triangles has the homotopy type of the union, wherever the rounded vertices are:
/// every vertex is on the boundary of the polygons. What is done to it here keeps that: triangles about one disk are
/// drawn together only if they are neighbours, and only leaves are added.
class Axis_builder {
 public:
  Axis_builder(const Union_voronoi_2& voronoi, bool complete_only, const Progress& progress)
      : voronoi_(voronoi),
        delaunay_(voronoi.delaunay),
        boundary_(*voronoi.boundary),
        dual_(*boundary_.dual),
        pairs_(voronoi),
        complete_only_(complete_only),
        progress_(progress),
        node_of_ball_(boundary_.radii.size(), -1) {
    axis_.boundary = voronoi.boundary;
  }

  Union_medial_axis_2 build() {
    add_inner_triangles();
    add_voronoi_edges();
    add_singular_part();
    return std::move(axis_);
  }

 private:
  int node_of_ball(int ball) {
    if (node_of_ball_[ball] < 0) node_of_ball_[ball] = add_node(center(ball), boundary_.radii[ball], ball);
    return node_of_ball_[ball];
  }
  const Point_2& center(int ball) const { return dual_.regular->balls->centers[ball]; }
  int add_node(const Point_2& at, double radius, int ball) {
    axis_.centers.push_back(at);
    axis_.radii.push_back(radius);
    axis_.balls.push_back(ball);
    return static_cast<int>(axis_.centers.size()) - 1;
  }
  void add_edge(int a, int b, int p, int q, Axis_edge_kind kind) {
    axis_.edges.push_back({a, b});
    axis_.contacts.push_back({std::min(p, q), std::max(p, q)});
    axis_.kinds.push_back(kind);
  }

  /// Neighbouring triangles whose circle is that of one disk have one Voronoi vertex.
  void add_inner_triangles() {
    const int count = static_cast<int>(delaunay_.triangles.size());
    node_of_triangle_.assign(count, -1);
    std::vector<int> waiting;
    for (int first = 0; first < count; ++first) {
      if (first % 8192 == 0) progress_.check();
      if (voronoi_.is_inner[first] == 0 || node_of_triangle_[first] >= 0) continue;
      const int ball = voronoi_.ball_of_triangle[first];
      const int node = add_node(voronoi_.vertices[first], voronoi_.radii[first], ball);
      node_of_triangle_[first] = node;
      if (ball < 0) continue;
      if (node_of_ball_[ball] < 0) node_of_ball_[ball] = node;
      waiting.assign(1, first);
      while (!waiting.empty()) {
        const int t = waiting.back();
        waiting.pop_back();
        for (int i = 0; i < 3; ++i) {
          const int u = delaunay_.neighbors[t][i];
          if (u < 0 || node_of_triangle_[u] >= 0 || voronoi_.ball_of_triangle[u] != ball) continue;
          if (voronoi_.is_inner[u] == 0) continue;
          const auto [p, q] = delaunay_.edge(t, i);
          if (pairs_.find(p, q).chords > 0) continue;
          node_of_triangle_[u] = node;
          waiting.push_back(u);
        }
      }
    }
  }

  void add_voronoi_edges() {
    std::vector<int> vertices_of_ball(boundary_.radii.size(), 0);
    const Sources_of_sites sources(boundary_, delaunay_.site);
    for (int v = 0; v < static_cast<int>(delaunay_.site.size()); ++v)
      if (delaunay_.site[v] == v)
        for (const int ball : sources.of(v)) ++vertices_of_ball[ball];
    const auto pass_through = [&](int node, int vertex) {
      return std::ranges::binary_search(sources.of(vertex), axis_.balls[node]);
    };
    const std::vector<bool> touches_another = disks_that_touch();
    const int count = static_cast<int>(delaunay_.triangles.size());
    for (int t = 0; t < count; ++t) {
      if (t % 8192 == 0) progress_.check();
      for (int i = 0; i < 3; ++i) {
        if (!delaunay_.edge_is_listed(t, i)) continue;
        const int u = delaunay_.neighbors[t][i];
        const int a = node_of_triangle_[t];
        const int b = u < 0 ? -1 : node_of_triangle_[u];
        const auto [p, q] = delaunay_.edge(t, i);
        if (a < 0 && b < 0) {
          add_pair_of_disks(p, q);
          continue;
        }
        if (a == b) continue;
        const Pairs::Answer pair = pairs_.find(p, q);
        if (a >= 0 && b >= 0) {
          const bool is_singular =
              pair.is_singular && pass_through(a, p) && pass_through(a, q) && pass_through(b, p) && pass_through(b, q);
          if (pair.chords == 0) add_edge(a, b, p, q, is_singular ? Axis_edge_kind::singular : Axis_edge_kind::complete);
        } else if (pair.chords == 1 && vertices_of_ball[pair.ball] == 2) {
          // Disks with more vertices of the union have their center at a Voronoi vertex.
          const bool is_kept = pair.is_singular || touches_another[pair.ball];
          if (is_kept || !complete_only_)
            add_edge(std::max(a, b), node_of_ball(pair.ball), p, q,
                     is_kept ? Axis_edge_kind::singular : Axis_edge_kind::incomplete);
        }
      }
    }
  }

  /// Disks at the ends of a singular edge whose vertices are one.
  std::vector<bool> disks_that_touch() const {
    std::vector<bool> result(boundary_.radii.size(), false);
    for (std::size_t e = 0; e < dual_.edges.size(); ++e) {
      const auto [p, q] = boundary_.vertices_of_edge[e];
      if (dual_.edges[e].kind == Dual_kind::singular && delaunay_.site[p] == delaunay_.site[q])
        result[dual_.edges[e].a] = result[dual_.edges[e].b] = true;
    }
    return result;
  }

  /// Two disks that are a component by themselves: the two arcs between their crossings have one chord.
  void add_pair_of_disks(int p, int q) {
    const Pairs::Answer pair = pairs_.find(p, q);
    if (pair.chords == 2 && pair.first_ball != pair.ball)
      add_edge(node_of_ball(pair.first_ball), node_of_ball(pair.ball), p, q, Axis_edge_kind::singular);
  }

  /// What has no Voronoi edge: disks that touch, single disks.
  void add_singular_part() {
    const auto& site = delaunay_.site;
    for (std::size_t i = 1; i < delaunay_.line.size(); ++i) add_pair_of_disks(delaunay_.line[i - 1], delaunay_.line[i]);
    for (std::size_t e = 0; e < dual_.edges.size(); ++e) {
      const Dual_edge& edge = dual_.edges[e];
      if (edge.kind != Dual_kind::singular) continue;
      const auto [p, q] = boundary_.vertices_of_edge[e];
      if (boundary_.covered_by[edge.a] == edge.b) {
        // A disk that another covers is no part of the axis.
        node_of_ball(edge.b);
      } else if (boundary_.covered_by[edge.b] == edge.a) {
        node_of_ball(edge.a);
      } else if (site[p] == site[q]) {
        add_edge(node_of_ball(edge.a), node_of_ball(edge.b), p, q, Axis_edge_kind::singular);
      }
    }
    for (int b = 0; b < static_cast<int>(dual_.vertices.size()); ++b)
      if (dual_.vertices[b] == Dual_kind::singular) node_of_ball(b);
  }

  const Union_voronoi_2& voronoi_;
  const Delaunay_2& delaunay_;
  const Union_boundary_2& boundary_;
  const Dual_2& dual_;
  Pairs pairs_;
  bool complete_only_;
  const Progress& progress_;
  Union_medial_axis_2 axis_;
  std::vector<int> node_of_ball_;
  std::vector<int> node_of_triangle_;
};

}  // namespace

namespace {

/// Per vertex the least one with the same position, to its last digit.
std::vector<int> sites_of(const Union_boundary_2& boundary) {
  const auto digits = [&](int v) {
    const Point_2& p = boundary.vertices[v];
    const Point_2& rest = boundary.vertex_rests[v];
    return std::tuple(p.x, p.y, rest.x, rest.y);
  };
  std::vector<int> order(boundary.vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](int v, int w) { return std::tuple(digits(v), v) < std::tuple(digits(w), w); });
  std::vector<int> site(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    site[order[i]] = i > 0 && digits(order[i]) == digits(order[i - 1]) ? site[order[i - 1]] : order[i];
  return site;
}

/// Delaunay triangulation and Voronoi vertices of the vertices of a union, known to more digits than doubles have: as
/// the regular triangulation of points. That vertices lie on the circle of one disk is known, not computed.
void triangulate_precisely(Union_voronoi_2& result, Progress& progress) {
  const Union_boundary_2& boundary = *result.boundary;
  Delaunay_2& delaunay = result.delaunay;
  delaunay.points = boundary.vertices;
  delaunay.site = sites_of(boundary);
  Sources_of_sites sources(boundary, delaunay.site);
  auto points = std::make_shared<Balls_2>();
  points->centers = boundary.vertices;
  points->center_rests = boundary.vertex_rests;
  points->radii.assign(boundary.vertices.size(), 0);
  points->contact_offsets = std::move(sources.offsets);
  points->contacts = std::move(sources.disks);
  Regular_2 regular = regular_triangulation(points, progress);
  Power_vertices_2 power = power_vertices(regular, progress);
  result.vertices = std::move(power.vertices);
  result.radii.reserve(power.powers.size());
  for (const double squared_radius : power.powers) result.radii.push_back(std::sqrt(std::max(0.0, squared_radius)));
  delaunay.site_count = regular.vertex_count;
  delaunay.dimension = regular.dimension;
  delaunay.triangles = std::move(regular.triangles);
  delaunay.neighbors = std::move(regular.neighbors);
  delaunay.line = std::move(regular.line);
}

}  // namespace

Union_voronoi_2 union_voronoi(std::shared_ptr<const Union_boundary_2> boundary, Progress& progress) {
  Union_voronoi_2 result;
  result.boundary = std::move(boundary);
  const Union_boundary_2& of = *result.boundary;
  if (of.vertex_rests.empty()) {
    result.delaunay = delaunay(of.vertices, progress);
    Voronoi_2 voronoi = mesecina::voronoi(result.delaunay, progress);
    result.vertices = std::move(voronoi.vertices);
    result.radii = std::move(voronoi.radii);
  } else {
    triangulate_precisely(result, progress);
  }
  label_triangles(result, Pairs(result), progress);
  const Sources_of_sites sources(of, result.delaunay.site);
  result.ball_of_triangle.resize(result.delaunay.triangles.size());
  for (std::size_t t = 0; t < result.ball_of_triangle.size(); ++t) {
    if (t % 8192 == 0) progress.check();
    const int ball = common_source(sources, result.delaunay.triangles[t]);
    result.ball_of_triangle[t] = ball;
    if (ball < 0) continue;
    result.vertices[t] = of.dual->regular->balls->centers[ball];
    result.radii[t] = of.radii[ball];
  }
  return result;
}

Union_medial_axis_2 union_medial_axis(const Union_voronoi_2& voronoi, bool complete_only, Progress& progress) {
  return Axis_builder(voronoi, complete_only, progress).build();
}

std::vector<double> lambda_of_edges(const Union_medial_axis_2& axis) {
  const auto& vertices = axis.boundary->vertices;
  std::vector<double> lambda;
  lambda.reserve(axis.edges.size());
  for (const auto& [p, q] : axis.contacts) lambda.push_back(distance(vertices[p], vertices[q]) / 2);
  return lambda;
}

std::vector<double> angle_of_edges(const Union_medial_axis_2& axis) {
  const auto& vertices = axis.boundary->vertices;
  std::vector<double> angles;
  angles.reserve(axis.edges.size());
  for (std::size_t e = 0; e < axis.edges.size(); ++e) {
    const Point_2& p = vertices[axis.contacts[e][0]];
    const Point_2& q = vertices[axis.contacts[e][1]];
    const Point_2 middle = midpoint(p, q);
    const double length = distance(p, q);
    // Places of the ends of the edge on the bisector of its contacts, from their midpoint.
    const auto place = [&](int ball) {
      const Point_2& c = axis.centers[ball];
      return ((q.x - p.x) * (c.y - middle.y) - (q.y - p.y) * (c.x - middle.x)) / length;
    };
    double angle = 180;
    if (length > 0) {
      const double s = place(axis.edges[e][0]);
      const double t = place(axis.edges[e][1]);
      if (s * t > 0) angle = 2 * std::atan2(length / 2, std::min(std::abs(s), std::abs(t))) * (180 / std::numbers::pi);
    }
    angles.push_back(angle);
  }
  return angles;
}

}  // namespace mesecina
