// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/self_crossings_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Numbers = std::array<int, 3>;

Kernel::Point_3 convert(const Point_3& p) { return {p.x, p.y, p.z}; }

/// Whether some axis of a few shows that two triangles are apart, or have only a shared corner in common. Decides most
/// pairs, also those in one plane, for which exact arithmetic is slow. The corners are relative to the shared corner,
/// which comes first, or to any point near them.
bool are_surely_apart(const Corners_3& a, const Corners_3& b, bool share_first) {
  const auto largest = [](const Corners_3& t) {
    double result = 0;
    for (const Point_3& p : t) result = std::max({result, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return result;
  };
  // Far more than the rounding errors of the products; any axis will do, so its own errors do not matter.
  const double slack = 1e-14 * std::max(largest(a), largest(b));
  const auto is_separating = [&](const Point_3& axis) {
    std::array<double, 3> on_a{};
    std::array<double, 3> on_b{};
    for (std::size_t i = 0; i < 3; ++i) {
      on_a[i] = dot(axis, a[i]);
      on_b[i] = dot(axis, b[i]);
    }
    const double gap = slack * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
    if (share_first) {
      return (std::min(on_a[1], on_a[2]) > gap && std::max(on_b[1], on_b[2]) < -gap) ||
             (std::max(on_a[1], on_a[2]) < -gap && std::min(on_b[1], on_b[2]) > gap);
    }
    const auto [low_a, high_a] = std::ranges::minmax(on_a);
    const auto [low_b, high_b] = std::ranges::minmax(on_b);
    return low_a > high_b + gap || low_b > high_a + gap;
  };
  const auto direction = [&](const Corners_3& t) {
    const Point_3 sum = share_first ? t[1] + t[2] : t[0] + t[1] + t[2];
    const double length = share_first ? std::sqrt(dot(sum, sum)) : 1.0;
    return (1 / length) * sum;
  };
  if (is_separating(direction(a) - direction(b))) return true;
  const Point_3 normal_a = cross(a[1] - a[0], a[2] - a[0]);
  const Point_3 normal_b = cross(b[1] - b[0], b[2] - b[0]);
  if (!share_first && (is_separating(normal_a) || is_separating(normal_b))) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_separating(cross(normal_a, a[(i + 1) % 3] - a[i])) || is_separating(cross(normal_b, b[(i + 1) % 3] - b[i])))
      return true;
  }
  return false;
}

/// Relative to a point, its corner i first.
Corners_3 moved(const Corners_3& t, std::size_t i, const Point_3& origin) {
  return {t[i] - origin, t[(i + 1) % 3] - origin, t[(i + 2) % 3] - origin};
}

/// Triangles on both sides of an edge from the origin to p, with r and s across, are not folded onto each other.
bool are_surely_unfolded(const Point_3& p, const Point_3& r, const Point_3& s) {
  const Point_3 normal_r = cross(p, r);
  const Point_3 normal_s = cross(p, s);
  constexpr double slack = 1e-14;
  return dot(normal_r, normal_s) < -slack * dot(p, p) * std::sqrt(dot(r, r) * dot(s, s));
}

bool lie_on_one_side(const Corners_3& plane, const Point_3& p, const Point_3& q) {
  const auto side = [&](const Point_3& r) {
    return CGAL::orientation(convert(plane[0]), convert(plane[1]), convert(plane[2]), convert(r));
  };
  const CGAL::Orientation side_of_p = side(p);
  return side_of_p != CGAL::COPLANAR && side_of_p == side(q);
}

/// The edge of `a` across from corner i meets triangle b.
bool does_far_edge_meet(const Corners_3& a, std::size_t i, const Corners_3& b) {
  const Point_3& p = a[(i + 1) % 3];
  const Point_3& q = a[(i + 2) % 3];
  return CGAL::do_intersect(Kernel::Segment_3(convert(p), convert(q)),
                            Kernel::Triangle_3(convert(b[0]), convert(b[1]), convert(b[2])));
}

bool do_cross(const Corners_3& a, const Numbers& a_numbers, const Corners_3& b, const Numbers& b_numbers) {
  std::array<std::array<std::size_t, 2>, 3> shared{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (a_numbers[i] == b_numbers[j]) shared[count++] = {i, j};
  if (count == 0) {
    return !are_surely_apart(moved(a, 0, a[0]), moved(b, 0, a[0]), false) &&
           CGAL::do_intersect(Kernel::Triangle_3(convert(a[0]), convert(a[1]), convert(a[2])),
                              Kernel::Triangle_3(convert(b[0]), convert(b[1]), convert(b[2])));
  }
  if (count == 1) {
    const auto [i, j] = shared[0];
    if (are_surely_apart(moved(a, i, a[i]), moved(b, j, a[i]), true)) return false;
    if (lie_on_one_side(b, a[(i + 1) % 3], a[(i + 2) % 3]) || lie_on_one_side(a, b[(j + 1) % 3], b[(j + 2) % 3]))
      return false;
    return does_far_edge_meet(a, i, b) || does_far_edge_meet(b, j, a);
  }
  if (count == 2) {
    const Point_3& p = a[shared[0][0]];
    const Point_3& q = a[shared[1][0]];
    const Point_3& r = a[3 - shared[0][0] - shared[1][0]];
    const Point_3& s = b[3 - shared[0][1] - shared[1][1]];
    return !are_surely_unfolded(q - p, r - p, s - p) &&
           CGAL::orientation(convert(p), convert(q), convert(r), convert(s)) == CGAL::COPLANAR &&
           CGAL::coplanar_orientation(convert(p), convert(q), convert(r), convert(s)) == CGAL::POSITIVE;
  }
  return true;
}

}  // namespace

std::vector<std::array<int, 2>> find_self_crossings(const Triangle_mesh_3& mesh, const Surface_locator_3& locator,
                                                    std::size_t limit, Progress& progress) {
  const Box_tree_3& tree = locator.tree();
  const std::vector<Corners_3>& corners = locator.corners();
  constexpr std::size_t block = 512;
  const std::size_t blocks = (corners.size() + block - 1) / block;
  std::vector<std::vector<std::array<int, 2>>> found(blocks);
  std::atomic<std::size_t> total = 0;
  parallel_blocks(blocks, progress, [&](std::size_t b) {
    const std::size_t end = std::min(corners.size(), (b + 1) * block);
    for (std::size_t i = b * block; i < end && total < limit; ++i) {
      const Box box = box_of(corners[i]);
      const int own = tree.order()[i];
      tree.visit_from(
          static_cast<int>(i) + 1, [&](const Box& other) { return do_meet(box, other); },
          [&](int j) {
            if (!do_meet(box, box_of(corners[j]))) return true;
            const int other = tree.order()[j];
            if (do_cross(corners[i], mesh.triangles[own], corners[j], mesh.triangles[other])) {
              found[b].push_back({std::min(own, other), std::max(own, other)});
              return ++total < limit;
            }
            return true;
          });
    }
  });
  std::vector<std::array<int, 2>> result;
  for (const std::vector<std::array<int, 2>>& pairs : found) result.insert(result.end(), pairs.begin(), pairs.end());
  std::ranges::sort(result);
  return result;
}

}  // namespace mesecina
