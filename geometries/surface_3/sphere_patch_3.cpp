// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/sphere_patch_3.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "geometries/surface_3/loop_nodes_3.h"

namespace mesecina {

namespace {

struct Face_place {
  bool is_outside = false;
};
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face_base =
    CGAL::Triangulation_face_base_with_info_2<Face_place, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
                                               CGAL::No_constraint_intersection_tag>;
using Face = Triangulation::Face_handle;
using Vertex = Triangulation::Vertex_handle;

double length(const Point_3& p) { return std::sqrt(dot(p, p)); }

/// The stereographic projection of a sphere from its pole; what is counterclockwise from outside is so in the plane.
class Stereographic_projection {
 public:
  Stereographic_projection(const Ball_3& ball, const Point_3& pole) : ball_(ball), pole_(pole) {
    const Point_3 axis = std::abs(pole.x) < 0.5 ? Point_3{1, 0, 0} : Point_3{0, 1, 0};
    u_ = cross(pole, axis);
    u_ = (1 / length(u_)) * u_;
    v_ = cross(u_, pole);
  }
  Kernel::Point_2 operator()(const Point_3& p) const {
    const Point_3 direction = (1 / ball_.radius) * (p - ball_.center);
    const double below = 1 - dot(direction, pole_);
    return {dot(direction, u_) / below, dot(direction, v_) / below};
  }
  Point_3 inverse(const Kernel::Point_2& p) const {
    const double square = p.x() * p.x() + p.y() * p.y();
    const Point_3 scaled = (2 * p.x()) * u_ + (2 * p.y()) * v_ + (square - 1) * pole_;
    return ball_.center + (ball_.radius / (1 + square)) * scaled;
  }

 private:
  Ball_3 ball_;
  Point_3 pole_;
  Point_3 u_;
  Point_3 v_;
};

/// Parts of the radius: what is nearer is one point but for rounding, and what is smaller is no more than a point.
constexpr double same_part = 1e-10;
constexpr double tiny_part = 1e-6;

class Patch_triangulation {
 public:
  Patch_triangulation(const Sphere_patch_3& patch, const Loop_nodes_3& nodes, double deviation)
      : patch_(patch), nodes_(nodes), deviation_(deviation), project_(patch.ball, patch.pole) {}

  /// Where `is_apart`, nodes are moved a little into the patch before, so that loops may touch.
  std::optional<Patch_mesh_3> run(bool is_apart) {
    try {
      if (!insert_nodes(is_apart)) return std::nullopt;
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return std::nullopt;
    }
    if (!mark_outside()) return std::nullopt;
    refine();
    Patch_mesh_3 result;
    result.inner_points.assign(points_.begin() + boundary_count_, points_.end());
    for (const Face face : triangulation_.finite_face_handles())
      if (!face->info().is_outside) result.triangles.push_back(corners_of(face));
    result.triangles = nodes_.expanded(std::move(result.triangles));
    return result;
  }

 private:
  /// False when two nodes are projected to one point, or a loop has too few.
  bool insert_nodes(bool is_apart) {
    if (std::ranges::any_of(nodes_.loops(), [](const std::vector<int>& loop) { return loop.size() < 3; })) return false;
    points_ = nodes_.points();
    boundary_count_ = static_cast<int>(points_.size());
    std::vector<Kernel::Point_2> projected;
    for (const Point_3& p : points_) {
      projected.push_back(project_(p));
      if (!std::isfinite(projected.back().x()) || !std::isfinite(projected.back().y())) return false;
    }
    if (is_apart) move_apart(projected);
    vertices_.resize(points_.size());
    Face hint;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      vertices_[i] = triangulation_.insert(projected[i], hint);
      if (triangulation_.number_of_vertices() != i + 1) return false;
      vertices_[i]->info() = static_cast<int>(i);
      hint = vertices_[i]->face();
    }
    for_each_side([&](int a, int b) { triangulation_.insert_constraint(vertices_[a], vertices_[b]); });
    return triangulation_.dimension() == 2;
  }

  void move_apart(std::vector<Kernel::Point_2>& projected) const {
    constexpr double part_of_side = 1e-5;
    const std::vector<Kernel::Point_2> old = projected;
    for (const auto& loop : nodes_.loops()) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Kernel::Vector_2 before = old[loop[i]] - old[loop[(i + loop.size() - 1) % loop.size()]];
        const Kernel::Vector_2 after = old[loop[(i + 1) % loop.size()]] - old[loop[i]];
        const double in = std::sqrt(before.squared_length());
        const double out = std::sqrt(after.squared_length());
        if (in == 0 || out == 0) continue;
        const Kernel::Vector_2 along = before / in + after / out;
        const double size = std::sqrt(along.squared_length());
        if (size == 0) continue;
        projected[loop[i]] =
            old[loop[i]] + along.perpendicular(CGAL::COUNTERCLOCKWISE) * (part_of_side * std::min(in, out) / size);
      }
    }
  }

  template <class Body>
  void for_each_side(const Body& body) const {
    for (const auto& loop : nodes_.loops())
      for (std::size_t i = 0; i < loop.size(); ++i) body(loop[i], loop[(i + 1) % loop.size()]);
  }

  /// False when the faces between the loops do not make up the patch.
  bool mark_outside() {
    for (const Face face : triangulation_.all_face_handles()) face->info().is_outside = true;
    std::vector<Face> open;
    std::vector<Face> across;
    bool has_sides = true;
    for_each_side([&](int a, int b) {
      Face face;
      int index = 0;
      if (!has_sides || !triangulation_.is_edge(vertices_[a], vertices_[b], face, index) ||
          !face->is_constrained(index)) {
        has_sides = false;
        return;
      }
      Face other = face->neighbor(index);
      if (face->vertex(Triangulation::ccw(index)) != vertices_[a]) std::swap(face, other);
      across.push_back(other);
      open.push_back(face);
    });
    if (!has_sides) return false;
    std::size_t count = 0;
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      if (!face->info().is_outside) continue;
      if (triangulation_.is_infinite(face)) return false;
      face->info().is_outside = false;
      ++count;
      for (int i = 0; i < 3; ++i)
        if (!face->is_constrained(i)) open.push_back(face->neighbor(i));
    }
    return count + 4 == points_.size() + 2 * nodes_.loops().size() + nodes_.tiny_loops().size() &&
           std::ranges::all_of(across, [](const Face& face) { return face->info().is_outside; });
  }

  std::array<int, 3> corners_of(const Face& face) const {
    return {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
  }

  void refine() {
    constexpr int most_rounds = 64;
    // Several times what a whole sphere needs.
    const double most_points = 64 + 32 * patch_.ball.radius / deviation_;
    std::vector<std::array<Point_3, 3>> wanted;
    for (int round = 0; round < most_rounds; ++round) {
      wanted.clear();
      for (const Face face : triangulation_.finite_face_handles())
        if (!face->info().is_outside) want_points(face, wanted);
      if (wanted.empty() || static_cast<double>(points_.size()) - boundary_count_ > most_points) return;
      const std::size_t before = points_.size();
      for (const auto& places : wanted)
        static_cast<void>(std::ranges::any_of(places, [&](const Point_3& p) { return insert(p, before); }));
      if (points_.size() == before) return;
    }
  }

  /// Of a triangle that is too far from the sphere: the point of the sphere above its circumcenter, or else above the
  /// middle of its longest side where it is obtuse, or else
  /// the middle of its longest inner side in the projection, where chords have other places.
  void want_points(const Face& face, std::vector<std::array<Point_3, 3>>& wanted) const {
    const auto corners = corners_of(face);
    const auto& [center, radius] = patch_.ball;
    const std::array<Point_3, 3> p{points_[corners[0]], points_[corners[1]], points_[corners[2]]};
    const Point_3 normal = cross(p[1] - p[0], p[2] - p[0]);
    const double size = length(normal);
    if (size == 0) return;
    const Point_3 up = (1 / size) * normal;
    const double height = dot(up, p[0] - center);
    if (radius - height <= deviation_) return;
    const Point_3 top = center + radius * up;
    Point_3 middle = top;
    for (int i = 0; i < 3; ++i) {
      const Point_3& a = p[(i + 1) % 3];
      const Point_3& b = p[(i + 2) % 3];
      if (dot(a - p[i], b - p[i]) >= 0) continue;
      const Point_3 between = midpoint(a, b) - center;
      const double reach = length(between);
      if (radius - reach > deviation_) {
        if (reach > 0) middle = center + (radius / reach) * between;
        continue;
      }
      // It is narrow and near enough. But where its circle goes around more than half of the sphere, that half is
      // empty.
      if (height < 0) wanted.push_back({top, top, top});
      return;
    }
    const auto inner = middle_of_longest_side(face);
    wanted.push_back({top, middle, inner ? project_.inverse(*inner) : top});
  }

  /// Of the sides in the projection that may be divided; nullopt when there is none.
  static std::optional<Kernel::Point_2> middle_of_longest_side(const Face& face) {
    std::optional<Kernel::Point_2> middle;
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      const auto& a = face->vertex(Triangulation::cw(i))->point();
      const auto& b = face->vertex(Triangulation::ccw(i))->point();
      const double square = CGAL::squared_distance(a, b);
      if (face->is_constrained(i) || square <= most) continue;
      most = square;
      middle = CGAL::midpoint(a, b);
    }
    return middle;
  }

  /// False when it is outside of the patch. Points near to one that was inserted after the first `before` are left out:
  /// what wanted them may have changed.
  bool insert(const Point_3& p, std::size_t before) {
    const double spacing = 2 * patch_.ball.radius * deviation_ / 3;
    const Kernel::Point_2 projected = project_(p);
    if (!std::isfinite(projected.x()) || !std::isfinite(projected.y())) return false;
    // At the pole, where the patch is not, rounding could give any place.
    if (distance(project_.inverse(projected), p) > tiny_part * patch_.ball.radius) return false;
    Triangulation::Locate_type type{};
    int index = 0;
    const Face face = triangulation_.locate(projected, type, index);
    if (type != Triangulation::FACE && type != Triangulation::EDGE) return false;
    if (face->info().is_outside || (type == Triangulation::EDGE && face->is_constrained(index))) return false;
    for (const int corner : corners_of(face)) {
      if (corner >= static_cast<int>(before) && squared_distance(points_[corner], p) < spacing) return true;
    }
    const Vertex vertex = triangulation_.insert(projected, type, face, index);
    vertex->info() = static_cast<int>(points_.size());
    points_.push_back(p);
    return true;
  }

  const Sphere_patch_3& patch_;
  const Loop_nodes_3& nodes_;
  double deviation_;
  Stereographic_projection project_;
  Triangulation triangulation_;
  std::vector<Point_3> points_;
  std::vector<Vertex> vertices_;
  int boundary_count_ = 0;
};

/// One ring that runs through all loops, which are joined where they are nearest to each other, there and back.
std::vector<int> joined_loops(const Sphere_patch_3& patch, std::vector<Point_3>& points) {
  std::vector<std::vector<int>> rest;
  for (const auto& loop : patch.loops) {
    rest.emplace_back();
    for (const Point_3& p : loop) {
      rest.back().push_back(static_cast<int>(points.size()));
      points.push_back(p);
    }
  }
  std::vector<int> ring = std::move(rest.front());
  rest.erase(rest.begin());
  while (!rest.empty()) {
    double least = std::numeric_limits<double>::infinity();
    std::array<std::size_t, 3> best{};
    for (std::size_t r = 0; r < ring.size(); ++r) {
      for (std::size_t l = 0; l < rest.size(); ++l) {
        for (std::size_t i = 0; i < rest[l].size(); ++i) {
          const double d = squared_distance(points[ring[r]], points[rest[l][i]]);
          if (d < least) {
            least = d;
            best = {r, l, i};
          }
        }
      }
    }
    auto& loop = rest[best[1]];
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(best[2]), loop.end());
    loop.push_back(loop.front());
    loop.push_back(ring[best[0]]);
    ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(best[0]) + 1, loop.begin(), loop.end());
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(best[1]));
  }
  return ring;
}

/// Puts points of the sphere into the triangles: in place of a vertex, or into the triangle below.
void insert_on_sphere(const Ball_3& ball, const std::vector<Point_3>& added, const std::vector<Point_3>& vertices,
                      std::vector<std::array<int, 3>>& triangles) {
  const int count = static_cast<int>(added.size());
  const auto direction = [&](int i) { return (i < count ? added[i] : vertices[i - count]) - ball.center; };
  for (int i = 0; i < count; ++i) {
    const Point_3 up = direction(i);
    double most = -std::numeric_limits<double>::infinity();
    std::size_t below = 0;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& corners = triangles[t];
      double inside = std::numeric_limits<double>::infinity();
      for (int k = 0; k < 3; ++k)
        inside = std::min(inside, dot(up, cross(direction(corners[k]), direction(corners[(k + 1) % 3]))));
      if (inside <= most) continue;
      most = inside;
      below = t;
    }
    const auto [a, b, c] = triangles[below];
    for (const int old : {a, b, c}) {
      if (old < count || squared_distance(direction(old), up) > same_part * dot(up, up)) continue;
      for (auto& triangle : triangles) std::ranges::replace(triangle, old, i);
    }
    if (std::ranges::count(triangles[below], i) != 0) continue;
    triangles[below] = {a, b, i};
    triangles.push_back({b, c, i});
    triangles.push_back({c, a, i});
  }
}

/// A sphere that is touched in points only.
Patch_mesh_3 triangulate_touched_sphere(const Ball_3& ball, const Loop_nodes_3& nodes, double deviation) {
  Patch_mesh_3 result = triangulate_sphere(ball, deviation);
  const int count = static_cast<int>(nodes.points().size());
  for (auto& triangle : result.triangles)
    for (int& corner : triangle) corner += count;
  insert_on_sphere(ball, nodes.points(), result.inner_points, result.triangles);
  result.triangles = nodes.expanded(std::move(result.triangles));
  return result;
}

/// All loops are nearly points, and not because the balls around them have only so little of the sphere.
bool is_tiny(const Sphere_patch_3& patch) {
  const double limit = tiny_part * patch.ball.radius;
  return patch.cosine < 1 - tiny_part && std::ranges::all_of(patch.loops, [&](const std::vector<Point_3>& loop) {
           return std::ranges::all_of(loop, [&](const Point_3& p) { return distance(p, loop.front()) < limit; });
         });
}

}  // namespace

std::optional<Patch_mesh_3> triangulate_patch(const Sphere_patch_3& patch, double deviation) {
  const double radius = patch.ball.radius;
  // Loops are tiny holes only where nothing but tiny parts of the sphere, or another loop, is around the patch.
  const Loop_nodes_3 nodes(patch.loops, same_part * radius, is_tiny(patch) ? 0 : tiny_part * radius);
  if (nodes.loops().empty() && radius > 0) return triangulate_touched_sphere(patch.ball, nodes, deviation);
  if (auto mesh = Patch_triangulation(patch, nodes, deviation).run(false)) return mesh;
  if (nodes.has_touching_nodes()) return Patch_triangulation(patch, nodes, deviation).run(true);
  return std::nullopt;
}

Patch_mesh_3 fill_patch(const Sphere_patch_3& patch) {
  constexpr double reflex_weight = 16;
  std::vector<Point_3> points;
  std::vector<int> ring = joined_loops(patch, points);
  Patch_mesh_3 result;
  std::set<std::array<int, 2>> sides;
  const auto side = [](int a, int b) { return std::array<int, 2>{std::min(a, b), std::max(a, b)}; };
  for (std::size_t i = 0; i < ring.size(); ++i) sides.insert(side(ring[i], ring[(i + 1) % ring.size()]));
  // New sides first, convex corners before others, and then the shorter the side the better, so that thin patches are
  // closed like a zip.
  const auto cost = [&](int before, int corner, int after) {
    const Point_3 normal = cross(points[after] - points[corner], points[before] - points[corner]);
    const double weight = dot(normal, points[corner] - patch.ball.center) > 0 ? 1 : reflex_weight;
    return std::pair(sides.contains(side(before, after)), weight * squared_distance(points[before], points[after]));
  };
  while (ring.size() > 3) {
    std::size_t best = 0;
    std::pair<bool, double> least{true, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int before = ring[(i + ring.size() - 1) % ring.size()];
      const int after = ring[(i + 1) % ring.size()];
      if (before == after) continue;
      if (const auto value = cost(before, ring[i], after); value < least) {
        least = value;
        best = i;
      }
    }
    const int before = ring[(best + ring.size() - 1) % ring.size()];
    const int after = ring[(best + 1) % ring.size()];
    result.triangles.push_back({before, ring[best], after});
    sides.insert(side(before, after));
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
  }
  result.triangles.push_back({ring[0], ring[1], ring[2]});
  return result;
}

Patch_mesh_3 triangulate_sphere(const Ball_3& ball, double deviation) {
  constexpr double most_steps = 4096;
  const int steps = static_cast<int>(std::clamp(std::ceil(std::sqrt(ball.radius / deviation)), 1.0, most_steps));
  Patch_mesh_3 result;
  std::map<std::array<int, 3>, int> index;
  const auto vertex = [&](const std::array<int, 3>& place) {
    const auto [it, is_new] = index.emplace(place, static_cast<int>(result.inner_points.size()));
    if (is_new) {
      const Point_3 p{static_cast<double>(place[0]), static_cast<double>(place[1]), static_cast<double>(place[2])};
      result.inner_points.push_back(ball.center + (ball.radius / length(p)) * p);
    }
    return it->second;
  };
  for (int octant = 0; octant < 8; ++octant) {
    const std::array<int, 3> sign{(octant & 1) != 0 ? -1 : 1, (octant & 2) != 0 ? -1 : 1, (octant & 4) != 0 ? -1 : 1};
    const bool is_mirrored = sign[0] * sign[1] * sign[2] < 0;
    const auto at = [&](int i, int j) { return vertex({sign[0] * i, sign[1] * j, sign[2] * (steps - i - j)}); };
    const auto add = [&](int a, int b, int c) {
      if (is_mirrored) std::swap(b, c);
      result.triangles.push_back({a, b, c});
    };
    for (int i = 0; i < steps; ++i) {
      for (int j = 0; i + j < steps; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < steps) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
    }
  }
  return result;
}

}  // namespace mesecina
