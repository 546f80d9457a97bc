// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/self_crossings_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <atomic>

#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Numbers = std::array<int, 3>;

Kernel::Point_3 convert(const Point_3& p) { return {p.x, p.y, p.z}; }

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
    return CGAL::do_intersect(Kernel::Triangle_3(convert(a[0]), convert(a[1]), convert(a[2])),
                              Kernel::Triangle_3(convert(b[0]), convert(b[1]), convert(b[2])));
  }
  if (count == 1) {
    const auto [i, j] = shared[0];
    if (lie_on_one_side(b, a[(i + 1) % 3], a[(i + 2) % 3]) || lie_on_one_side(a, b[(j + 1) % 3], b[(j + 2) % 3]))
      return false;
    return does_far_edge_meet(a, i, b) || does_far_edge_meet(b, j, a);
  }
  if (count == 2) {
    const Kernel::Point_3 p = convert(a[shared[0][0]]);
    const Kernel::Point_3 q = convert(a[shared[1][0]]);
    const Kernel::Point_3 r = convert(a[3 - shared[0][0] - shared[1][0]]);
    const Kernel::Point_3 s = convert(b[3 - shared[0][1] - shared[1][1]]);
    return CGAL::orientation(p, q, r, s) == CGAL::COPLANAR && CGAL::coplanar_orientation(p, q, r, s) == CGAL::POSITIVE;
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
