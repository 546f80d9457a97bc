// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometries/parallel.h"
#include "geometries/union_3/meeting_point_3.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Long = long double;

struct Vector {
  Long x, y, z;
};
Vector difference(const Point_3& p, const Point_3& q) {
  return {Long(p.x) - Long(q.x), Long(p.y) - Long(q.y), Long(p.z) - Long(q.z)};
}
Long dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Vector cross(const Vector& u, const Vector& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// One vertex: a triangle of the dual complex and a side.
struct Name {
  int triangle = 0;
  bool is_above = false;
};

std::vector<Name> names_of_vertices(const Dual_3& dual) {
  std::vector<Name> names;
  for (std::size_t t = 0; t < dual.triangles.size(); ++t) {
    const Dual_3::Triangle& triangle = dual.triangles[t];
    for (int side = 0; side < 2; ++side)
      if (!dual.has_cell[triangle.cells[side]]) names.push_back({static_cast<int>(t), side == 1});
  }
  return names;
}

/// The one point of all spheres around a flat cell: its neighbours in the complex, whose power center is the same.
class Flat_classes {
 public:
  explicit Flat_classes(const Dual_3& dual) : dual_(dual), regular_(*dual.regular) {
    for (std::size_t c = 0; c < dual.is_flat.size(); ++c)
      if (dual.is_flat[c]) gather(static_cast<int>(c));
  }
  /// The class whose point is this vertex; -1 for none.
  int class_of(const Name& name) const {
    if (classes_.empty()) return -1;
    const Dual_3::Triangle& triangle = dual_.triangles[name.triangle];
    const int cell = triangle.cells[name.is_above ? 0 : 1];
    const auto it = classes_.find(cell);
    if (it == classes_.end() || !is_beyond(cell, triangle, name.is_above)) return -1;
    return it->second;
  }
  const std::vector<std::vector<int>>& balls() const { return balls_; }

 private:
  void gather(int seed) {
    if (classes_.contains(seed)) return;
    const int number = static_cast<int>(balls_.size());
    std::vector<int> found;
    std::vector<int> open{seed};
    classes_[seed] = number;
    while (!open.empty()) {
      const int cell = open.back();
      open.pop_back();
      for (const int ball : regular_.cells[cell]) found.push_back(ball);
      for (const int next : regular_.neighbors[cell]) {
        if (dual_.is_flat[next] && !classes_.contains(next) && is_same_point(cell, next)) {
          classes_[next] = number;
          open.push_back(next);
        }
      }
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    balls_.push_back(std::move(found));
  }
  bool is_same_point(int cell, int next) const {
    const auto& a = regular_.cells[cell];
    const auto& b = regular_.cells[next];
    for (const int ball : b) {
      if (std::ranges::count(a, ball) == 0)
        return Kernel().power_side_of_oriented_power_sphere_3_object()(weighted(a[0]), weighted(a[1]), weighted(a[2]),
                                                                       weighted(a[3]),
                                                                       weighted(ball)) == CGAL::ON_ORIENTED_BOUNDARY;
    }
    return true;
  }
  /// The power center of the cell lies across its triangle, on the side of the vertex, or in its plane.
  bool is_beyond(int cell, const Dual_3::Triangle& triangle, bool is_above) const {
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    const auto exact = [&](int ball) {
      const Ball_3& b = regular_.balls[ball];
      return Exact::Weighted_point_3({b.center.x, b.center.y, b.center.z}, b.radius * b.radius);
    };
    const auto& corners = regular_.cells[cell];
    const auto center =
        CGAL::weighted_circumcenter(exact(corners[0]), exact(corners[1]), exact(corners[2]), exact(corners[3]));
    const auto side = CGAL::orientation(exact(triangle.balls[0]).point(), exact(triangle.balls[1]).point(),
                                        exact(triangle.balls[2]).point(), center);
    return side != (is_above ? CGAL::NEGATIVE : CGAL::POSITIVE);
  }
  Kernel::Weighted_point_3 weighted(int ball) const {
    const Ball_3& b = regular_.balls[ball];
    return Kernel::Weighted_point_3({b.center.x, b.center.y, b.center.z}, b.radius * b.radius);
  }

  const Dual_3& dual_;
  const Regular_3& regular_;
  std::map<int, int> classes_;
  std::vector<std::vector<int>> balls_;
};

}  // namespace

Point_3 meeting_point(const Ball_3& a, const Ball_3& b, const Ball_3& c, bool is_above) {
  const Vector u = difference(b.center, a.center);
  const Vector v = difference(c.center, a.center);
  const Vector n = cross(u, v);
  const Long square = dot(n, n);
  // Digits that centers nearly on a line take away.
  constexpr Long worst = 1e-8L;
  if (square < worst * dot(u, u) * dot(v, v)) return exact_meeting_point(a, b, c, is_above);
  const Long weight = a.radius * a.radius;
  const Long along_u = (dot(u, u) + weight - Long(b.radius * b.radius)) / 2;
  const Long along_v = (dot(v, v) + weight - Long(c.radius * c.radius)) / 2;
  const Vector vn = cross(v, n);
  const Vector nu = cross(n, u);
  const Long s = along_u / square;
  const Long t = along_v / square;
  const Vector foot{s * vn.x + t * nu.x, s * vn.y + t * nu.y, s * vn.z + t * nu.z};
  const Long height_square = weight - dot(foot, foot);
  const Long height = (is_above ? 1 : -1) * std::sqrt(std::max(height_square, Long(0)) / square);
  return {static_cast<double>(a.center.x + foot.x + height * n.x),
          static_cast<double>(a.center.y + foot.y + height * n.y),
          static_cast<double>(a.center.z + foot.z + height * n.z)};
}

Union_vertices_3 union_vertices(std::shared_ptr<const Dual_3> dual, Progress& progress) {
  progress.begin_stage("vertices of the union");
  const std::vector<Name> names = names_of_vertices(*dual);
  const Flat_classes classes(*dual);
  std::vector<Name> kept;
  std::vector<int> class_of_kept;
  std::vector<std::uint8_t> is_seen(classes.balls().size(), 0);
  for (const Name& name : names) {
    const int number = classes.class_of(name);
    if (number >= 0 && std::exchange(is_seen[number], 1) != 0) continue;
    kept.push_back(name);
    class_of_kept.push_back(number);
  }
  Union_vertices_3 result;
  result.points.resize(kept.size());
  const auto& balls = dual->regular->balls;
  parallel_for(kept.size(), progress, [&](std::size_t i) {
    const auto& [a, b, c] = dual->triangles[kept[i].triangle].balls;
    result.points[i] = meeting_point(balls[a], balls[b], balls[c], kept[i].is_above);
  });
  const auto balls_of = [&](std::size_t i) -> std::span<const int> {
    if (class_of_kept[i] >= 0) return classes.balls()[class_of_kept[i]];
    return dual->triangles[kept[i].triangle].balls;
  };
  std::vector<Meeting_name_3> meetings;
  meetings.reserve(kept.size());
  for (const Name& name : kept) meetings.push_back({dual->triangles[name.triangle].balls, name.is_above});
  const std::vector<int> first = first_of_same_points(balls, meetings, result.points, progress);
  std::map<int, std::vector<int>> others;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (first[i] != static_cast<int>(i)) others[first[i]].push_back(static_cast<int>(i));
  std::vector<Point_3> points;
  points.reserve(kept.size());
  result.ball_offsets.reserve(kept.size() + 1);
  result.ball_offsets.push_back(0);
  std::vector<int> all;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (first[i] != static_cast<int>(i)) continue;
    const auto own = balls_of(i);
    all.assign(own.begin(), own.end());
    if (const auto it = others.find(static_cast<int>(i)); it != others.end()) {
      for (const int other : it->second) {
        const auto more = balls_of(other);
        all.insert(all.end(), more.begin(), more.end());
      }
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    points.push_back(result.points[i]);
    result.balls.insert(result.balls.end(), all.begin(), all.end());
    result.ball_offsets.push_back(static_cast<int>(result.balls.size()));
  }
  result.points = std::move(points);
  result.dual = std::move(dual);
  return result;
}

}  // namespace mesecina
