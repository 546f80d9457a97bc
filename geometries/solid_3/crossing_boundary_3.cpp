// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/crossing_boundary_3.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Projection_traits_xy_3.h>
#include <CGAL/Projection_traits_xz_3.h>
#include <CGAL/Projection_traits_yz_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "geometries/solid_3/clean_mesh_3.h"
#include "geometries/solid_3/mesh_edges_3.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact_point = Kernel::Point_3;

Exact_point convert(const Point_3& p) { return {p.x, p.y, p.z}; }

/// The triangles of a mesh, cut where they cross.
class Pieces {
 public:
  Pieces(const Triangle_mesh_3& mesh, const Crossing_clusters_3& clusters, Progress& progress) : mesh_(mesh) {
    pieces_.vertices = mesh.vertices;
    // Before all new ones, which may be at their places.
    for (const std::array<int, 2>& pair : clusters.crossings)
      for (const int t : pair)
        for (const int v : mesh.triangles[t]) number_.try_emplace(convert(mesh.vertices[v]), v);
    std::map<int, std::vector<std::array<int, 2>>> cuts;  // per triangle that is cut
    for (const auto& [s, t] : clusters.crossings) {
      progress.check();
      for (const std::array<int, 2>& cut : common_part(s, t)) {
        cuts[s].push_back(cut);
        cuts[t].push_back(cut);
      }
    }
    auto next = cuts.begin();
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      if (next != cuts.end() && next->first == t) {
        progress.check();
        cut_triangle(t, next->second);
        ++next;
        if (triple_points_ > most_triple_points) return;
      } else {
        add(mesh.triangles[t], t);
      }
    }
  }

  /// False: cutting was given up.
  bool is_complete() const { return triple_points_ <= most_triple_points; }
  /// With the vertices of the mesh, then new ones, rounded. Pieces have the orientation of their triangle.
  const Triangle_mesh_3& pieces() const { return pieces_; }
  const std::vector<int>& source() const { return source_; }
  Exact_point exact(int vertex) const {
    const int known = static_cast<int>(mesh_.vertices.size());
    return vertex < known ? convert(mesh_.vertices[vertex]) : new_vertices_[vertex - known];
  }

 private:
  static constexpr std::size_t most_triple_points = 10000;

  struct Less {
    bool operator()(const Exact_point& p, const Exact_point& q) const {
      return CGAL::lexicographically_xyz_smaller(p, q);
    }
  };

  void add(const std::array<int, 3>& corners, int source) {
    pieces_.triangles.push_back(corners);
    source_.push_back(source);
  }

  int vertex_at(const Exact_point& p) {
    const auto [entry, is_new] = number_.try_emplace(p, static_cast<int>(pieces_.vertices.size()));
    if (is_new) {
      p.exact();
      new_vertices_.push_back(p);
      pieces_.vertices.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    return entry->second;
  }

  Kernel::Triangle_3 exact_triangle(int t) const {
    const auto& [u, v, w] = mesh_.triangles[t];
    return {convert(mesh_.vertices[u]), convert(mesh_.vertices[v]), convert(mesh_.vertices[w])};
  }

  /// Segments (by their vertices) that bound what two triangles have in common; a point is a segment without length.
  std::vector<std::array<int, 2>> common_part(int s, int t) {
    std::vector<std::array<int, 2>> result;
    const auto common = CGAL::intersection(exact_triangle(s), exact_triangle(t));
    if (!common) return result;
    if (const auto* point = boost::get<Exact_point>(&*common)) {
      const int v = vertex_at(*point);
      result.push_back({v, v});
    } else if (const auto* segment = boost::get<Kernel::Segment_3>(&*common)) {
      result.push_back({vertex_at(segment->source()), vertex_at(segment->target())});
    } else {
      std::vector<Exact_point> polygon;
      if (const auto* triangle = boost::get<Kernel::Triangle_3>(&*common)) {
        for (int i = 0; i < 3; ++i) polygon.push_back(triangle->vertex(i));
      } else {
        polygon = boost::get<std::vector<Exact_point>>(*common);
      }
      for (std::size_t i = 0; i < polygon.size(); ++i)
        result.push_back({vertex_at(polygon[i]), vertex_at(polygon[(i + 1) % polygon.size()])});
    }
    return result;
  }

  void cut_triangle(int t, const std::vector<std::array<int, 2>>& cuts) {
    const Corners_3 corners{mesh_.vertices[mesh_.triangles[t][0]], mesh_.vertices[mesh_.triangles[t][1]],
                            mesh_.vertices[mesh_.triangles[t][2]]};
    // The plane to which it is projected need only not be perpendicular to it.
    const Double_place last(corners[2]);
    if (const int turn = last.side_of_line(corners[0], corners[1], 2); turn != 0) {
      cut_projected<CGAL::Projection_traits_xy_3<Kernel>>(t, cuts, turn > 0);
    } else if (const int turn_x = last.side_of_line(corners[0], corners[1], 0); turn_x != 0) {
      cut_projected<CGAL::Projection_traits_yz_3<Kernel>>(t, cuts, turn_x > 0);
    } else {
      // These traits look at (x, z), not at (z, x).
      cut_projected<CGAL::Projection_traits_xz_3<Kernel>>(t, cuts, last.side_of_line(corners[0], corners[1], 1) < 0);
    }
  }

  template <class Traits>
  void cut_projected(int t, const std::vector<std::array<int, 2>>& cuts, bool is_counterclockwise) {
    using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<int, Traits>;
    using Face_base = CGAL::Constrained_triangulation_face_base_2<Traits>;
    using Triangulation =
        CGAL::Constrained_Delaunay_triangulation_2<Traits, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
                                                   CGAL::Exact_intersections_tag>;
    Triangulation triangulation;
    const auto insert = [&](int v) {
      const auto handle = triangulation.insert(exact(v));
      handle->info() = v;
      return handle;
    };
    for (const int v : mesh_.triangles[t]) insert(v);
    std::vector<std::array<int, 2>> segments = cuts;
    std::ranges::sort(segments);
    for (const auto& [v, w] : segments) {
      const auto from = insert(v);
      const auto to = insert(w);
      if (v == w) continue;
      const std::size_t before = triangulation.number_of_vertices();
      triangulation.insert_constraint(from, to);
      triple_points_ += triangulation.number_of_vertices() - before;
      if (triple_points_ > most_triple_points) return;
    }
    std::map<typename Triangulation::Vertex_handle, int> number;
    for (const auto handle : triangulation.finite_vertex_handles()) number[handle] = vertex_at(handle->point());
    for (const auto face : triangulation.finite_face_handles()) {
      std::array<int, 3> piece{number[face->vertex(0)], number[face->vertex(1)], number[face->vertex(2)]};
      if (!is_counterclockwise) std::swap(piece[1], piece[2]);
      add(piece, t);
    }
  }

  const Triangle_mesh_3& mesh_;
  std::vector<Exact_point> new_vertices_;
  std::map<Exact_point, int, Less> number_;
  Triangle_mesh_3 pieces_;
  std::vector<int> source_;
  std::size_t triple_points_ = 0;  ///< where a triangle is crossed by two others, counted in each
};

/// What becomes of a piece.
enum class Fate : std::uint8_t { gone, kept, turned };

/// Whether a piece is on the boundary of the inside of its cluster.
Fate fate_of(const Pieces& pieces, int piece, const Crossing_clusters_3& clusters, const Surface_locator_3& locator) {
  const int own = pieces.source()[piece];
  const int cluster = clusters.cluster[own];
  const std::array<int, 3>& corners = pieces.pieces().triangles[piece];
  const Exact_place place(CGAL::centroid(pieces.exact(corners[0]), pieces.exact(corners[1]), pieces.exact(corners[2])));
  int winding = 0;  // on the side of the ray
  int step = 0;     // to the other side
  int side_of_own = 0;
  int first = own;  // of the triangles on which the piece lies
  locator.tree().visit([&](const Box& box) { return may_be_above(box, place.box()); },
                       [&](int i) {
                         const int t = locator.tree().order()[i];
                         if (clusters.cluster[t] != cluster) return true;
                         const Crossing_3 crossing = crossing_above(locator.corners()[i], place);
                         winding += crossing.direction;
                         if (crossing.is_on) {
                           const int side = side_of_ray(locator.corners()[i]);
                           step += side;
                           first = std::min(first, t);
                           if (t == own) side_of_own = side;
                         }
                         return true;
                       });
  const auto is_inside = [&](int times) {
    return clusters.rule[cluster] == Inside_rule::odd ? times % 2 != 0 : times > 0;
  };
  const bool on_side_of_ray = is_inside(winding);
  if (first != own || on_side_of_ray == is_inside(winding + step)) return Fate::gone;
  const bool front_is_inside = on_side_of_ray == (side_of_own > 0);
  return front_is_inside ? Fate::turned : Fate::kept;
}

/// Joins vertices that rounding brought to one place.
void join_vertices(Triangle_mesh_3& mesh) {
  const std::vector<int> first = first_at_place(mesh.vertices);
  for (std::array<int, 3>& t : mesh.triangles)
    for (int& v : t) v = first[v];
  std::erase_if(mesh.triangles,
                [](const std::array<int, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  remove_unused_vertices(mesh);
}

}  // namespace

std::optional<Triangle_mesh_3> crossing_boundary(const Triangle_mesh_3& mesh, const Crossing_clusters_3& clusters,
                                                 const Surface_locator_3& locator, Progress& progress) {
  const Pieces pieces(mesh, clusters, progress);
  if (!pieces.is_complete()) return std::nullopt;
  const std::vector<std::array<int, 3>>& triangles = pieces.pieces().triangles;
  const Mesh_edges_3 edges = find_edges(pieces.pieces());
  Triangle_mesh_3 result;
  result.vertices = pieces.pieces().vertices;
  std::vector<Fate> fates(triangles.size(), Fate::gone);
  std::vector<std::uint8_t> is_reached(triangles.size(), 0);
  std::vector<int> stack;
  for (int seed = 0; seed < static_cast<int>(triangles.size()); ++seed) {
    if (is_reached[seed]) continue;
    is_reached[seed] = 1;
    const bool is_asked = clusters.rule[clusters.cluster[pieces.source()[seed]]] != Inside_rule::as_it_is;
    fates[seed] = is_asked ? fate_of(pieces, seed, clusters, locator) : Fate::kept;
    progress.check();
    // Across an edge of two pieces nothing changes but, in clusters without orientation, the direction.
    stack.push_back(seed);
    while (!stack.empty()) {
      const int piece = stack.back();
      stack.pop_back();
      for (int h = 3 * piece; h < 3 * piece + 3; ++h) {
        const int twin = edges.twin[h];
        if (twin < 0 || is_reached[twin / 3]) continue;
        is_reached[twin / 3] = 1;
        const bool is_against = half_edge_source(pieces.pieces(), h) == half_edge_source(pieces.pieces(), twin);
        const Fate fate = fates[piece];
        fates[twin / 3] = fate == Fate::gone || !is_against ? fate : fate == Fate::kept ? Fate::turned : Fate::kept;
        stack.push_back(twin / 3);
      }
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (fates[i] == Fate::gone) continue;
    result.triangles.push_back(triangles[i]);
    if (fates[i] == Fate::turned) std::swap(result.triangles.back()[1], result.triangles.back()[2]);
  }
  join_vertices(result);
  return result;
}

}  // namespace mesecina
