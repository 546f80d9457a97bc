// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/orthogonal_spheres_3.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mesecina {

namespace {

using Weighted_point = CGAL::Exact_predicates_inexact_constructions_kernel::Weighted_point_3;

struct Displacement {
  double x, y, z;
};
double dot(const Displacement& u, const Displacement& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
Displacement cross(const Displacement& u, const Displacement& v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// A ball as seen from another one, the first. The center of a sphere orthogonal to both has, from there, the dot
/// product `half` with `away`.
struct Seen {
  Displacement away;
  double square;  ///< of the distance
  double half;
  double size;  ///< at least twice `half`, and what it is made of
};

Seen seen(const Weighted_point& from, const Weighted_point& p) {
  const Displacement away{p.x() - from.x(), p.y() - from.y(), p.z() - from.z()};
  const double square = dot(away, away);
  const double weight = from.weight() - p.weight();
  return {away, square, (square + weight) / 2, square + std::abs(weight)};
}

/// The sign, where it is known; EQUAL for none. Of what may overflow, or lose to underflow, nothing is known.
CGAL::Comparison_result certain(double value, double error) {
  constexpr double least = 1e-280;
  constexpr double most = 1e280;
  if (!(error > least && error < most)) return CGAL::EQUAL;
  if (value > error) return CGAL::LARGER;
  if (-value > error) return CGAL::SMALLER;
  return CGAL::EQUAL;
}

// The bounds: with u = 2^-53 a square of a distance or a dot product is known to 6 u times the largest square, `half`
// to 8 u times the size. Each bound below is at least four times what follows from that for its terms.

/// Of half² / square - weight.
CGAL::Comparison_result quick_sign(const Weighted_point& a, const Weighted_point& b) {
  const Seen u = seen(a, b);
  constexpr double relative_error = 0x1p-46;
  return certain(u.half * u.half - a.weight() * u.square, relative_error * (u.size * u.size + a.weight() * u.square));
}

CGAL::Comparison_result quick_sign(const Weighted_point& a, const Weighted_point& b, const Weighted_point& c) {
  const Seen u = seen(a, b);
  const Seen v = seen(a, c);
  const double uv = dot(u.away, v.away);
  const double value = u.half * u.half * v.square - 2 * u.half * v.half * uv + v.half * v.half * u.square -
                       a.weight() * (u.square * v.square - uv * uv);
  const double square = std::max(u.square, v.square);
  const double size = std::max(u.size, v.size);
  constexpr double relative_error = 0x1p-44;
  return certain(value, relative_error * square * (size * size + a.weight() * square));
}

CGAL::Comparison_result quick_sign(const Weighted_point& a, const Weighted_point& b, const Weighted_point& c,
                                   const Weighted_point& d) {
  const Seen u = seen(a, b);
  const Seen v = seen(a, c);
  const Seen w = seen(a, d);
  const Displacement vw = cross(v.away, w.away);
  const Displacement wu = cross(w.away, u.away);
  const Displacement uv = cross(u.away, v.away);
  const Displacement center{u.half * vw.x + v.half * wu.x + w.half * uv.x,
                            u.half * vw.y + v.half * wu.y + w.half * uv.y,
                            u.half * vw.z + v.half * wu.z + w.half * uv.z};
  const double volume = dot(u.away, vw);
  const double square = std::max({u.square, v.square, w.square});
  const double size = std::max({u.size, v.size, w.size});
  constexpr double relative_error = 0x1p-40;
  return certain(dot(center, center) - a.weight() * volume * volume,
                 relative_error * square * square * (size * size + a.weight() * square));
}

/// Of the power of the last ball to the sphere: half - center * away.
CGAL::Comparison_result quick_power(const Weighted_point& a, const Weighted_point& b, const Weighted_point& other) {
  const Seen u = seen(a, b);
  const Seen p = seen(a, other);
  const double square = std::max(u.square, p.square);
  const double size = std::max(u.size, p.size);
  constexpr double relative_error = 0x1p-45;
  return certain(p.half * u.square - u.half * dot(u.away, p.away), relative_error * square * size);
}

CGAL::Comparison_result quick_power(const Weighted_point& a, const Weighted_point& b, const Weighted_point& c,
                                    const Weighted_point& other) {
  const Seen u = seen(a, b);
  const Seen v = seen(a, c);
  const Seen p = seen(a, other);
  const double uv = dot(u.away, v.away);
  const double value = p.half * (u.square * v.square - uv * uv) -
                       (u.half * v.square - v.half * uv) * dot(u.away, p.away) -
                       (v.half * u.square - u.half * uv) * dot(v.away, p.away);
  const double square = std::max({u.square, v.square, p.square});
  const double size = std::max({u.size, v.size, p.size});
  constexpr double relative_error = 0x1p-43;
  return certain(value, relative_error * square * square * size);
}

template <class Function, std::size_t... Places>
auto with_points(const Function& function, const std::vector<Weighted_point>& points,
                 const std::array<int, sizeof...(Places)>& balls, std::index_sequence<Places...>) {
  return function(points[balls[Places]]...);
}

}  // namespace

Orthogonal_spheres_3::Orthogonal_spheres_3(std::span<const Ball_3> balls) {
  points_.reserve(balls.size());
  for (const auto& [c, r] : balls) points_.push_back(Weighted_point({c.x, c.y, c.z}, r * r));
}

template <std::size_t Count>
CGAL::Comparison_result Orthogonal_spheres_3::sign(const std::array<int, Count>& balls) const {
  const auto decide = [&](const auto&... points) {
    const CGAL::Comparison_result quick = quick_sign(points...);
    return quick != CGAL::EQUAL ? quick : kernel_.compare_weighted_squared_radius_3_object()(points..., 0);
  };
  return with_points(decide, points_, balls, std::make_index_sequence<Count>());
}
template CGAL::Comparison_result Orthogonal_spheres_3::sign(const std::array<int, 2>&) const;
template CGAL::Comparison_result Orthogonal_spheres_3::sign(const std::array<int, 3>&) const;
template CGAL::Comparison_result Orthogonal_spheres_3::sign(const std::array<int, 4>&) const;

template <std::size_t Count>
CGAL::Comparison_result Orthogonal_spheres_3::power(int other, const std::array<int, Count>& balls) const {
  const auto decide = [&](const auto&... points) {
    if constexpr (Count == 1) {
      return kernel_.compare_power_distance_3_object()(points.point()..., points_[other], points...);
    } else {
      const CGAL::Comparison_result quick = quick_power(points..., points_[other]);
      if (quick != CGAL::EQUAL) return quick;
      return CGAL::enum_cast<CGAL::Comparison_result>(
          CGAL::opposite(kernel_.power_side_of_bounded_power_sphere_3_object()(points..., points_[other])));
    }
  };
  return with_points(decide, points_, balls, std::make_index_sequence<Count>());
}
template CGAL::Comparison_result Orthogonal_spheres_3::power(int, const std::array<int, 1>&) const;
template CGAL::Comparison_result Orthogonal_spheres_3::power(int, const std::array<int, 2>&) const;
template CGAL::Comparison_result Orthogonal_spheres_3::power(int, const std::array<int, 3>&) const;

}  // namespace mesecina
