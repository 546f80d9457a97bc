// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/evolutions_2/lloyd_2.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/labels_2/labels_2.h"
#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Hull_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Where normal . x <= offset.
struct Half_plane {
  Point_2 normal;
  double offset = 0;
  double excess(const Point_2& p) const { return normal.x * p.x + normal.y * p.y - offset; }
};

/// Its boundary may run to and fro along the line where the ring is not convex; its signed area is right all the same.
Ring_2 clipped(const Ring_2& ring, const Half_plane& side) {
  Ring_2 result;
  if (ring.empty()) return result;
  result.reserve(ring.size() + 2);
  Point_2 before = ring.back();
  double before_excess = side.excess(before);
  for (const Point_2& p : ring) {
    const double excess = side.excess(p);
    if ((before_excess < 0 && excess > 0) || (before_excess > 0 && excess < 0)) {
      const double part = before_excess / (before_excess - excess);
      result.push_back({before.x + part * (p.x - before.x), before.y + part * (p.y - before.y)});
    }
    if (excess <= 0) result.push_back(p);
    before = p;
    before_excess = excess;
  }
  if (result.size() < 3) result.clear();
  return result;
}

Ring_2 clipped(Ring_2 ring, const Box& box) {
  ring = clipped(ring, Half_plane{{1, 0}, box.upper.x});
  ring = clipped(ring, Half_plane{{-1, 0}, -box.lower.x});
  ring = clipped(ring, Half_plane{{0, 1}, box.upper.y});
  return clipped(ring, Half_plane{{0, -1}, -box.lower.y});
}

Ring_2 corners(const Box& box) {
  return {
      {box.lower.x, box.lower.y}, {box.upper.x, box.lower.y}, {box.upper.x, box.upper.y}, {box.lower.x, box.upper.y}};
}

/// Area, and integrals of the coordinates relative to an origin.
struct Integrals {
  double area = 0;
  double x = 0;
  double y = 0;

  void add(const Ring_2& ring, const Point_2& origin, double factor) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point_2& next = ring[i + 1 < ring.size() ? i + 1 : 0];
      const Point_2 p{ring[i].x - origin.x, ring[i].y - origin.y};
      const Point_2 q{next.x - origin.x, next.y - origin.y};
      const double twice = factor * (p.x * q.y - p.y * q.x);
      area += twice / 2;
      x += (p.x + q.x) * twice / 6;
      y += (p.y + q.y) * twice / 6;
    }
  }
};

/// Sites with so many neighbours, and cells with so many corners, are dealt with in ways that take longer for fewer.
constexpr std::size_t many_sides = 48;

struct Site {
  int point = 0;
  Ring_2 cell;  ///< convex, counterclockwise; empty where the cell does not meet the box of the domain
};

std::vector<std::vector<int>> neighbors_of_sites(const Delaunay_2& triangulation) {
  std::vector<std::vector<int>> neighbors(triangulation.points.size());
  const auto join = [&](int p, int q) {
    neighbors[p].push_back(q);
    neighbors[q].push_back(p);
  };
  for (const auto& [a, b, c] : triangulation.triangles) {
    join(a, b);
    join(b, c);
    join(c, a);
  }
  for (std::size_t i = 0; i + 1 < triangulation.line.size(); ++i)
    join(triangulation.line[i], triangulation.line[i + 1]);
  for (auto& list : neighbors) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return neighbors;
}

/// The cell of a site with many neighbours in O(n log n): of half-planes u . x <= 1 around the site, those that bound
/// their intersection have the corners of the convex hull of all u. Nullopt where rounding does not allow it.
std::optional<Ring_2> cell_of_many(const Point_2& p, const std::vector<Half_plane>& sides, const Box& box) {
  // An end beyond the box.
  double reach = 0;
  for (const Point_2& corner : corners(box)) reach = std::max(reach, 2 * distance(p, corner));
  std::vector<Hull_kernel::Point_2> duals{{1 / reach, 0}, {0, 1 / reach}, {-1 / reach, 0}, {0, -1 / reach}};
  for (const Half_plane& side : sides) {
    const double scale = -1 / side.excess(p);
    if (!(scale > 0 && std::isfinite(scale))) return std::nullopt;
    duals.emplace_back(scale * side.normal.x, scale * side.normal.y);
  }
  std::vector<Hull_kernel::Point_2> hull;
  CGAL::convex_hull_2(duals.begin(), duals.end(), std::back_inserter(hull));
  Ring_2 cell;
  cell.reserve(hull.size());
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const auto& u = hull[i];
    const auto& v = hull[i + 1 < hull.size() ? i + 1 : 0];
    const double turn = u.x() * v.y() - u.y() * v.x();
    if (!(turn > 0)) return std::nullopt;
    cell.push_back({p.x + (v.y() - u.y()) / turn, p.y + (u.x() - v.x()) / turn});
  }
  return clipped(std::move(cell), box);
}

Ring_2 cell_in_box(const Point_2& p, const std::vector<Half_plane>& sides, const Box& box) {
  if (sides.size() >= many_sides)
    if (std::optional<Ring_2> cell = cell_of_many(p, sides, box)) return *std::move(cell);
  Ring_2 cell = corners(box);
  for (const Half_plane& side : sides) cell = clipped(cell, side);
  return cell;
}

std::vector<Site> cells_in_box(const Delaunay_2& triangulation, const Box& box, Progress& progress) {
  std::vector<Site> sites;
  sites.reserve(triangulation.site_count);
  for (int p = 0; p < static_cast<int>(triangulation.points.size()); ++p)
    if (triangulation.site[p] == p) sites.push_back({p, {}});
  const auto neighbors = neighbors_of_sites(triangulation);
  parallel_for(sites.size(), progress, [&](std::size_t s) {
    Site& site = sites[s];
    const Point_2& p = triangulation.points[site.point];
    std::vector<Half_plane> sides;
    for (const int neighbor : neighbors[site.point]) {
      const Point_2& q = triangulation.points[neighbor];
      const Point_2 normal{q.x - p.x, q.y - p.y};
      const Point_2 middle = midpoint(p, q);
      sides.push_back({normal, normal.x * middle.x + normal.y * middle.y});
    }
    site.cell = cell_in_box(p, sides, box);
  });
  return sites;
}

Point_2 centroid(const Integrals& integrals, const Point_2& p, const Box& cell_box) {
  const double smallest = std::numeric_limits<double>::min();
  if (!(integrals.area > smallest)) return p;
  const Point_2 result{p.x + integrals.x / integrals.area, p.y + integrals.y / integrals.area};
  // Rounding of parts that nearly cancel, or rings that cross, must not throw a point out of its cell.
  const bool is_in_box = result.x >= cell_box.lower.x && result.x <= cell_box.upper.x && result.y >= cell_box.lower.y &&
                         result.y <= cell_box.upper.y;
  return is_in_box ? result : p;
}

Box box_of(const Ring_2& ring) {
  Box box;
  for (const Point_2& p : ring) box.add(p);
  return box;
}

/// Equal points go where their site goes.
std::vector<Point_2> for_all_points(const Delaunay_2& triangulation, std::vector<Point_2> of_sites) {
  for (std::size_t p = 0; p < of_sites.size(); ++p) of_sites[p] = of_sites[triangulation.site[p]];
  return of_sites;
}

/// A ring of the domain, or what is left of it.
struct Part {
  Ring_2 ring;
  double sign = 1;  ///< of its signed area in that of the domain
};

/// Oriented by how deep they are: holes take away what they surround.
std::vector<Part> parts_of(const Outline_2& domain, Progress& progress) {
  std::vector<Point_2> left_of_rings;
  for (const Ring_2& ring : domain.rings) {
    if (ring.size() < 3) continue;
    const Point_2 leftmost = *std::ranges::min_element(ring, {}, [](const Point_2& p) { return std::pair{p.x, p.y}; });
    left_of_rings.push_back({std::nextafter(leftmost.x, -std::numeric_limits<double>::infinity()), leftmost.y});
  }
  const std::vector<std::uint8_t> is_hole = is_inside(domain, left_of_rings, progress);
  std::vector<Part> parts;
  for (const Ring_2& ring : domain.rings) {
    if (ring.size() < 3) continue;
    Integrals whole;
    whole.add(ring, ring.front(), 1);
    const bool is_clockwise = whole.area < 0;
    parts.push_back({ring, is_clockwise != (is_hole[parts.size()] != 0) ? -1.0 : 1.0});
  }
  return parts;
}

/// Divides sites in two again and again, and takes to each half only what of the domain is near it.
class Divider {
 public:
  Divider(const std::vector<Point_2>& points, std::vector<Site> sites, Progress& progress)
      : points_(points), sites_(std::move(sites)), centroids_(points), progress_(progress) {}

  /// Per site's point the centroid of the parts in its cell.
  std::vector<Point_2> centroids(const std::vector<Part>& parts) && {
    divide(0, sites_.size(), parts);
    return std::move(centroids_);
  }

 private:
  void divide(std::size_t begin, std::size_t end, const std::vector<Part>& parts) {
    progress_.check();
    if (end - begin <= 1) {
      if (begin != end) integrate(sites_[begin], parts);
      return;
    }
    Box of_cells;
    Box of_points;
    for (std::size_t s = begin; s < end; ++s) {
      of_cells.add(box_of(sites_[s].cell));
      of_points.add(points_[sites_[s].point]);
    }
    if (of_cells.is_empty()) return;
    std::vector<Part> near;
    for (const Part& part : parts)
      if (Ring_2 ring = clipped(part.ring, of_cells); !ring.empty()) near.push_back({std::move(ring), part.sign});
    if (near.empty()) return;
    const bool is_wide = of_points.upper.x - of_points.lower.x > of_points.upper.y - of_points.lower.y;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) { return sites_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](const Site& s, const Site& t) {
      const Point_2& p = points_[s.point];
      const Point_2& q = points_[t.point];
      return std::tuple(is_wide ? p.x : p.y, s.point) < std::tuple(is_wide ? q.x : q.y, t.point);
    });
    divide(begin, middle, near);
    divide(middle, end, near);
  }

  void integrate(const Site& site, const std::vector<Part>& parts) {
    Integrals integrals;
    integrate(site.cell, parts, points_[site.point], integrals);
    centroids_[site.point] = centroid(integrals, points_[site.point], box_of(site.cell));
  }

  /// Adds what of the parts is in the convex cell. One with many corners is cut in two, and so are the parts.
  static void integrate(std::span<const Point_2> cell, const std::vector<Part>& parts, const Point_2& origin,
                        Integrals& integrals) {
    if (parts.empty()) return;
    if (cell.size() >= many_sides) {
      const std::size_t middle = cell.size() / 2;
      const auto first = cell.first(middle + 1);
      Ring_2 second(cell.begin() + static_cast<std::ptrdiff_t>(middle), cell.end());
      second.push_back(cell.front());
      integrate(first, left_of(parts, cell[middle], cell[0]), origin, integrals);
      integrate(second, left_of(parts, cell[0], cell[middle]), origin, integrals);
      return;
    }
    for (const Part& part : parts) {
      Ring_2 ring = part.ring;
      for (std::size_t i = 0; i < cell.size() && !ring.empty(); ++i)
        ring = clipped(ring, left_half_plane(cell[i], cell[i + 1 < cell.size() ? i + 1 : 0]));
      integrals.add(ring, origin, part.sign);
    }
  }

  static Half_plane left_half_plane(const Point_2& a, const Point_2& b) {
    const Point_2 normal{b.y - a.y, a.x - b.x};
    return {normal, normal.x * a.x + normal.y * a.y};
  }

  static std::vector<Part> left_of(const std::vector<Part>& parts, const Point_2& a, const Point_2& b) {
    std::vector<Part> left;
    for (const Part& part : parts)
      if (Ring_2 ring = clipped(part.ring, left_half_plane(a, b)); !ring.empty())
        left.push_back({std::move(ring), part.sign});
    return left;
  }

  const std::vector<Point_2>& points_;
  std::vector<Site> sites_;
  std::vector<Point_2> centroids_;
  Progress& progress_;
};

}  // namespace

std::vector<Point_2> cell_centroids(std::span<const Point_2> points, const Outline_2& domain, Progress& progress) {
  const Delaunay_2 triangulation = delaunay(points, progress);
  Box box;
  for (const Ring_2& ring : domain.rings) box.add(box_of(ring));
  if (box.is_empty()) return {points.begin(), points.end()};
  Divider divider(triangulation.points, cells_in_box(triangulation, box, progress), progress);
  return for_all_points(triangulation, std::move(divider).centroids(parts_of(domain, progress)));
}

std::vector<Point_2> cell_centroids(std::span<const Point_2> points, const Box& domain, Progress& progress) {
  const Delaunay_2 triangulation = delaunay(points, progress);
  std::vector<Point_2> centroids = triangulation.points;
  for (const Site& site : cells_in_box(triangulation, domain, progress)) {
    Integrals integrals;
    integrals.add(site.cell, triangulation.points[site.point], 1);
    centroids[site.point] = centroid(integrals, triangulation.points[site.point], box_of(site.cell));
  }
  return for_all_points(triangulation, std::move(centroids));
}

}  // namespace mesecina
