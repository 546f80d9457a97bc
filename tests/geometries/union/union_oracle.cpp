// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/union/union_oracle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace mesecina::test {

namespace {

const Real zero_length("1e-80");  ///< relative to the scale: far above rounding, far below what doubles can tell

struct Real_vector {
  Real x;
  Real y;
};
Real cross(const Real_vector& a, const Real_vector& b) { return a.x * b.y - a.y * b.x; }
Real dot(const Real_vector& a, const Real_vector& b) { return a.x * b.x + a.y * b.y; }
Real_vector unit(const Real_vector& a) {
  const Real length = sqrt(dot(a, a));
  return {Real(a.x / length), Real(a.y / length)};
}

/// One of the two points where the circles of i and j meet: foot + side sqrt(square) normal.
class Crossing {
 public:
  Crossing(const std::vector<Exact_disk>& disks, int i, int j)
      : disks_(disks),
        i_(i),
        line_(radical_line(disks[i], disks[j])),
        square_(-line_.foot_power / line_.squared_length) {}

  bool exists() const { return sign(square_) >= 0; }
  bool is_touching() const { return sign(square_) == 0; }
  /// Of the power distance of the point to disk k.
  int power_sign(int k, int side) const {
    const Rational dx = line_.foot_x - disks_[k].x;
    const Rational dy = line_.foot_y - disks_[k].y;
    const Rational constant = dx * dx + dy * dy - disks_[k].weight - line_.foot_power;
    const Rational slope =
        -2 * ((disks_[k].x - disks_[i_].x) * line_.normal_x + (disks_[k].y - disks_[i_].y) * line_.normal_y);
    return sign_with_root(constant, Rational(side * slope), square_);
  }
  /// Of the area of centers a, b and the point.
  int orientation_sign(int a, int b, int side) const {
    const Rational ux = disks_[b].x - disks_[a].x;
    const Rational uy = disks_[b].y - disks_[a].y;
    const Rational constant = ux * (line_.foot_y - disks_[a].y) - uy * (line_.foot_x - disks_[a].x);
    const Rational slope = ux * line_.normal_y - uy * line_.normal_x;
    return sign_with_root(constant, Rational(side * slope), square_);
  }
  Real_vector position(int side) const {
    const Real t = side * sqrt(to_real(square_));
    return {Real(to_real(line_.foot_x) + t * to_real(line_.normal_x)),
            Real(to_real(line_.foot_y) + t * to_real(line_.normal_y))};
  }

 private:
  const std::vector<Exact_disk>& disks_;
  int i_;
  Radical_line line_;
  Rational square_;
};

/// The point is strictly inside the convex hull of these centers, so the disks around it cover all directions.
bool is_surrounded(const Crossing& crossing, int side, const std::vector<int>& sources,
                   const std::vector<Exact_disk>& disks) {
  bool has_area = false;
  for (const int a : sources)
    for (const int b : sources) has_area = has_area || orientation(disks[sources[0]], disks[a], disks[b]) != 0;
  if (!has_area) return false;
  // Strictly inside iff strictly left of every edge of the hull.
  for (const int a : sources) {
    for (const int b : sources) {
      if (are_concentric(disks[a], disks[b])) continue;
      bool is_hull_edge = true;
      for (const int c : sources) is_hull_edge = is_hull_edge && orientation(disks[a], disks[b], disks[c]) >= 0;
      if (is_hull_edge && crossing.orientation_sign(a, b, side) <= 0) return false;
    }
  }
  return true;
}

void find_vertices(Union_oracle& u) {
  const int count = static_cast<int>(u.disks.size());
  for (int i = 0; i < count; ++i) {
    if (u.representative[i] != i) continue;
    for (int j = i + 1; j < count; ++j) {
      if (u.representative[j] != j || are_concentric(u.disks[i], u.disks[j])) continue;
      const Crossing crossing(u.disks, i, j);
      if (!crossing.exists()) continue;
      for (const int side : {1, -1}) {
        if (side == -1 && crossing.is_touching()) continue;
        std::vector<int> sources;
        bool is_on_boundary = true;
        for (int k = 0; k < count && is_on_boundary; ++k) {
          if (u.representative[k] == -1) continue;
          const int power = crossing.power_sign(k, side);
          if (power == 0) sources.push_back(k);
          if (power < 0) is_on_boundary = false;
        }
        if (!is_on_boundary) continue;
        // Each point once: from the first two circles through it.
        const auto first = std::ranges::find_if(sources, [&](int k) { return u.representative[k] == k; });
        const auto second = std::find_if(first + 1, sources.end(), [&](int k) { return u.representative[k] == k; });
        if (*first != i || *second != j) continue;
        if (is_surrounded(crossing, side, sources, u.disks)) continue;
        const auto [x, y] = crossing.position(side);
        u.vertices.push_back({x, y, std::move(sources), 0});
      }
    }
  }
  for (Oracle_vertex& v : u.vertices) {
    for (const int a : v.sources) {
      for (const int b : v.sources) {
        const Real_vector p{Real(v.x - u.real_disks[a].x), Real(v.y - u.real_disks[a].y)};
        const Real_vector q{Real(v.x - u.real_disks[b].x), Real(v.y - u.real_disks[b].y)};
        const Real lengths = sqrt(dot(p, p) * dot(q, q));
        if (lengths > 0) v.steepness = std::max(v.steepness, std::abs(static_cast<double>(cross(p, q) / lengths)));
      }
    }
  }
}

/// 0 for angles in [0, 180), 1 for those in [180, 360).
int half_plane(const Real_vector& v) { return v.y > 0 || (v.y == 0 && v.x > 0) ? 0 : 1; }
bool comes_before(const Real_vector& a, const Real_vector& b) {
  if (half_plane(a) != half_plane(b)) return half_plane(a) < half_plane(b);
  return cross(a, b) > 0;
}
/// The middle of the turn counterclockwise from a to b (units), nearly.
Real_vector direction_between(const Real_vector& a, const Real_vector& b) {
  if (dot(a, b) < -0.5) return {Real(-a.y), a.x};
  const Real_vector sum = unit({Real(a.x + b.x), Real(a.y + b.y)});
  return cross(a, b) > 0 ? sum : Real_vector{Real(-sum.x), Real(-sum.y)};
}

void find_arcs(Union_oracle& u) {
  const int count = static_cast<int>(u.disks.size());
  const Real margin = zero_length * Real(u.scale) * Real(u.scale);
  for (int i = 0; i < count; ++i) {
    if (u.representative[i] != i) continue;
    const Real_vector center{u.real_disks[i].x, u.real_disks[i].y};
    const Real& radius = u.real_disks[i].radius;
    std::vector<std::pair<Real_vector, int>> ends;
    for (int v = 0; v < static_cast<int>(u.vertices.size()); ++v) {
      if (!std::ranges::binary_search(u.vertices[v].sources, i)) continue;
      Real_vector direction{Real(u.vertices[v].x - center.x), Real(u.vertices[v].y - center.y)};
      ends.push_back({radius > 0 ? unit(direction) : Real_vector{1, 0}, v});
    }
    std::ranges::sort(ends, [](const auto& a, const auto& b) { return comes_before(a.first, b.first); });
    // For points that are no vertices: on another circle they are surrounded by disks, though strictly in none.
    const auto is_covered = [&](const Real_vector& direction) {
      const Real_vector p{Real(center.x + radius * direction.x), Real(center.y + radius * direction.y)};
      for (int k = 0; k < count; ++k) {
        if (u.representative[k] != k || k == i) continue;
        const Real_vector d{Real(p.x - u.real_disks[k].x), Real(p.y - u.real_disks[k].y)};
        if (dot(d, d) - u.real_disks[k].weight <= margin) return true;
      }
      return false;
    };
    if (ends.empty()) {
      if (!is_covered({1, 0})) u.arcs.push_back({i, -1, -1});
      continue;
    }
    if (ends.size() == 1) {
      const auto& [from, v] = ends[0];
      const Real_vector opposite{Real(-from.x), Real(-from.y)};
      if (!is_covered(opposite)) u.arcs.push_back({i, v, v});
      continue;
    }
    for (std::size_t e = 0; e < ends.size(); ++e) {
      const auto& [from, v] = ends[e];
      const auto& [to, w] = ends[(e + 1) % ends.size()];
      if (!is_covered(direction_between(from, to))) u.arcs.push_back({i, v, w});
    }
  }
}

struct Arc_end {
  Real_vector direction;  ///< away from the vertex
  Real curvature;         ///< positive: bends to the left
  std::size_t arc;
  bool departs;
};

/// Boundary curves, followed with the outside on the right: at a vertex an arriving arc goes on with the arc that is
/// met first when one turns counterclockwise, through the outside, from where it came.
int count_curves(const Union_oracle& u) {
  std::vector<std::vector<Arc_end>> ends(u.vertices.size());
  int result = 0;
  for (std::size_t a = 0; a < u.arcs.size(); ++a) {
    const Oracle_arc& arc = u.arcs[a];
    const Real_disk& disk = u.real_disks[arc.ball];
    if (arc.from == -1) ++result;
    // A point on another circle bounds nothing by itself.
    if (arc.from == -1 || disk.radius == 0) continue;
    const Real curvature = 1 / disk.radius;
    for (const bool departs : {true, false}) {
      const int v = departs ? arc.from : arc.to;
      const Real_vector out = unit({Real(u.vertices[v].x - disk.x), Real(u.vertices[v].y - disk.y)});
      if (departs) {
        ends[v].push_back({{Real(-out.y), out.x}, curvature, a, true});
      } else {
        ends[v].push_back({{out.y, Real(-out.x)}, Real(-curvature), a, false});
      }
    }
  }
  std::vector<std::size_t> next(u.arcs.size(), u.arcs.size());
  for (auto& around : ends) {
    if (around.empty()) continue;
    const Real_vector start = around.front().direction;
    // In [0, 4), growing with the angle from the first end. Directions that are one are told apart by curvature.
    const auto turn = [&](const Arc_end& end) {
      const Real c = dot(start, end.direction);
      const Real s = cross(start, end.direction);
      if (abs(s) < zero_length) return Real(c > 0 ? 0 : 2);
      const Real part = s / (abs(s) + abs(c));
      return c < 0 ? Real(2 - part) : s > 0 ? part : Real(4 + part);
    };
    std::ranges::sort(around, [&](const Arc_end& a, const Arc_end& b) {
      const Real difference = turn(a) - turn(b);
      return abs(difference) > zero_length ? difference < 0 : a.curvature < b.curvature;
    });
    for (std::size_t e = 0; e < around.size(); ++e) {
      if (around[e].departs) continue;
      const Arc_end& follower = around[(e + 1) % around.size()];
      if (!follower.departs) throw std::logic_error("two arcs arrive side by side");
      next[around[e].arc] = follower.arc;
    }
  }
  std::vector<bool> seen(u.arcs.size(), false);
  for (std::size_t a = 0; a < u.arcs.size(); ++a) {
    if (seen[a] || next[a] == u.arcs.size()) continue;
    ++result;
    for (std::size_t b = a; !seen[b]; b = next[b]) seen[b] = true;
  }
  return result;
}

int count_components(const Union_oracle& u) {
  std::vector<int> parent(u.disks.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int a) {
    while (parent[a] != a) a = parent[a];
    return a;
  };
  int result = 0;
  for (int i = 0; i < static_cast<int>(u.disks.size()); ++i) {
    if (u.representative[i] != i) continue;
    ++result;
    for (int j = 0; j < i; ++j) {
      if (u.representative[j] != j || root(i) == root(j) || !disks_meet(u.disks[i], u.disks[j])) continue;
      parent[root(i)] = root(j);
      --result;
    }
  }
  return result;
}

double angle_from(double start, double angle) {
  const double turn = std::fmod(angle - start, 2 * std::numbers::pi);
  return turn < 0 ? turn + 2 * std::numbers::pi : turn;
}

}  // namespace

Real to_real(const Rational& value) {
  // A sum of eight doubles, each of what the ones before leave, has more digits than a Real.
  Rational rest = value;
  Real result = 0;
  for (int i = 0; i < 8 && sign(rest) != 0; ++i) {
    const double part = CGAL::to_double(rest);
    result += part;
    rest -= Rational(part);
  }
  return result;
}

bool disks_meet(const Exact_disk& a, const Exact_disk& b) {
  const Rational dx = a.x - b.x;
  const Rational dy = a.y - b.y;
  // d^2 <= (r + s)^2
  const Rational gap = a.weight + b.weight - dx * dx - dy * dy;
  return sign_with_root(gap, Rational(2), Rational(a.weight * b.weight)) >= 0;
}

Union_oracle union_oracle(const Balls_2& balls, double alpha) {
  Union_oracle u;
  u.disks = exact_disks(balls, alpha);
  for (int i = 0; i < static_cast<int>(u.disks.size()); ++i) {
    const Exact_disk& disk = u.disks[i];
    int least = sign(disk.weight) < 0 ? -1 : i;
    for (int j = 0; j < i && least == i; ++j)
      if (are_equal(disk, u.disks[j])) least = j;
    u.representative.push_back(least);
    const Real weight = to_real(disk.weight);
    const Real radius = least == -1 ? Real(0) : Real(sqrt(weight));
    u.real_disks.push_back({to_real(disk.x), to_real(disk.y), weight, radius});
    u.centers.push_back({CGAL::to_double(disk.x), CGAL::to_double(disk.y)});
    u.radii.push_back(static_cast<double>(radius));
    u.scale = std::max({u.scale, std::abs(u.centers.back().x), std::abs(u.centers.back().y), u.radii.back()});
  }
  find_vertices(u);
  find_arcs(u);
  u.component_count = count_components(u);
  u.curve_count = count_curves(u);
  // Euler characteristic of the sphere: that of the union and, per component of the complement, 2 less its curves.
  u.hole_count = u.curve_count - u.component_count;
  return u;
}

double Union_oracle::vertex_distance(const Point_2& query) const {
  double result = std::numeric_limits<double>::infinity();
  for (const Oracle_vertex& v : vertices) result = std::min(result, distance(query, v.point()));
  return result;
}

double Union_oracle::arc_distance(const Point_2& query) const {
  double result = std::numeric_limits<double>::infinity();
  for (const Oracle_arc& arc : arcs) {
    const Point_2& c = centers[arc.ball];
    if (arc.from != arc.to && query != c) {
      const Point_2 p = vertices[arc.from].point();
      const Point_2 q = vertices[arc.to].point();
      const double start = std::atan2(p.y - c.y, p.x - c.x);
      const double sweep = angle_from(start, std::atan2(q.y - c.y, q.x - c.x));
      if (angle_from(start, std::atan2(query.y - c.y, query.x - c.x)) > sweep) continue;
    }
    result = std::min(result, std::abs(distance(query, c) - radii[arc.ball]));
  }
  return result;
}

double Union_oracle::boundary_distance(const Point_2& query) const {
  return std::min(vertex_distance(query), arc_distance(query));
}

bool Union_oracle::is_inside(const Point_2& query) const {
  for (std::size_t i = 0; i < disks.size(); ++i)
    if (representative[i] != -1 && distance(query, centers[i]) <= radii[i] * (1 + 1e-12)) return true;
  return false;
}

double Union_oracle::area() const {
  double result = 0;
  for (const Oracle_arc& arc : arcs) {
    const Point_2& c = centers[arc.ball];
    const double r = radii[arc.ball];
    if (arc.from == arc.to) {
      result += std::numbers::pi * r * r;
      continue;
    }
    const Point_2 p = vertices[arc.from].point();
    const Point_2 q = vertices[arc.to].point();
    const double sweep = angle_from(std::atan2(p.y - c.y, p.x - c.x), std::atan2(q.y - c.y, q.x - c.x));
    result += (r * r * sweep + c.x * (q.y - p.y) - c.y * (q.x - p.x)) / 2;
  }
  return result;
}

}  // namespace mesecina::test
