// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

#include "geometries/power_crust_2/circle_center.h"
#include "geometries/power_crust_2/power_crust_2.h"
#include "geometries/power_crust_2/unit_vector.h"

namespace mesecina {

namespace {

using Interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Exact_rational;

constexpr double diagonals_to_infinity = 1024;
constexpr int triangles_between_checks = 1 << 13;

/// The neighbours of a sample along the hull, counterclockwise; -1 for samples that are not on it.
struct Hull_neighbors {
  int before = -1;
  int after = -1;
};

/// Sign of a / sqrt(a_square) + b / sqrt(b_square).
template <class Number>
CGAL::Uncertain<CGAL::Sign> sign_of_sum(const Number& a, const Number& a_square, const Number& b,
                                        const Number& b_square) {
  const CGAL::Uncertain<CGAL::Sign> uncertain_a = CGAL_NTS sign(a);
  const CGAL::Uncertain<CGAL::Sign> uncertain_b = CGAL_NTS sign(b);
  if (!CGAL::is_certain(uncertain_a) || !CGAL::is_certain(uncertain_b))
    return CGAL::Uncertain<CGAL::Sign>::indeterminate();
  const CGAL::Sign sign_a = CGAL::get_certain(uncertain_a);
  const CGAL::Sign sign_b = CGAL::get_certain(uncertain_b);
  if (sign_a == sign_b || sign_b == CGAL::ZERO) return sign_a;
  if (sign_a == CGAL::ZERO) return sign_b;
  // Positive if the part of a is the larger one.
  const CGAL::Uncertain<CGAL::Sign> larger = CGAL_NTS sign(Number(a * a * b_square - b * b * a_square));
  return sign_a == CGAL::POSITIVE ? larger : -larger;
}

/// `decision` by intervals or, where these leave it open, by rationals.
template <class Decision>
auto decide(const Decision& decision) {
  if (const auto answer = decision.template operator()<Interval>(); CGAL::is_certain(answer))
    return CGAL::get_certain(answer);
  return CGAL::get_certain(decision.template operator()<Rational>());
}

/// Decides about Voronoi vertices, named by a triangle. All members but the constructor want upward rounding.
class Voronoi_predicates {
 public:
  explicit Voronoi_predicates(const Delaunay_2& triangulation) : delaunay_(triangulation) {}

  CGAL::Comparison_result compare_radii(int t, int u) const {
    return decide([&]<class Number>() -> CGAL::Uncertain<CGAL::Comparison_result> {
      return CGAL_NTS compare(squared_radius<Number>(t), squared_radius<Number>(u));
    });
  }
  /// Whether the vertices, seen from their corners at one sample, lie at an obtuse angle.
  bool are_on_two_sides(int t, int t_corner, int u, int u_corner) const {
    return decide([&]<class Number>() -> CGAL::Uncertain<CGAL::Sign> {
             return CGAL_NTS sign(dot(offset<Number>(t, t_corner).vector, offset<Number>(u, u_corner).vector));
           }) == CGAL::NEGATIVE;
  }
  /// Whether the vertex, seen from a corner on the hull, lies at an obtuse angle to the outward direction.
  bool is_behind_hull(int t, int corner, const Hull_neighbors& hull) const {
    const Point_2& s = delaunay_.points[delaunay_.triangles[t][corner]];
    const Point_2& before = delaunay_.points[hull.before];
    const Point_2& after = delaunay_.points[hull.after];
    return decide([&]<class Number>() -> CGAL::Uncertain<CGAL::Sign> {
             const Vector<Number> center = offset<Number>(t, corner).vector;
             const auto from_before = difference<Number>(s, before);
             const auto to_after = difference<Number>(after, s);
             const auto along_normal = [&center](const Vector<Number>& edge) {
               return Number(edge.y * center.x - edge.x * center.y);
             };
             return sign_of_sum<Number>(along_normal(from_before), dot(from_before, from_before),
                                        along_normal(to_after), dot(to_after, to_after));
           }) == CGAL::NEGATIVE;
  }

 private:
  template <class Number>
  Scaled_offset<Number> offset(int t, int corner) const {
    const auto& corners = delaunay_.triangles[t];
    return offset_of_center<Number>(delaunay_.points[corners[corner]], delaunay_.points[corners[(corner + 1) % 3]],
                                    delaunay_.points[corners[(corner + 2) % 3]]);
  }
  template <class Number>
  Number squared_radius(int t) const {
    const Scaled_offset<Number> center = offset<Number>(t, 0);
    return dot(center.vector, center.vector) / (center.factor * center.factor);
  }

  const Delaunay_2& delaunay_;
};

std::vector<Hull_neighbors> find_hull(const Delaunay_2& triangulation) {
  std::vector<Hull_neighbors> hull(triangulation.points.size());
  for (int t = 0; t < static_cast<int>(triangulation.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (triangulation.neighbors[t][i] >= 0) continue;
      const auto [a, b] = triangulation.edge(t, i);
      hull[a].after = b;
      hull[b].before = a;
    }
  }
  return hull;
}

/// The unit vector along the sum of the outward unit normals of the hull edges at s.
Point_2 outward_direction(const Point_2& before, const Point_2& s, const Point_2& after) {
  const Point_2 in = unit_vector(before, s);
  const Point_2 out = unit_vector(s, after);
  // Both sums point the same way; the longer one suffers less from rounding.
  const bool is_blunt = in.x * out.x + in.y * out.y >= 0;
  const Point_2 sum = is_blunt ? Point_2{in.y + out.y, -in.x - out.x} : Point_2{in.x - out.x, in.y - out.y};
  return unit_vector({0, 0}, sum);
}

/// Per sample the corner of a triangle: that of a pole's circle at the sample.
struct Corner {
  int triangle = -1;
  int corner = 0;
};

struct Chosen_corners {
  std::vector<Corner> first;
  std::vector<Corner> second;
};

Chosen_corners choose_poles(const Delaunay_2& triangulation, const Circumscribed_balls_2& circles,
                            const std::vector<Hull_neighbors>& hull, const Progress& progress) {
  const CGAL::Protect_FPU_rounding<true> upward_rounding;
  const Voronoi_predicates predicates(triangulation);
  const int count = static_cast<int>(triangulation.triangles.size());
  const auto replaces = [&](const Corner& best, int t) {
    if (best.triangle < 0) return true;
    const int circle = circles.ball_of_triangle[t];
    const int best_circle = circles.ball_of_triangle[best.triangle];
    if (circle == best_circle) return false;
    const CGAL::Comparison_result comparison = predicates.compare_radii(t, best.triangle);
    if (comparison != CGAL::EQUAL) return comparison == CGAL::LARGER;
    return std::ranges::lexicographical_compare(circles.balls.contacts_of(circle),
                                                circles.balls.contacts_of(best_circle));
  };
  Chosen_corners chosen;
  chosen.first.resize(triangulation.points.size());
  chosen.second.resize(triangulation.points.size());
  for (int t = 0; t < count; ++t) {
    if (t % triangles_between_checks == 0) progress.check();
    for (int i = 0; i < 3; ++i) {
      const int s = triangulation.triangles[t][i];
      if (hull[s].before < 0 && replaces(chosen.first[s], t)) chosen.first[s] = {t, i};
    }
  }
  for (int t = 0; t < count; ++t) {
    if (t % triangles_between_checks == 0) progress.check();
    for (int i = 0; i < 3; ++i) {
      const int s = triangulation.triangles[t][i];
      const Corner& first = chosen.first[s];
      const bool is_opposite = hull[s].before >= 0 ? predicates.is_behind_hull(t, i, hull[s])
                                                   : predicates.are_on_two_sides(first.triangle, first.corner, t, i);
      if (is_opposite && replaces(chosen.second[s], t)) chosen.second[s] = {t, i};
    }
  }
  return chosen;
}

/// Appends a disk that touches the sample from outside. It is circumscribed to the sample and two auxiliary points.
void add_disk_at_infinity(Balls_2& balls, std::vector<Point_2>& samples, int sample, const Point_2& direction,
                          double radius) {
  const Point_2 s = samples[sample];
  const Point_2 to_center{radius * direction.x, radius * direction.y};
  const Point_2 center{s.x + to_center.x, s.y + to_center.y};
  const int auxiliary = static_cast<int>(samples.size());
  samples.push_back({center.x - to_center.y, center.y + to_center.x});
  samples.push_back({center.x + to_center.y, center.y - to_center.x});
  balls.centers.push_back(center);
  balls.radii.push_back(radius);
  balls.contacts.insert(balls.contacts.end(), {sample, auxiliary, auxiliary + 1});
  balls.contact_offsets.push_back(static_cast<int>(balls.contacts.size()));
}

void collect_samples(Poles_2& poles) {
  poles.sample_offsets.assign(poles.balls->size() + 1, 0);
  const auto for_each_pair = [&](const auto& function) {
    for (int s = 0; s < static_cast<int>(poles.first.size()); ++s)
      for (const int pole : {poles.first[s], poles.second[s]})
        if (pole >= 0) function(pole, s);
  };
  for_each_pair([&](int pole, int) { ++poles.sample_offsets[pole + 1]; });
  for (std::size_t p = 1; p < poles.sample_offsets.size(); ++p) poles.sample_offsets[p] += poles.sample_offsets[p - 1];
  poles.samples.resize(poles.sample_offsets.back());
  std::vector<int> next(poles.sample_offsets.begin(), poles.sample_offsets.end() - 1);
  for_each_pair([&](int pole, int s) { poles.samples[next[pole]++] = s; });
}

}  // namespace

Poles_2 find_poles(const Delaunay_2& triangulation, const Voronoi_2& voronoi, Progress& progress) {
  const std::vector<std::uint8_t> all(triangulation.triangles.size(), 1);
  const Circumscribed_balls_2 circles = circumscribed_balls(triangulation, voronoi, all, progress);
  const std::vector<Hull_neighbors> hull = find_hull(triangulation);
  const Chosen_corners chosen = choose_poles(triangulation, circles, hull, progress);
  const auto circle_of = [&](const Corner& corner) {
    return corner.triangle < 0 ? -1 : circles.ball_of_triangle[corner.triangle];
  };

  Poles_2 poles;
  std::vector<int> kept;
  std::vector<int> pole_of_circle(circles.triangles.size(), -1);
  for (const auto* corners : {&chosen.first, &chosen.second}) {
    for (const Corner& corner : *corners) {
      const int circle = circle_of(corner);
      if (circle < 0 || pole_of_circle[circle] >= 0) continue;
      pole_of_circle[circle] = 0;
      kept.push_back(circle);
    }
  }
  // By samples, so that the numbers of poles do not depend on those of the triangles.
  std::ranges::sort(kept, [&](int a, int b) {
    return std::ranges::lexicographical_compare(circles.balls.contacts_of(a), circles.balls.contacts_of(b));
  });
  progress.check();
  for (std::size_t p = 0; p < kept.size(); ++p) {
    pole_of_circle[kept[p]] = static_cast<int>(p);
    poles.triangles.push_back(circles.triangles[kept[p]]);
  }

  Balls_2 balls = subset(circles.balls, kept);
  std::vector<Point_2> samples = triangulation.points;
  Box box;
  for (const Point_2& p : triangulation.points) box.add(p);
  const double far = diagonals_to_infinity * box.diagonal();
  const int sample_count = static_cast<int>(triangulation.points.size());
  poles.first.assign(sample_count, -1);
  poles.second.assign(sample_count, -1);
  for (int s = 0; s < sample_count; ++s) {
    if (const int circle = circle_of(chosen.second[s]); circle >= 0) poles.second[s] = pole_of_circle[circle];
    if (const int circle = circle_of(chosen.first[s]); circle >= 0) poles.first[s] = pole_of_circle[circle];
    if (hull[s].before < 0) continue;
    poles.first[s] = static_cast<int>(balls.size());
    add_disk_at_infinity(
        balls, samples, s,
        outward_direction(triangulation.points[hull[s].before], samples[s], triangulation.points[hull[s].after]), far);
  }
  balls.samples = std::make_shared<const std::vector<Point_2>>(std::move(samples));
  poles.balls = std::make_shared<const Balls_2>(std::move(balls));
  collect_samples(poles);
  return poles;
}

}  // namespace mesecina
