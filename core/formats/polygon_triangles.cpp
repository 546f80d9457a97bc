// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/polygon_triangles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace mesecina {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The polygon in the coordinate plane in which it has the largest area, turned counterclockwise.
std::vector<Kernel::Point_2> projected(const Triangle_mesh_3& mesh, std::span<const int> polygon) {
  Point_3 normal;
  const Point_3& origin = mesh.vertices[polygon[0]];
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    normal = normal + cross(mesh.vertices[polygon[i]] - origin, mesh.vertices[polygon[i + 1]] - origin);
  const double x = std::abs(normal.x);
  const double y = std::abs(normal.y);
  const double z = std::abs(normal.z);
  std::vector<Kernel::Point_2> points;
  points.reserve(polygon.size());
  for (const int vertex : polygon) {
    const Point_3& p = mesh.vertices[vertex];
    if (z >= x && z >= y)
      points.emplace_back(normal.z < 0 ? -p.x : p.x, p.y);
    else if (y >= x)
      points.emplace_back(normal.y < 0 ? -p.z : p.z, p.x);
    else
      points.emplace_back(normal.x < 0 ? -p.y : p.y, p.z);
  }
  return points;
}

/// Whether it turns left everywhere, and around once.
bool is_convex(const std::vector<Kernel::Point_2>& points) {
  const std::size_t count = points.size();
  int reversals = 0;
  CGAL::Comparison_result last = CGAL::EQUAL;
  CGAL::Comparison_result first = CGAL::EQUAL;
  for (std::size_t i = 0; i < count; ++i) {
    const Kernel::Point_2& p = points[i];
    const Kernel::Point_2& q = points[(i + 1) % count];
    if (CGAL::orientation(p, q, points[(i + 2) % count]) == CGAL::RIGHT_TURN) return false;
    const CGAL::Comparison_result direction = CGAL::compare_x(p, q);
    if (direction == CGAL::EQUAL) continue;
    if (first == CGAL::EQUAL) first = direction;
    if (last != CGAL::EQUAL && direction != last) ++reversals;
    last = direction;
  }
  if (first != last) ++reversals;
  return reversals <= 2;
}

/// Cuts ears off a polygon: corners that turn left, and whose triangle holds no other corner. What has no ears, which a
/// polygon that does not cross itself never comes to, is cut as a fan.
class Ear_cutter {
 public:
  explicit Ear_cutter(const std::vector<Kernel::Point_2>& points)
      : points_(points), left_(static_cast<int>(points.size())) {
    for (int i = 0; i < left_; ++i) {
      previous_.push_back(i == 0 ? left_ - 1 : i - 1);
      next_.push_back(i + 1 == left_ ? 0 : i + 1);
    }
  }

  /// Calls use(a, b, c) for each triangle.
  template <class Use>
  void cut(const Use& use) {
    // A cut makes ears only of the corners beside it, and of some whose triangle was touched by the corner cut off.
    constexpr int most_rounds = 8;
    int corner = 0;
    for (int round = 0, before = left_ + 1; round < most_rounds && left_ > 3 && left_ < before; ++round) {
      before = left_;
      corner = cut_ears(corner, use);
    }
    for (; left_ > 2; corner = next_[corner]) cut_off(corner, use);
  }

 private:
  /// Looks at all corners from this one on, and again at those beside a cut. Gives one that is left.
  template <class Use>
  int cut_ears(int corner, const Use& use) {
    std::vector<int> candidates;
    for (int i = 0; i < left_; ++i, corner = next_[corner]) candidates.push_back(corner);
    int remaining = corner;
    for (std::size_t i = 0; i < candidates.size() && left_ > 3; ++i) {
      const int candidate = candidates[i];
      if (next_[candidate] == gone || !is_ear(candidate)) continue;
      candidates.push_back(previous_[candidate]);
      candidates.push_back(next_[candidate]);
      remaining = next_[candidate];
      cut_off(candidate, use);
      next_[candidate] = gone;
    }
    return remaining;
  }

  template <class Use>
  void cut_off(int corner, const Use& use) {
    use(previous_[corner], corner, next_[corner]);
    next_[previous_[corner]] = next_[corner];
    previous_[next_[corner]] = previous_[corner];
    --left_;
  }

  bool is_ear(int corner) const {
    const Kernel::Point_2& a = points_[previous_[corner]];
    const Kernel::Point_2& b = points_[corner];
    const Kernel::Point_2& c = points_[next_[corner]];
    if (CGAL::orientation(a, b, c) != CGAL::LEFT_TURN) return false;
    const auto [left, right] = std::minmax({a.x(), b.x(), c.x()});
    const auto [bottom, top] = std::minmax({a.y(), b.y(), c.y()});
    for (int other = next_[next_[corner]]; other != previous_[corner]; other = next_[other]) {
      const Kernel::Point_2& p = points_[other];
      if (p.x() < left || p.x() > right || p.y() < bottom || p.y() > top || p == a || p == b || p == c) continue;
      if (CGAL::orientation(a, b, p) != CGAL::RIGHT_TURN && CGAL::orientation(b, c, p) != CGAL::RIGHT_TURN &&
          CGAL::orientation(c, a, p) != CGAL::RIGHT_TURN)
        return false;
    }
    return true;
  }

  static constexpr int gone = -1;

  const std::vector<Kernel::Point_2>& points_;
  int left_;
  std::vector<int> previous_;
  std::vector<int> next_;
};

}  // namespace

bool append_triangles(Triangle_mesh_3& mesh, std::span<const int> polygon) {
  if (polygon.size() == 3) {
    mesh.triangles.push_back({polygon[0], polygon[1], polygon[2]});
    return true;
  }
  const std::vector<Kernel::Point_2> points = projected(mesh, polygon);
  if (is_convex(points)) {
    for (std::size_t i = 2; i < polygon.size(); ++i) mesh.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
    return true;
  }
  if (polygon.size() > most_corners_of_nonconvex_polygons) return false;
  Ear_cutter(points).cut([&](int a, int b, int c) { mesh.triangles.push_back({polygon[a], polygon[b], polygon[c]}); });
  return true;
}

}  // namespace mesecina
