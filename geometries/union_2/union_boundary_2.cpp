// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_2/union_boundary_2.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "geometries/regular_2/power_predicates.h"

namespace mesecina {

namespace {

/// An end of an exposed arc on the circle of some disk.
struct Arc_end {
  int edge = -1;  ///< of the dual complex
  int vertex = -1;
  bool starts = false;  ///< an arc starts here, else one ends
};

class Boundary_builder {
 public:
  Boundary_builder(Union_boundary_2& boundary, Progress& progress)
      : boundary_(boundary),
        dual_(*boundary.dual),
        regular_(*dual_.regular),
        balls_(*regular_.balls),
        predicates_(balls_, progress),
        progress_(progress),
        vertex_of_sample_(balls_.is_circumscribed() ? balls_.samples->size() : 0, -1) {}

  void build() {
    set_radii();
    {
      const Power_predicates::Upward_rounding rounding;
      join_flat_triangles();
      name_vertices();
      find_sources();
      find_arcs();
    }
    order_arcs();
    place_vertices();
    if (!boundary_.vertex_rests.empty()) join_vertices_of_short_arcs();
  }

 private:
  void set_radii() {
    boundary_.radii = balls_.radii;
    if (dual_.alpha == 0) return;
    for (double& radius : boundary_.radii) radius = std::sqrt(std::max(0.0, radius * radius + dual_.alpha));
  }

  int root(int triangle) {
    while (flat_class_[triangle] != triangle) triangle = flat_class_[triangle] = flat_class_[flat_class_[triangle]];
    return triangle;
  }

  /// Flat triangles with one power vertex: circles that meet in one point.
  void join_flat_triangles() {
    flat_class_.resize(regular_.triangles.size());
    std::iota(flat_class_.begin(), flat_class_.end(), 0);
    for (const Dual_edge& edge : dual_.edges) {
      if (edge.kind != Dual_kind::interior || dual_.is_flat[edge.left] == 0 || dual_.is_flat[edge.right] == 0) continue;
      const auto& [a, b, c] = regular_.triangles[edge.left];
      if (predicates_.power_side(a, b, c, opposite(edge.right, edge)) != CGAL::ON_ORIENTED_BOUNDARY) continue;
      const int r = root(edge.left);
      const int s = root(edge.right);
      flat_class_[std::max(r, s)] = std::min(r, s);
    }
  }

  int opposite(int triangle, const Dual_edge& edge) const {
    for (const int corner : regular_.triangles[triangle])
      if (corner != edge.a && corner != edge.b) return corner;
    throw std::logic_error("a triangle has no corner opposite to its edge");
  }

  int add_vertex(int edge, bool on_left, int flat_class) {
    const int vertex = static_cast<int>(origins_.size());
    origins_.push_back({edge, on_left, flat_class});
    boundary_.samples.push_back(-1);
    return vertex;
  }

  int vertex_of_sample(int sample, int edge, bool on_left) {
    int& vertex = vertex_of_sample_[sample];
    if (vertex < 0) {
      vertex = add_vertex(edge, on_left, -1);
      boundary_.samples.back() = sample;
    }
    return vertex;
  }

  int vertex_of_flat_class(int triangle, int edge, bool on_left) {
    const int flat_class = root(triangle);
    if (dual_.alpha == 0) {
      if (const int sample = balls_.common_contact(regular_.triangles[flat_class]); sample >= 0)
        return vertex_of_sample(sample, edge, on_left);
    }
    const auto [place, is_new] = vertex_of_class_.try_emplace(flat_class, static_cast<int>(origins_.size()));
    if (is_new) add_vertex(edge, on_left, flat_class);
    return place->second;
  }

  /// Where the circles of the ends of an edge meet on one side of it.
  int crossing(int e, bool on_left) {
    const Dual_edge& edge = dual_.edges[e];
    if (dual_.alpha == 0 && balls_.is_circumscribed()) {
      for (const int sample : balls_.contacts_of(edge.a)) {
        if (std::ranges::find(balls_.contacts_of(edge.b), sample) == balls_.contacts_of(edge.b).end()) continue;
        const auto side = predicates_.orientation(edge.a, edge.b, (*balls_.samples)[sample]);
        if (side == CGAL::COLLINEAR || (side == CGAL::LEFT_TURN) == on_left)
          return vertex_of_sample(sample, e, on_left);
      }
    }
    return add_vertex(e, on_left, -1);
  }

  void name_vertices() {
    auto& of_edge = boundary_.vertices_of_edge;
    of_edge.assign(dual_.edges.size(), {-1, -1});
    boundary_.covered_by.assign(balls_.size(), -1);
    for (int e = 0; e < static_cast<int>(dual_.edges.size()); ++e) {
      if (e % 4096 == 0) progress_.check();
      const Dual_edge& edge = dual_.edges[e];
      if (edge.kind == Dual_kind::singular) {
        of_edge[e][0] = crossing(e, true);
        if (predicates_.size_sign(edge.a, edge.b, dual_.alpha) != CGAL::ZERO) {
          of_edge[e][1] = crossing(e, false);
          continue;
        }
        of_edge[e][1] = of_edge[e][0];
        if (predicates_.conflict_sign(edge.a, edge.b) != CGAL::POSITIVE) boundary_.covered_by[edge.a] = edge.b;
        if (predicates_.conflict_sign(edge.b, edge.a) != CGAL::POSITIVE) boundary_.covered_by[edge.b] = edge.a;
      } else if (edge.kind == Dual_kind::regular) {
        const bool inside_is_left = edge.left >= 0 && dual_.has_triangle[edge.left] != 0;
        const int inside = inside_is_left ? edge.left : edge.right;
        // The power vertex of a flat triangle is on its boundary. It lies beyond the edge iff the third disk is in
        // conflict with the smallest circle orthogonal to the edge, and on the edge itself iff the two touch.
        const bool ends_in_flat_vertex =
            dual_.is_flat[inside] != 0 &&
            predicates_.conflict_sign(edge.a, edge.b, opposite(inside, edge)) != CGAL::POSITIVE;
        of_edge[e][inside_is_left ? 1 : 0] =
            ends_in_flat_vertex ? vertex_of_flat_class(inside, e, !inside_is_left) : crossing(e, !inside_is_left);
      }
    }
  }

  void find_sources() {
    // Pairs of a vertex and a disk, sorted by vertex; some twice.
    std::vector<std::array<int, 2>> pairs;
    pairs.reserve(4 * origins_.size());
    for (int v = 0; v < static_cast<int>(origins_.size()); ++v) {
      if (boundary_.samples[v] >= 0 || origins_[v].flat_class >= 0) continue;
      const Dual_edge& edge = dual_.edges[origins_[v].edge];
      pairs.push_back({v, edge.a});
      pairs.push_back({v, edge.b});
    }
    if (!vertex_of_class_.empty()) {
      for (std::size_t t = 0; t < regular_.triangles.size(); ++t) {
        if (dual_.is_flat[t] == 0) continue;
        const auto place = vertex_of_class_.find(root(static_cast<int>(t)));
        if (place == vertex_of_class_.end()) continue;
        for (const int ball : regular_.triangles[t]) pairs.push_back({place->second, ball});
      }
    }
    if (!vertex_of_sample_.empty()) {
      for (int b = 0; b < static_cast<int>(balls_.size()); ++b)
        for (const int sample : balls_.contacts_of(b))
          if (const int vertex = vertex_of_sample_[sample]; vertex >= 0) pairs.push_back({vertex, b});
    }
    progress_.check();
    std::vector<int> offsets(origins_.size() + 1, 0);
    for (const auto& [vertex, ball] : pairs) ++offsets[vertex + 1];
    for (std::size_t v = 1; v < offsets.size(); ++v) offsets[v] += offsets[v - 1];
    std::vector<int> disks(pairs.size());
    std::vector<int> next(offsets.begin(), offsets.end() - 1);
    for (const auto& [vertex, ball] : pairs) disks[next[vertex]++] = ball;
    boundary_.source_offsets.reserve(offsets.size());
    boundary_.source_offsets.push_back(0);
    for (std::size_t v = 0; v + 1 < offsets.size(); ++v) {
      const auto first = disks.begin() + offsets[v];
      const auto last = disks.begin() + offsets[v + 1];
      std::sort(first, last);
      boundary_.sources.insert(boundary_.sources.end(), first, std::unique(first, last));
      boundary_.source_offsets.push_back(static_cast<int>(boundary_.sources.size()));
    }
  }

  /// Calls visit(e) for the edges of the complex at a disk, counterclockwise around its center.
  template <class Visit>
  void visit_edges_around(int ball, int some_triangle, const Visit& visit) const {
    const auto clockwise = [&](int t) { return regular_.neighbors[t][(regular_.corner_of(t, ball) + 2) % 3]; };
    const auto counterclockwise = [&](int t) { return regular_.neighbors[t][(regular_.corner_of(t, ball) + 1) % 3]; };
    int first = some_triangle;
    for (int t = clockwise(first); t >= 0 && t != some_triangle; t = clockwise(first)) first = t;
    const bool is_on_hull = clockwise(first) < 0;
    if (is_on_hull) visit(edge_at(first, (regular_.corner_of(first, ball) + 2) % 3));
    int t = first;
    while (t >= 0) {
      visit(edge_at(t, (regular_.corner_of(t, ball) + 1) % 3));
      t = counterclockwise(t);
      if (t == first) break;
    }
  }

  int edge_at(int triangle, int corner) const {
    return edge_of_corner_[3 * static_cast<std::size_t>(triangle) + corner];
  }

  void find_arcs() {
    edge_of_corner_.assign(3 * regular_.triangles.size(), -1);
    for (int e = 0; e < static_cast<int>(dual_.edges.size()); ++e) {
      const Dual_edge& edge = dual_.edges[e];
      for (const int t : {edge.left, edge.right}) {
        if (t < 0) continue;
        for (int i = 0; i < 3; ++i)
          if (const int corner = regular_.triangles[t][i]; corner != edge.a && corner != edge.b)
            edge_of_corner_[3 * static_cast<std::size_t>(t) + i] = e;
      }
    }
    std::vector<Arc_end> ends;
    const auto add_ends = [&](int ball, int e) {
      if (e < 0 || dual_.edges[e].kind == Dual_kind::interior) return;
      const bool is_first = dual_.edges[e].a == ball;
      const int right = boundary_.vertices_of_edge[e][is_first ? 1 : 0];
      const int left = boundary_.vertices_of_edge[e][is_first ? 0 : 1];
      // The circle runs counterclockwise into the neighbour's cell on the right of the edge and out of it on the left.
      if (right >= 0) ends.push_back({e, right, false});
      if (left >= 0) ends.push_back({e, left, true});
    };

    if (regular_.dimension < 2) {
      std::vector<std::array<int, 2>> edges_of_ball(balls_.size(), {-1, -1});
      for (int e = 0; e < static_cast<int>(dual_.edges.size()); ++e) {
        edges_of_ball[dual_.edges[e].a][1] = e;
        edges_of_ball[dual_.edges[e].b][0] = e;
      }
      for (const int ball : regular_.line) {
        ends.clear();
        for (const int e : edges_of_ball[ball]) add_ends(ball, e);
        add_arcs(ball, ends);
      }
      return;
    }
    std::vector<int> triangle_of_ball(balls_.size(), -1);
    for (std::size_t t = 0; t < regular_.triangles.size(); ++t)
      for (const int ball : regular_.triangles[t]) triangle_of_ball[ball] = static_cast<int>(t);
    for (int ball = 0; ball < static_cast<int>(balls_.size()); ++ball) {
      if (ball % 4096 == 0) progress_.check();
      const Dual_kind kind = dual_.vertices[ball];
      if (kind == Dual_kind::outside || kind == Dual_kind::interior) continue;
      ends.clear();
      if (kind != Dual_kind::singular)
        visit_edges_around(ball, triangle_of_ball[ball], [&](int e) { add_ends(ball, e); });
      add_arcs(ball, ends);
    }
  }

  /// From the ends of the exposed arcs of a disk, in their order around it.
  void add_arcs(int ball, const std::vector<Arc_end>& ends) {
    if (ends.empty()) {
      if (dual_.vertices[ball] == Dual_kind::singular) boundary_.arcs.push_back({ball, -1, -1});
      return;
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (!ends[i].starts) continue;
      const Arc_end& end = ends[(i + 1) % ends.size()];
      if (end.starts) throw std::logic_error("an arc of the boundary of the union has two starts");
      if (ends[i].vertex == end.vertex) {
        // A whole circle where two disks touch from outside; nothing where the circle only touches the boundary.
        if (ends[i].edge != end.edge || boundary_.covered_by[ball] >= 0) continue;
      }
      boundary_.arcs.push_back({ball, ends[i].vertex, end.vertex});
    }
  }

  void order_arcs() {
    auto& arcs = boundary_.arcs;
    std::vector<int> next_of_vertex(origins_.size(), -1);
    std::vector<int> next_of_arc(arcs.size(), -1);
    for (int a = static_cast<int>(arcs.size()) - 1; a >= 0; --a) {
      if (arcs[a].from < 0) continue;
      next_of_arc[a] = next_of_vertex[arcs[a].from];
      next_of_vertex[arcs[a].from] = a;
    }
    std::vector<Boundary_arc> ordered;
    ordered.reserve(arcs.size());
    std::vector<bool> is_done(arcs.size(), false);
    for (int first = 0; first < static_cast<int>(arcs.size()); ++first) {
      for (int a = first; a >= 0 && !is_done[a];) {
        is_done[a] = true;
        ordered.push_back(arcs[a]);
        if (arcs[a].to < 0) break;
        int& next = next_of_vertex[arcs[a].to];
        while (next >= 0 && is_done[next]) next = next_of_arc[next];
        a = next;
      }
    }
    arcs = std::move(ordered);
  }

  void place_vertices() {
    boundary_.vertices.resize(origins_.size());
    if (std::ranges::find(boundary_.samples, -1) != boundary_.samples.end())
      boundary_.vertex_rests.resize(origins_.size());
    for (std::size_t v = 0; v < origins_.size(); ++v) {
      if (v % 4096 == 0) progress_.check();
      if (boundary_.samples[v] >= 0) {
        boundary_.vertices[v] = (*balls_.samples)[boundary_.samples[v]];
        continue;
      }
      const Dual_edge& edge = dual_.edges[origins_[v].edge];
      const auto [point, rest] = predicates_.crossing(edge.a, edge.b, dual_.alpha, origins_[v].on_left);
      boundary_.vertices[v] = point;
      boundary_.vertex_rests[v] = rest;
    }
  }

  /// Gives the ends of an arc one position where their positions are not known well enough to tell them apart: in any
  /// other order than theirs, arcs would cross.
  void join_vertices_of_short_arcs() {
    constexpr double known_part = 0x1p-84;
    std::vector<int> place(boundary_.vertices.size());
    std::iota(place.begin(), place.end(), 0);
    const auto root = [&](int v) {
      while (place[v] != v) v = place[v] = place[place[v]];
      return v;
    };
    for (const Boundary_arc& arc : boundary_.arcs) {
      if (arc.from < 0 || arc.from == arc.to) continue;
      const Point_2& p = boundary_.vertices[arc.from];
      const Point_2& q = boundary_.vertices[arc.to];
      const double size = std::max(std::abs(p.x), std::abs(p.y)) + boundary_.radii[arc.ball];
      if (std::max(std::abs(p.x - q.x), std::abs(p.y - q.y)) > size * 0x1p-40) continue;
      const Point_2& rest_p = boundary_.vertex_rests[arc.from];
      const Point_2& rest_q = boundary_.vertex_rests[arc.to];
      const double x = (p.x - q.x) + (rest_p.x - rest_q.x);
      const double y = (p.y - q.y) + (rest_p.y - rest_q.y);
      if (std::max(std::abs(x), std::abs(y)) > size * known_part) continue;
      const int r = root(arc.from);
      const int s = root(arc.to);
      place[std::max(r, s)] = std::min(r, s);
    }
    for (int v = 0; v < static_cast<int>(place.size()); ++v) {
      const int of = root(v);
      boundary_.vertices[v] = boundary_.vertices[of];
      boundary_.vertex_rests[v] = boundary_.vertex_rests[of];
    }
  }

  struct Origin {
    int edge = -1;
    bool on_left = false;
    int flat_class = -1;
  };

  Union_boundary_2& boundary_;
  const Dual_2& dual_;
  const Regular_2& regular_;
  const Balls_2& balls_;
  Power_predicates predicates_;
  Progress& progress_;
  std::vector<int> flat_class_;
  std::vector<Origin> origins_;
  std::vector<int> vertex_of_sample_;  ///< -1 for samples that are no vertex
  std::unordered_map<int, int> vertex_of_class_;
  std::vector<int> edge_of_corner_;
};

}  // namespace

Union_boundary_2 union_boundary(std::shared_ptr<const Dual_2> dual, Progress& progress) {
  Union_boundary_2 boundary;
  boundary.dual = std::move(dual);
  Boundary_builder(boundary, progress).build();
  return boundary;
}

Union_boundary_2 union_boundary(std::shared_ptr<const Balls_2> balls, double alpha, Progress& progress) {
  auto regular = std::make_shared<const Regular_2>(regular_triangulation(std::move(balls), progress));
  auto dual = std::make_shared<const Dual_2>(dual_complex(std::move(regular), alpha, progress));
  return union_boundary(std::move(dual), progress);
}

}  // namespace mesecina
