// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/power_crust_3/delaunay_oracle_3.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace mesecina::test {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Kernel::Point_3 exact(const Point_3& p) { return {p.x, p.y, p.z}; }

/// The first points that are different from all before them.
std::vector<int> different(const Cloud& points) {
  std::vector<int> result;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
    if (std::ranges::none_of(result, [&](int j) { return points[i] == points[j]; })) result.push_back(i);
  return result;
}

Kernel::Point_3 center_of(const Cloud& points, const Contacts& sphere) {
  const auto p = exact(points[sphere[0]]);
  for (const int b : sphere) {
    for (const int c : sphere) {
      for (const int d : sphere) {
        if (b < c && c < d && !CGAL::coplanar(p, exact(points[b]), exact(points[c]), exact(points[d])))
          return CGAL::circumcenter(p, exact(points[b]), exact(points[c]), exact(points[d]));
      }
    }
  }
  return p;
}

}  // namespace

std::set<Contacts> empty_spheres(const Cloud& points) {
  const std::vector<int> sites = different(points);
  std::set<Contacts> result;
  const int count = static_cast<int>(sites.size());
  const auto at = [&](int i) { return exact(points[sites[i]]); };
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      for (int c = b + 1; c < count; ++c) {
        for (int d = c + 1; d < count; ++d) {
          if (CGAL::coplanar(at(a), at(b), at(c), at(d))) continue;
          Contacts contacts;
          bool is_empty = true;
          for (int e = 0; e < count && is_empty; ++e) {
            const auto side = CGAL::side_of_bounded_sphere(at(a), at(b), at(c), at(d), at(e));
            is_empty = side != CGAL::ON_BOUNDED_SIDE;
            if (side == CGAL::ON_BOUNDARY) contacts.push_back(sites[e]);
          }
          if (is_empty) result.insert(contacts);
        }
      }
    }
  }
  return result;
}

bool is_on_hull(const Cloud& points, int a, int b) {
  const auto p = exact(points[a]);
  const auto has_bare_side = [&](const Kernel::Point_3& q, const Kernel::Point_3& r) {
    if (CGAL::collinear(p, q, r)) return false;
    bool has_above = false;
    bool has_below = false;
    for (const Point_3& s : points) {
      const auto side = CGAL::orientation(p, q, r, exact(s));
      has_above = has_above || side == CGAL::POSITIVE;
      has_below = has_below || side == CGAL::NEGATIVE;
    }
    return !has_above || !has_below;
  };
  for (const Point_3& q : points) {
    if (a != b) {
      if (has_bare_side(exact(points[b]), exact(q))) return true;
      continue;
    }
    for (const Point_3& r : points)
      if (has_bare_side(exact(q), exact(r))) return true;
  }
  return false;
}

std::set<Contacts> spheres_of(const Delaunay_3& triangulation) {
  Progress progress;
  const std::vector<int> sphere = cells_by_sphere(triangulation, progress);
  std::map<int, std::set<int>> contacts;
  for (std::size_t c = 0; c < triangulation.cells.size(); ++c)
    contacts[sphere[c]].insert(triangulation.cells[c].begin(), triangulation.cells[c].end());
  std::set<Contacts> result;
  for (const auto& [cell, points] : contacts) result.insert(Contacts(points.begin(), points.end()));
  return result;
}

bool has_larger_radius(const Cloud& points, const Contacts& one, const Contacts& other) {
  return CGAL::squared_distance(center_of(points, one), exact(points[one[0]])) >
         CGAL::squared_distance(center_of(points, other), exact(points[other[0]]));
}

bool are_opposite(const Cloud& points, int from, const Contacts& one, const Contacts& other) {
  const auto p = exact(points[from]);
  return (center_of(points, one) - p) * (center_of(points, other) - p) < 0;
}

double radius_of(const Cloud& points, const Contacts& sphere) {
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(center_of(points, sphere), exact(points[sphere[0]]))));
}

}  // namespace mesecina::test
