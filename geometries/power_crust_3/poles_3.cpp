// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/outcome.h"
#include "geometries/delaunay_3/delaunay_3.h"
#include "geometries/parallel.h"
#include "geometries/power_crust_3/power_crust_3.h"

namespace mesecina {

namespace {

using Interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Exact_rational;

constexpr double diagonals_to_infinity = 1024;

template <class Number>
struct Vector {
  Number x, y, z;
};

template <class Number>
Number dot(const Vector<Number>& u, const Vector<Number>& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

template <class Number>
Vector<Number> cross(const Vector<Number>& u, const Vector<Number>& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// `decision` by intervals or, where these leave it open, by rationals.
template <class Decision>
auto decide(const Decision& decision) {
  if (const auto answer = decision.template operator()<Interval>(); CGAL::is_certain(answer))
    return CGAL::get_certain(answer);
  return CGAL::get_certain(decision.template operator()<Rational>());
}

/// A corner of a cell; a Voronoi vertex seen from a sample.
struct Corner {
  int cell = -1;
  int place = 0;
};

/// Decides about Voronoi vertices. Members but the constructor want upward rounding.
class Voronoi_predicates {
 public:
  explicit Voronoi_predicates(const Delaunay_3& triangulation) : delaunay_(triangulation) {}

  /// Whether the first vertex is farther from its samples than the second is from its own.
  bool is_farther(int cell, int other) const {
    const double r = delaunay_.circumradii[cell];
    const double s = delaunay_.circumradii[other];
    if (r > surely_more * s) return true;
    if (s > surely_more * r) return false;
    return decide([&]<class Number>() -> CGAL::Uncertain<CGAL::Comparison_result> {
             const auto one = offset<Number>({cell, 0});
             const auto two = offset<Number>({other, 0});
             const Number one_square = dot(one.vector, one.vector) * two.factor * two.factor;
             const Number two_square = dot(two.vector, two.vector) * one.factor * one.factor;
             return CGAL_NTS compare(one_square, two_square);
           }) == CGAL::LARGER;
  }
  /// Whether two vertices, seen from corners at one sample, lie at an obtuse angle.
  bool are_on_two_sides(const Corner& one, const Corner& two) const {
    const Point_3& sample = delaunay_.points[delaunay_.cells[one.cell][one.place]];
    const double product =
        mesecina::dot(delaunay_.circumcenters[one.cell] - sample, delaunay_.circumcenters[two.cell] - sample);
    const double lengths = delaunay_.circumradii[one.cell] * delaunay_.circumradii[two.cell];
    if (std::abs(product) > surely_oblique * lengths) return product < 0;
    return decide([&]<class Number>() -> CGAL::Uncertain<CGAL::Sign> {
             return CGAL_NTS sign(dot(offset<Number>(one).vector, offset<Number>(two).vector));
           }) == CGAL::NEGATIVE;
  }

 private:
  // Rounded circumcenters are right to a thousandth of the radius, and mostly to much more.
  static constexpr double surely_more = 1.01;
  static constexpr double surely_oblique = 0.01;

  /// From a point on a sphere to its center, times `factor`, which is positive.
  template <class Number>
  struct Scaled_offset {
    Vector<Number> vector;
    Number factor;
  };

  template <class Number>
  Scaled_offset<Number> offset(const Corner& corner) const {
    // With the corner's own place first these are even permutations.
    constexpr std::array<std::array<int, 3>, 4> others{{{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}}};
    const auto& corners = delaunay_.cells[corner.cell];
    const Point_3& p = delaunay_.points[corners[corner.place]];
    const auto difference = [&](int k) -> Vector<Number> {
      const Point_3& q = delaunay_.points[corners[others[corner.place][k]]];
      return {Number(q.x) - Number(p.x), Number(q.y) - Number(p.y), Number(q.z) - Number(p.z)};
    };
    const auto a = difference(0);
    const auto b = difference(1);
    const auto c = difference(2);
    const auto bc = cross(b, c);
    const auto ca = cross(c, a);
    const auto ab = cross(a, b);
    const Number a2 = dot(a, a);
    const Number b2 = dot(b, b);
    const Number c2 = dot(c, c);
    return {{a2 * bc.x + b2 * ca.x + c2 * ab.x, a2 * bc.y + b2 * ca.y + c2 * ab.y, a2 * bc.z + b2 * ca.z + c2 * ab.z},
            2 * dot(a, bc)};
  }

  const Delaunay_3& delaunay_;
};

/// The corners of cells at each point.
struct Stars {
  std::vector<int> offsets;
  std::vector<Corner> corners;
  std::span<const Corner> of(std::size_t point) const {
    return std::span(corners).subspan(offsets[point], offsets[point + 1] - offsets[point]);
  }
};

Stars stars_of_points(const Delaunay_3& delaunay) {
  Stars stars;
  stars.offsets.assign(delaunay.points.size() + 1, 0);
  for (const auto& corners : delaunay.cells)
    for (const int point : corners) ++stars.offsets[point + 1];
  std::partial_sum(stars.offsets.begin(), stars.offsets.end(), stars.offsets.begin());
  stars.corners.resize(stars.offsets.back());
  std::vector<int> next(stars.offsets.begin(), stars.offsets.end() - 1);
  for (int c = 0; c < static_cast<int>(delaunay.cells.size()); ++c)
    for (int i = 0; i < 4; ++i) stars.corners[next[delaunay.cells[c][i]]++] = {c, i};
  return stars;
}

/// Per sample the Voronoi vertices that are its poles, each by the least cell of its sphere; -1 for none.
struct Chosen_vertices {
  std::vector<int> first;
  std::vector<int> second;
};

class Pole_finder {
 public:
  /// Corners of cells that have a point beyond `count` are infinite.
  Pole_finder(const Delaunay_3& delaunay, const std::vector<int>& vertex_of_cell, std::size_t count)
      : delaunay_(delaunay),
        vertex_of_cell_(vertex_of_cell),
        count_(count),
        stars_(stars_of_points(delaunay)),
        predicates_(delaunay) {}

  Chosen_vertices choose(Progress& progress) const {
    Chosen_vertices chosen;
    chosen.first.assign(count_, -1);
    chosen.second.assign(count_, -1);
    parallel_for(count_, progress, [&](std::size_t s) {
      const CGAL::Protect_FPU_rounding<true> upward_rounding;
      const auto star = stars_.of(s);
      if (star.empty()) return;
      const Point_3 outward = outward_direction(s);
      const bool is_on_hull = dot(outward, outward) > 0;
      const Corner first = is_on_hull ? outermost(s, outward) : farthest(star, [](const Corner&) { return true; });
      const Corner second = farthest(star, [&](const Corner& corner) {
        if (!is_on_hull) return predicates_.are_on_two_sides(first, corner);
        return !is_infinite(corner) && dot(outward, from_sample(s, corner)) < 0;
      });
      chosen.first[s] = vertex_of_cell_[first.cell];
      if (second.cell >= 0) chosen.second[s] = vertex_of_cell_[second.cell];
    });
    return chosen;
  }

 private:
  bool is_infinite(const Corner& corner) const {
    return std::ranges::any_of(delaunay_.cells[corner.cell], [&](int p) { return p >= static_cast<int>(count_); });
  }
  Point_3 from_sample(std::size_t sample, const Corner& corner) const {
    return delaunay_.circumcenters[vertex_of_cell_[corner.cell]] - delaunay_.points[sample];
  }
  /// The sum of the directions of infinite vertices; 0 when there are none.
  Point_3 outward_direction(std::size_t sample) const {
    Point_3 sum;
    for (const Corner& corner : stars_.of(sample))
      if (is_infinite(corner)) sum = sum + (1 / delaunay_.circumradii[corner.cell]) * from_sample(sample, corner);
    return sum;
  }
  /// The infinite vertex that is nearest to a direction.
  Corner outermost(std::size_t sample, const Point_3& direction) const {
    Corner best;
    double greatest = -std::numeric_limits<double>::infinity();
    for (const Corner& corner : stars_.of(sample)) {
      const double cosine = dot(direction, from_sample(sample, corner)) / delaunay_.circumradii[corner.cell];
      if (!is_infinite(corner) || !(cosine > greatest)) continue;
      greatest = cosine;
      best = corner;
    }
    return best;
  }
  template <class Wants>
  Corner farthest(std::span<const Corner> star, const Wants& wants) const {
    Corner best;
    for (const Corner& corner : star) {
      if (best.cell >= 0 && vertex_of_cell_[best.cell] == vertex_of_cell_[corner.cell]) continue;
      if (wants(corner) && (best.cell < 0 || predicates_.is_farther(corner.cell, best.cell))) best = corner;
    }
    return best;
  }

  const Delaunay_3& delaunay_;
  const std::vector<int>& vertex_of_cell_;
  std::size_t count_;
  Stars stars_;
  Voronoi_predicates predicates_;
};

std::vector<Point_3> with_far_corners(const std::vector<Point_3>& samples) {
  Box box;
  for (const Point_3& p : samples) box.add(p);
  const Point_3 center = midpoint(box.lower, box.upper);
  const double far = diagonals_to_infinity * box.diagonal();
  std::vector<Point_3> points = samples;
  for (const double x : {-far, far})
    for (const double y : {-far, far})
      for (const double z : {-far, far}) points.push_back(center + Point_3{x, y, z});
  return points;
}

/// Throws what says why.
[[noreturn]] void refuse(const std::vector<Point_3>& samples, Progress& progress) {
  delaunay(samples, progress);
  throw Unavailable("all points lie nearly in one plane");
}

void collect_samples(Poles_3& poles) {
  poles.sample_offsets.assign(poles.size() + 1, 0);
  const auto for_each_pair = [&](const auto& function) {
    for (int s = 0; s < static_cast<int>(poles.sample_count); ++s)
      for (const int pole : {poles.first[s], poles.second[s]})
        if (pole >= 0) function(pole, s);
  };
  for_each_pair([&](int pole, int) { ++poles.sample_offsets[pole + 1]; });
  std::partial_sum(poles.sample_offsets.begin(), poles.sample_offsets.end(), poles.sample_offsets.begin());
  poles.samples.resize(poles.sample_offsets.back());
  std::vector<int> next(poles.sample_offsets.begin(), poles.sample_offsets.end() - 1);
  for_each_pair([&](int pole, int s) { poles.samples[next[pole]++] = s; });
}

/// The points on the sphere of each pole.
void collect_contacts(const Delaunay_3& delaunay, const std::vector<int>& vertex_of_cell,
                      const std::vector<int>& pole_of_vertex, Poles_3& poles) {
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t c = 0; c < delaunay.cells.size(); ++c)
    if (const int pole = pole_of_vertex[vertex_of_cell[c]]; pole >= 0)
      for (const int point : delaunay.cells[c]) pairs.push_back({pole, point});
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  poles.contact_offsets.assign(poles.size() + 1, 0);
  for (const auto& [pole, point] : pairs) {
    ++poles.contact_offsets[pole + 1];
    poles.contacts.push_back(point);
  }
  std::partial_sum(poles.contact_offsets.begin(), poles.contact_offsets.end(), poles.contact_offsets.begin());
}

}  // namespace

Poles_3 find_poles(const std::vector<Point_3>& samples, Progress& progress) {
  const std::size_t count = samples.size();
  constexpr std::size_t least = 4;
  if (count < least) refuse(samples, progress);
  const Delaunay_3 delaunay = mesecina::delaunay(with_far_corners(samples), progress);
  progress.begin_stage("poles");
  const auto is_far = [&](int point) { return point >= static_cast<int>(count); };
  const auto has_far = [&](const std::array<int, 4>& corners) { return std::ranges::any_of(corners, is_far); };
  if (std::ranges::all_of(delaunay.cells, has_far)) refuse(samples, progress);
  const std::vector<int> vertex_of_cell = cells_by_sphere(delaunay, progress);
  const Chosen_vertices chosen = Pole_finder(delaunay, vertex_of_cell, count).choose(progress);
  progress.check();

  enum class Use : std::uint8_t { none, finite, infinite };
  std::vector<Use> uses(delaunay.cells.size(), Use::none);
  for (const auto* vertices : {&chosen.first, &chosen.second})
    for (const int vertex : *vertices)
      if (vertex >= 0) uses[vertex] = Use::finite;
  for (std::size_t c = 0; c < delaunay.cells.size(); ++c)
    if (has_far(delaunay.cells[c]) && !std::ranges::all_of(delaunay.cells[c], is_far))
      uses[vertex_of_cell[c]] = Use::infinite;

  Poles_3 poles;
  std::vector<int> pole_of_vertex(delaunay.cells.size(), -1);
  for (const Use wanted : {Use::finite, Use::infinite}) {
    for (std::size_t c = 0; c < uses.size(); ++c) {
      if (uses[c] != wanted) continue;
      pole_of_vertex[c] = static_cast<int>(poles.size());
      poles.balls.push_back({delaunay.circumcenters[c], delaunay.circumradii[c]});
    }
    if (wanted == Use::finite) poles.finite_count = poles.size();
  }
  poles.sample_count = count;
  const auto poles_of = [&](const std::vector<int>& vertices) {
    std::vector<int> result;
    result.reserve(vertices.size());
    for (const int vertex : vertices) result.push_back(vertex < 0 ? -1 : pole_of_vertex[vertex]);
    return result;
  };
  poles.first = poles_of(chosen.first);
  poles.second = poles_of(chosen.second);
  collect_samples(poles);
  collect_contacts(delaunay, vertex_of_cell, pole_of_vertex, poles);
  poles.points = delaunay.points;
  return poles;
}

}  // namespace mesecina
