// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/oracles.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <utility>

#include "tests/geometries/results.h"

namespace mesecina::test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 cgal(const Point_2& p) { return {p.x, p.y}; }

Rational cross(const Exact_point& origin, const Exact_point& p, const Exact_point& q) {
  return (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
}
Rational dot(const Exact_point& origin, const Exact_point& p, const Exact_point& q) {
  return (p.x - origin.x) * (q.x - origin.x) + (p.y - origin.y) * (q.y - origin.y);
}
int sign(const Rational& value) { return static_cast<int>(CGAL::sign(value)); }

bool lexicographically_less(const Point_2& p, const Point_2& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

testing::AssertionResult sites_are_right(const Delaunay_2& d, std::span<const Point_2> points) {
  if (!std::ranges::equal(d.points, points)) return failure() << "points are not those given";
  if (d.site.size() != points.size()) return failure() << d.site.size() << " sites for " << points.size();
  std::map<std::pair<double, double>, int> first;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int expected = first.try_emplace({points[i].x, points[i].y}, static_cast<int>(i)).first->second;
    if (d.site[i] != expected) return failure() << "site of " << i << " is " << d.site[i] << ", not " << expected;
  }
  if (d.site_count != first.size()) return failure() << "site_count " << d.site_count << ", not " << first.size();
  return testing::AssertionSuccess();
}

std::vector<int> distinct_sites(const Delaunay_2& d) {
  std::vector<int> result;
  for (std::size_t i = 0; i < d.points.size(); ++i)
    if (d.site[i] == static_cast<int>(i)) result.push_back(static_cast<int>(i));
  return result;
}

int expected_dimension(const Delaunay_2& d, const std::vector<int>& sites) {
  if (sites.size() < 2) return static_cast<int>(sites.size()) - 1;
  for (std::size_t i = 2; i < sites.size(); ++i)
    if (orientation(d.points[sites[0]], d.points[sites[1]], d.points[sites[i]]) != 0) return 2;
  return 1;
}

testing::AssertionResult line_is_right(const Delaunay_2& d, const std::vector<int>& sites) {
  std::vector<int> sorted = d.line;
  std::ranges::sort(sorted);
  if (sorted != sites) return failure() << "the line does not hold every site once";
  const auto less = [&](int i, int j) { return lexicographically_less(d.points[i], d.points[j]); };
  if (!std::ranges::is_sorted(d.line, less) && !std::is_sorted(d.line.rbegin(), d.line.rend(), less))
    return failure() << "the line is not in order";
  return testing::AssertionSuccess();
}

testing::AssertionResult triangles_are_linked(const Delaunay_2& d, std::map<int, int>& next_on_hull) {
  const int count = static_cast<int>(d.triangles.size());
  if (d.neighbors.size() != d.triangles.size()) return failure() << "as many neighbors as triangles are needed";
  for (int t = 0; t < count; ++t) {
    const Triangle& corners = d.triangles[t];
    for (const int corner : corners) {
      if (corner < 0 || corner >= static_cast<int>(d.points.size()) || d.site[corner] != corner)
        return failure() << "triangle " << t << " has corner " << corner << ", which is no site";
    }
    if (orientation(d.points[corners[0]], d.points[corners[1]], d.points[corners[2]]) <= 0)
      return failure() << "triangle " << t << " is not counterclockwise";
    for (int i = 0; i < 3; ++i) {
      const int n = d.neighbors[t][i];
      const auto [p, q] = d.edge(t, i);
      if (n == -1) {
        if (!next_on_hull.try_emplace(p, q).second) return failure() << "two hull edges leave point " << p;
        if (!d.edge_is_listed(t, i)) return failure() << "a hull edge of triangle " << t << " is not listed";
        continue;
      }
      if (n < 0 || n >= count || n == t) return failure() << "triangle " << t << " has neighbour " << n;
      const int mirror = d.mirror_corner(t, i);
      if (d.neighbors[n][mirror] != t || d.edge(n, mirror) != Edge{q, p})
        return failure() << "triangles " << t << " and " << n << " do not agree on their edge";
      if (d.edge_is_listed(t, i) == d.edge_is_listed(n, mirror))
        return failure() << "edge " << p << " " << q << " is not listed once";
    }
  }
  return testing::AssertionSuccess();
}

/// One closed, convex, once winding boundary: with counterclockwise triangles linked along edges that means that
/// the triangles cover the hull exactly once.
testing::AssertionResult hull_is_convex(const Delaunay_2& d, const std::map<int, int>& next_on_hull) {
  if (next_on_hull.empty()) return failure() << "there is no hull";
  std::set<int> seen;
  int leftmost_turns = 0;
  int p = next_on_hull.begin()->first;
  while (seen.insert(p).second) {
    const auto q = next_on_hull.find(next_on_hull.at(p));
    if (q == next_on_hull.end()) return failure() << "the hull is not closed";
    const auto r = q->second;
    const int turn = orientation(d.points[p], d.points[q->first], d.points[r]);
    if (turn < 0) return failure() << "the hull is not convex at point " << q->first;
    const bool falls = lexicographically_less(d.points[q->first], d.points[p]);
    const bool rises = lexicographically_less(d.points[q->first], d.points[r]);
    if (turn == 0 && falls == rises) return failure() << "the hull turns back at point " << q->first;
    if (falls && rises) ++leftmost_turns;
    p = q->first;
  }
  if (seen.size() != next_on_hull.size()) return failure() << "the hull has several parts";
  if (leftmost_turns != 1) return failure() << "the hull winds " << leftmost_turns << " times";
  return testing::AssertionSuccess();
}

testing::AssertionResult circles_are_empty(const Delaunay_2& d, const std::vector<int>& sites) {
  constexpr std::size_t brute_force_limit = 300;
  for (std::size_t t = 0; t < d.triangles.size(); ++t) {
    const auto& [a, b, c] = d.triangles[t];
    const auto contains = [&](int s) { return in_circle(d.points[a], d.points[b], d.points[c], d.points[s]) > 0; };
    if (sites.size() <= brute_force_limit) {
      for (const int s : sites)
        if (s != a && s != b && s != c && contains(s)) return failure() << "point " << s << " is in circle " << t;
      continue;
    }
    for (int i = 0; i < 3; ++i) {
      const int n = d.neighbors[t][i];
      if (n == -1) continue;
      const int s = d.triangles[n][d.mirror_corner(static_cast<int>(t), i)];
      if (contains(s)) return failure() << "point " << s << " is in circle " << t;
    }
  }
  return testing::AssertionSuccess();
}

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

}  // namespace

Exact_point exact(const Point_2& p) { return {Rational(p.x), Rational(p.y)}; }

int orientation(const Point_2& p, const Point_2& q, const Point_2& r) {
  return static_cast<int>(CGAL::orientation(cgal(p), cgal(q), cgal(r)));
}

int in_circle(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d) {
  return static_cast<int>(CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d)));
}

int in_circle_by_rationals(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d) {
  const Exact_point o = exact(d);
  const auto lifted = [&](const Point_2& p) {
    const Rational x = Rational(p.x) - o.x;
    const Rational y = Rational(p.y) - o.y;
    return std::array<Rational, 3>{x, y, x * x + y * y};
  };
  const auto u = lifted(a);
  const auto v = lifted(b);
  const auto w = lifted(c);
  return sign(u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
              u[2] * (v[0] * w[1] - v[1] * w[0]));
}

bool is_on_segment(const Point_2& p, const Point_2& q, const Point_2& r) {
  return orientation(p, q, r) == 0 && std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) &&
         std::min(p.y, q.y) <= r.y && r.y <= std::max(p.y, q.y);
}

Exact_point exact_circumcenter(const Point_2& p, const Point_2& q, const Point_2& r) {
  const Exact_point o = exact(p);
  const Rational ux = Rational(q.x) - o.x;
  const Rational uy = Rational(q.y) - o.y;
  const Rational vx = Rational(r.x) - o.x;
  const Rational vy = Rational(r.y) - o.y;
  const Rational u2 = ux * ux + uy * uy;
  const Rational v2 = vx * vx + vy * vy;
  const Rational area = 2 * (ux * vy - uy * vx);
  return {o.x + (u2 * vy - v2 * uy) / area, o.y + (v2 * ux - u2 * vx) / area};
}

bool exact_is_crust_edge(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& s) {
  const Exact_point a = exact(p);
  const Exact_point b = exact(q);
  const Exact_point c = exact(r);
  const Exact_point d = exact(s);
  return dot(c, a, b) * dot(d, a, b) >= CGAL::abs(cross(c, a, b)) * CGAL::abs(cross(d, a, b));
}

bool exact_is_crust_hull_edge(const Point_2& p, const Point_2& q, const Point_2& r) {
  return dot(exact(r), exact(p), exact(q)) > 0;
}

bool exact_is_inside(const Outline_2& outline, const Point_2& query) {
  bool inside = false;
  for (const Ring_2& ring : outline.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      Point_2 low = ring[i];
      Point_2 high = ring[(i + 1) % ring.size()];
      if (low.y > high.y) std::swap(low, high);
      if (low.y <= query.y && query.y < high.y && orientation(low, high, query) > 0) inside = !inside;
    }
  }
  return inside;
}

bool is_on_boundary(const Outline_2& outline, const Point_2& query) {
  for (const Ring_2& ring : outline.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (is_on_segment(ring[i], ring[(i + 1) % ring.size()], query)) return true;
  }
  return false;
}

Edge sorted_edge(Edge edge) { return edge[0] <= edge[1] ? edge : Edge{edge[1], edge[0]}; }

std::vector<Edge> sorted_edges(std::span<const Edge> edges) {
  std::vector<Edge> result;
  for (const Edge& edge : edges) result.push_back(sorted_edge(edge));
  std::ranges::sort(result);
  return result;
}

std::vector<Triangle> normalized(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  std::ranges::sort(triangles);
  return triangles;
}

testing::AssertionResult is_delaunay(const Delaunay_2& d, std::span<const Point_2> points) {
  if (auto result = sites_are_right(d, points); !result) return result;
  const std::vector<int> sites = distinct_sites(d);
  const int dimension = expected_dimension(d, sites);
  if (d.dimension != dimension) return failure() << "dimension " << d.dimension << ", not " << dimension;
  if (dimension < 2) {
    if (!d.triangles.empty() || !d.neighbors.empty()) return failure() << "triangles in dimension " << dimension;
    return line_is_right(d, sites);
  }
  std::map<int, int> next_on_hull;
  if (auto result = triangles_are_linked(d, next_on_hull); !result) return result;
  if (auto result = hull_is_convex(d, next_on_hull); !result) return result;
  const std::size_t expected = 2 * sites.size() - 2 - next_on_hull.size();
  if (d.triangles.size() != expected) return failure() << d.triangles.size() << " triangles, not " << expected;
  std::set<int> used;
  for (const Triangle& t : d.triangles) used.insert(t.begin(), t.end());
  if (used.size() != sites.size()) return failure() << "only " << used.size() << " sites are in triangles";
  return circles_are_empty(d, sites);
}

testing::AssertionResult is_identical(const Delaunay_2& a, const Delaunay_2& b) {
  if (a.dimension != b.dimension || a.site_count != b.site_count) return failure() << "other dimension or site count";
  if (!same_bytes(a.points, b.points)) return failure() << "other points";
  if (a.site != b.site) return failure() << "other sites";
  if (a.triangles != b.triangles) return failure() << "other triangles";
  if (a.neighbors != b.neighbors) return failure() << "other neighbours";
  if (a.line != b.line) return failure() << "other line";
  return testing::AssertionSuccess();
}

std::vector<Edge> crust_by_definition(const Delaunay_2& d) {
  std::vector<Edge> result;
  if (d.dimension < 2) {
    for (std::size_t i = 1; i < d.line.size(); ++i) result.push_back(sorted_edge({d.line[i - 1], d.line[i]}));
  }
  for (int t = 0; t < static_cast<int>(d.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!d.edge_is_listed(t, i)) continue;
      const auto [p, q] = d.edge(t, i);
      const Point_2& r = d.points[d.triangles[t][i]];
      const int n = d.neighbors[t][i];
      const bool is_in =
          n == -1 ? exact_is_crust_hull_edge(d.points[p], d.points[q], r)
                  : exact_is_crust_edge(d.points[p], d.points[q], r, d.points[d.triangles[n][d.mirror_corner(t, i)]]);
      if (is_in) result.push_back(sorted_edge({p, q}));
    }
  }
  std::ranges::sort(result);
  return result;
}

std::vector<Edge> conflicts_by_definition(const Delaunay_2& d, const Crust_2& crust,
                                          std::span<const std::uint8_t> is_inner) {
  std::vector<Edge> result;
  for (int t = 0; t < static_cast<int>(d.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!d.edge_is_listed(t, i)) continue;
      const int n = d.neighbors[t][i];
      const bool other_is_inner = n != -1 && is_inner[n] != 0;
      if ((other_is_inner != (is_inner[t] != 0)) != crust.contains(t, i)) result.push_back(sorted_edge(d.edge(t, i)));
    }
  }
  std::ranges::sort(result);
  return result;
}

bool crust_separates(const Delaunay_2& d, const Crust_2& crust) {
  std::vector<int> degree(d.points.size(), 0);
  for (const auto& [p, q] : crust.edges) {
    ++degree[p];
    ++degree[q];
  }
  return std::ranges::none_of(degree, [](int count) { return count % 2 != 0; });
}

}  // namespace mesecina::test
