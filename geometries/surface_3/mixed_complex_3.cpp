// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/mixed_complex_3.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "geometries/parallel.h"
#include "geometries/union_3/orthogonal_spheres_3.h"

namespace mesecina {

namespace {

using Unprotected_interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Exact_rational;

/// The places of the edges of a cell.
constexpr std::array<std::array<int, 2>, 6> places_of_edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

int edge_between(int i, int j) {
  constexpr std::array<std::array<int, 4>, 4> edges{{{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}}};
  return edges[i][j];
}

using Simplex = boost::container::static_vector<int, 4>;

/// Calls function(kernel, points...) for the balls of a simplex, with numbers of this type.
template <class Number, class Function>
auto with_points(const Simplex& simplex, const std::vector<Ball_3>& balls, const std::vector<double>& weights,
                 const Function& function) {
  using Kernel = CGAL::Simple_cartesian<Number>;
  const auto point = [&](int i) {
    const Point_3& c = balls[simplex[i]].center;
    return typename Kernel::Weighted_point_3(typename Kernel::Point_3(Number(c.x), Number(c.y), Number(c.z)),
                                             Number(weights[simplex[i]]));
  };
  switch (simplex.size()) {
    case 1:
      return function(Kernel(), point(0));
    case 2:
      return function(Kernel(), point(0), point(1));
    case 3:
      return function(Kernel(), point(0), point(1), point(2));
    default:
      return function(Kernel(), point(0), point(1), point(2), point(3));
  }
}

constexpr auto squared_radius = [](const auto& kernel, const auto&... points) {
  return kernel.compute_squared_radius_smallest_orthogonal_sphere_3_object()(points...);
};

constexpr auto center = [](const auto& kernel, const auto&... points) {
  if constexpr (sizeof...(points) == 1)
    return (points.point(), ...);
  else
    return kernel.construct_weighted_circumcenter_3_object()(points...);
};

}  // namespace

Mixed_complex_3::Mixed_complex_3(const Regular_3& regular, double shrink_factor, Progress& progress)
    : regular_(regular), shrink_factor_(shrink_factor) {
  progress.begin_stage("mixed complex");
  weights_.reserve(regular.balls.size());
  for (const Ball_3& ball : regular.balls) weights_.push_back(ball.radius * ball.radius);
  number_edges(progress);
  number_triangles();
  measure(progress);
  find_anchors(progress);
}

int Mixed_complex_3::number(int cell, unsigned places) const {
  const auto first = std::countr_zero(places);
  switch (std::popcount(places)) {
    case 1:
      return regular_.cells[cell][first];
    case 2:
      return first_edge() + edges_of_cell_[cell][edge_between(first, static_cast<int>(std::bit_width(places)) - 1)];
    case 3:
      return first_triangle() + triangles_of_cell_[cell][std::countr_one(places)];
    default:
      return first_cell() + cell;
  }
}

Simplex Mixed_complex_3::balls_of(int simplex) const {
  const auto of = [](const auto& balls) { return Simplex(balls.begin(), balls.end()); };
  if (simplex >= first_cell()) return of(regular_.cells[simplex - first_cell()]);
  if (simplex >= first_triangle()) return of(triangles_[simplex - first_triangle()]);
  if (simplex >= first_edge()) return of(edges_[simplex - first_edge()]);
  return {simplex};
}

void Mixed_complex_3::number_edges(Progress& progress) {
  struct Use {
    std::array<int, 2> balls;
    int cell;
    int edge;
    auto operator<=>(const Use&) const = default;
  };
  std::vector<Use> uses;
  for (std::size_t c = 0; c < regular_.cells.size(); ++c) {
    if (regular_.is_infinite(static_cast<int>(c))) continue;
    for (int e = 0; e < 6; ++e) {
      const auto [i, j] = places_of_edges[e];
      const auto [a, b] = std::minmax(regular_.cells[c][i], regular_.cells[c][j]);
      uses.push_back({{a, b}, static_cast<int>(c), e});
    }
  }
  parallel_region(progress, [&] { tbb::parallel_sort(uses.begin(), uses.end()); });
  edges_of_cell_.resize(regular_.cells.size());
  for (const Use& use : uses) {
    if (edges_.empty() || edges_.back() != use.balls) edges_.push_back(use.balls);
    edges_of_cell_[use.cell][use.edge] = static_cast<int>(edges_.size()) - 1;
  }
}

void Mixed_complex_3::number_triangles() {
  triangles_of_cell_.resize(regular_.cells.size());
  for (int c = 0; c < std::ssize(regular_.cells); ++c) {
    if (regular_.is_infinite(c)) continue;
    for (int i = 0; i < 4; ++i) {
      const int across = regular_.neighbors[c][i];
      if (across < c && !regular_.is_infinite(across)) {
        const auto place = std::ranges::find(regular_.neighbors[across], c) - regular_.neighbors[across].begin();
        triangles_of_cell_[c][i] = triangles_of_cell_[across][place];
        continue;
      }
      triangles_of_cell_[c][i] = static_cast<int>(triangles_.size());
      std::array<int, 3> balls{};
      for (int k = 0; k < 3; ++k) balls[k] = regular_.cells[c][k < i ? k : k + 1];
      triangles_.push_back(balls);
      cell_of_triangle_.push_back({c, i});
    }
  }
}

void Mixed_complex_3::measure(Progress& progress) {
  powers_.resize(simplex_count());
  for (std::size_t b = 0; b < weights_.size(); ++b) powers_[b] = {-weights_[b], -weights_[b]};
  constexpr std::size_t block = 4096;
  const std::size_t first = first_edge();
  const std::size_t count = powers_.size() - first;
  parallel_blocks((count + block - 1) / block, progress, [&](std::size_t part) {
    const CGAL::Protect_FPU_rounding<true> upward_rounding;
    for (std::size_t s = first + part * block; s < std::min(first + (part + 1) * block, powers_.size()); ++s) {
      const Simplex simplex = balls_of(static_cast<int>(s));
      if (std::ranges::min(simplex) < 0) continue;
      double size = 0;
      for (const int ball : simplex) size = std::max(size, weights_[ball]);
      auto power = with_points<Unprotected_interval>(simplex, regular_.balls, weights_, squared_radius);
      // Those of nearly flat simplices are asked for again and again.
      constexpr double precise = 1e-9;
      const double most = std::max(std::abs(power.inf()), std::abs(power.sup()));
      if (!std::isfinite(most) || !(power.sup() - power.inf() <= precise * std::max(size, most))) {
        const auto [lower, upper] =
            CGAL::to_interval(with_points<Rational>(simplex, regular_.balls, weights_, squared_radius));
        power = {lower, upper};
      }
      powers_[s] = {power.inf(), power.sup()};
    }
  });
}

void Mixed_complex_3::find_anchors(Progress& progress) {
  const Orthogonal_spheres_3 spheres(regular_.balls);
  // Per simplex and place: the center is not on the side of the ball there of the face across from it.
  std::vector<std::uint8_t> beyond(powers_.size(), 0);
  const auto look = [&]<std::size_t Count>(std::size_t s, const std::array<int, Count>& balls) {
    for (std::size_t i = 0; i < Count; ++i) {
      std::array<int, Count - 1> face{};
      for (std::size_t k = 0; k + 1 < Count; ++k) face[k] = balls[k < i ? k : k + 1];
      if (spheres.power(balls[i], face) != CGAL::LARGER) beyond[s] = static_cast<std::uint8_t>(beyond[s] | 1U << i);
    }
  };
  const int edge = first_edge();
  const int triangle = first_triangle();
  const int cell = first_cell();
  parallel_for(edges_.size(), progress, [&](std::size_t e) { look(edge + e, edges_[e]); });
  parallel_for(triangles_.size(), progress, [&](std::size_t t) { look(triangle + t, triangles_[t]); });
  parallel_for(regular_.cells.size(), progress, [&](std::size_t c) {
    if (!regular_.is_infinite(static_cast<int>(c))) look(cell + c, regular_.cells[c]);
  });

  // Calls use(face, place) for the faces of a simplex, which are without the ball in that place.
  const auto for_faces = [&](int s, const auto& use) {
    if (s >= cell) {
      for (int i = 0; i < 4; ++i) use(triangle + triangles_of_cell_[s - cell][i], i);
    } else if (s >= triangle) {
      const int c = cell_of_triangle_[s - triangle][0];
      const int across = cell_of_triangle_[s - triangle][1];
      for (int i = 0; i < 3; ++i) {
        const auto place = [&](int k) { return k < across ? k : k + 1; };
        use(edge + edges_of_cell_[c][edge_between(place((i + 1) % 3), place((i + 2) % 3))], i);
      }
    } else {
      for (int i = 0; i < 2; ++i) use(edges_[s - edge][1 - i], i);
    }
  };
  // Of balls in a grid the same ones are asked for again and again.
  std::unordered_map<int, Rational> exact_powers;
  const auto exact_power = [&](int s) -> const Rational& {
    const auto [it, is_new] = exact_powers.try_emplace(s);
    if (is_new) it->second = with_points<Rational>(balls_of(s), regular_.balls, weights_, squared_radius);
    return it->second;
  };
  const auto compare_powers = [&](int s, int t) {
    if (s == t) return std::weak_ordering::equivalent;
    if (powers_[s].upper < powers_[t].lower) return std::weak_ordering::less;
    if (powers_[s].lower > powers_[t].upper) return std::weak_ordering::greater;
    const CGAL::Comparison_result order = CGAL::compare(exact_power(s), exact_power(t));
    if (order == CGAL::EQUAL) return std::weak_ordering::equivalent;
    return order == CGAL::SMALLER ? std::weak_ordering::less : std::weak_ordering::greater;
  };
  const auto is_finite = [&](int s) { return s < cell || !regular_.is_infinite(s - cell); };

  constexpr int often = 1024;
  anchors_.resize(powers_.size());
  for (int s = 0; s < simplex_count(); ++s) {
    anchors_[s] = s;
    if (s < edge || beyond[s] == 0 || !is_finite(s)) continue;
    if (s % often == 0) progress.check();
    int best = -1;
    for_faces(s, [&](int face, int) {
      if (best < 0 || compare_powers(anchors_[face], best) > 0) best = anchors_[face];
    });
    anchors_[s] = best;
  }

  // The least of power and number, as power faces may be degenerate.
  dual_anchors_.assign(powers_.size(), -1);
  std::vector<std::uint8_t> is_outside(powers_.size(), 0);
  for (int s = simplex_count() - 1; s >= 0; --s) {
    if (s % often == 0) progress.check();
    if (!is_finite(s)) continue;
    if (dual_anchors_[s] < 0 || is_outside[s] == 0) dual_anchors_[s] = s;
    if (s < edge) continue;
    const int own = dual_anchors_[s];
    for_faces(s, [&](int face, int place) {
      if ((beyond[s] >> static_cast<unsigned>(place) & 1U) != 0) is_outside[face] = 1;
      int& best = dual_anchors_[face];
      if (best >= 0) {
        const auto order = compare_powers(own, best);
        if (order > 0 || (order == 0 && own > best)) return;
      }
      best = own;
    });
  }
  progress.check();
}

bool Mixed_complex_3::is_inside(const Corner& corner) const {
  const Range& power = powers_[corner.simplex];
  const Range& dual_power = powers_[corner.dual];
  const double s = shrink_factor_;
  constexpr double error = 4 * std::numeric_limits<double>::epsilon();
  const auto value = [&](double p, double q) {
    return std::pair(s * q + (1 - s) * p, error * (s * std::abs(q) + (1 - s) * std::abs(p)));
  };
  if (const auto [least, slack] = value(power.lower, dual_power.lower); least > slack) return false;
  if (const auto [most, slack] = value(power.upper, dual_power.upper); most < -slack) return true;
  const auto exact = [&](int simplex) {
    return with_points<Rational>(balls_of(simplex), regular_.balls, weights_, squared_radius);
  };
  return CGAL::is_negative(Rational(s) * exact(corner.dual) + (1 - Rational(s)) * exact(corner.simplex));
}

Mixed_complex_3::Place Mixed_complex_3::place(const Corner& corner) const {
  const auto point = [&](int simplex) -> Point_3 {
    const Simplex balls = balls_of(simplex);
    const Point_3& origin = regular_.balls[balls[0]].center;
    double size = 0;
    for (const int ball : balls) size = std::max(size, squared_distance(origin, regular_.balls[ball].center));
    size = std::sqrt(size);
    std::array<double, 3> result{};
    {
      const CGAL::Protect_FPU_rounding<true> upward_rounding;
      const auto rough = with_points<Unprotected_interval>(balls, regular_.balls, weights_, center);
      constexpr double precise = 1e-12;
      bool is_sure = true;
      for (int k = 0; k < 3; ++k) {
        result[k] = (rough[k].inf() + rough[k].sup()) / 2;
        is_sure = is_sure && std::isfinite(result[k]) &&
                  rough[k].sup() - rough[k].inf() <= precise * std::max(size, std::abs(result[k]));
      }
      if (!is_sure) {
        const auto sure = with_points<Rational>(balls, regular_.balls, weights_, center);
        for (int k = 0; k < 3; ++k) result[k] = CGAL::to_double(sure[k]);
      }
    }
    return {result[0], result[1], result[2]};
  };
  const auto middle = [](const Range& range) { return (range.lower + range.upper) / 2; };
  return {point(corner.simplex), point(corner.dual), -middle(powers_[corner.simplex]), middle(powers_[corner.dual])};
}

double Mixed_complex_3::value(const Place& place) const {
  return shrink_factor_ * place.dual_power - (1 - shrink_factor_) * place.weight;
}

}  // namespace mesecina
