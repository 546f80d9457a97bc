// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/union_3/power_oracle_3.h"

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <set>
#include <stdexcept>

namespace mesecina::test {

namespace {

using Interval = CGAL::Interval_nt<true>;

int certain_sign(const Rational& value) { return static_cast<int>(CGAL::sign(value)); }
/// 2 for unknown.
int certain_sign(const Interval& value) {
  if (value.inf() > 0) return 1;
  if (value.sup() < 0) return -1;
  return value.inf() == 0 && value.sup() == 0 ? 0 : 2;
}

template <class Number>
struct Vector {
  Number x, y, z;
};
template <class Number>
Number dot_product(const Vector<Number>& a, const Vector<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Number>
Vector<Number> cross_product(const Vector<Number>& a, const Vector<Number>& b) {
  return {Number(a.y * b.z - a.z * b.y), Number(a.z * b.x - a.x * b.z), Number(a.x * b.y - a.y * b.x)};
}
template <class Number>
Vector<Number> vector(const Ball_3& from, const Ball_3& to) {
  return {Number(Number(to.center.x) - Number(from.center.x)), Number(Number(to.center.y) - Number(from.center.y)),
          Number(Number(to.center.z) - Number(from.center.z))};
}
double weight(const Ball_3& ball) { return ball.radius * ball.radius; }

/// The least sphere orthogonal to one to four balls, relative to the first of them.
template <class Number>
struct Orthogonal {
  std::vector<Vector<Number>> sides;  ///< to the other balls
  std::vector<Number> factors;        ///< the center is the sum of these times the sides, by `determinant`
  Number determinant = Number(1);     ///< 0 for centers that are affinely dependent, otherwise positive
  Number power = Number(0);           ///< times the determinant

  Orthogonal(std::span<const Ball_3> balls, const std::vector<int>& simplex) {
    const Ball_3& first = balls[simplex[0]];
    std::vector<Number> right;
    for (std::size_t i = 1; i < simplex.size(); ++i) {
      const Ball_3& other = balls[simplex[i]];
      sides.push_back(vector<Number>(first, other));
      right.push_back((dot_product(sides.back(), sides.back()) + Number(weight(first)) - Number(weight(other))) /
                      Number(2));
    }
    const auto gram = [this](std::size_t i, std::size_t j) { return dot_product(sides[i], sides[j]); };
    if (sides.size() == 1) {
      determinant = gram(0, 0);
      factors = {right[0]};
    } else if (sides.size() == 2) {
      determinant = gram(0, 0) * gram(1, 1) - gram(0, 1) * gram(0, 1);
      factors = {Number(right[0] * gram(1, 1) - right[1] * gram(0, 1)),
                 Number(right[1] * gram(0, 0) - right[0] * gram(0, 1))};
    } else if (sides.size() == 3) {
      std::array<Vector<Number>, 3> rows{{{gram(0, 0), gram(0, 1), gram(0, 2)},
                                          {gram(1, 0), gram(1, 1), gram(1, 2)},
                                          {gram(2, 0), gram(2, 1), gram(2, 2)}}};
      determinant = dot_product(rows[0], cross_product(rows[1], rows[2]));
      const Vector<Number> r{right[0], right[1], right[2]};
      factors = {dot_product(r, cross_product(rows[1], rows[2])), dot_product(rows[0], cross_product(r, rows[2])),
                 dot_product(rows[0], cross_product(rows[1], r))};
    }
    power = -Number(weight(first)) * determinant;
    for (std::size_t i = 0; i < sides.size(); ++i) power += factors[i] * right[i];
  }

  /// Power to the ball less that to the simplex, times the determinant.
  Number excess(std::span<const Ball_3> balls, int first, int ball) const {
    const Vector<Number> side = vector<Number>(balls[first], balls[ball]);
    Number result =
        determinant * (dot_product(side, side) + Number(weight(balls[first])) - Number(weight(balls[ball])));
    for (std::size_t i = 0; i < sides.size(); ++i) result -= Number(2) * factors[i] * dot_product(sides[i], side);
    return result;
  }
};

bool is_out(std::span<const Ball_3> balls, const std::vector<int>& candidates, const std::vector<int>& simplex) {
  const Orthogonal<Interval> sphere(balls, simplex);
  if (certain_sign(sphere.determinant) != 1) return false;
  if (certain_sign(sphere.power) == 1) return true;
  return std::ranges::any_of(candidates,
                             [&](int k) { return certain_sign(sphere.excess(balls, simplex[0], k)) == -1; });
}

/// Calls with every set of `least` to `most` of the candidates.
template <class Visit>
void for_each_subset(const std::vector<int>& candidates, std::size_t least, std::size_t most, const Visit& visit) {
  std::vector<int> chosen;
  const auto extend = [&](const auto& self, std::size_t next) -> void {
    if (chosen.size() >= least) visit(chosen);
    if (chosen.size() == most) return;
    for (std::size_t i = next; i < candidates.size(); ++i) {
      chosen.push_back(candidates[i]);
      self(self, i + 1);
      chosen.pop_back();
    }
  };
  extend(extend, 0);
}

std::vector<int> candidates_of(std::span<const Ball_3> balls) {
  if (balls.size() > 32) throw std::invalid_argument("the oracle takes at most 32 balls");
  const std::vector<std::uint8_t> is_left_out = are_concentric_with_another(balls);
  std::vector<int> result;
  for (int i = 0; i < static_cast<int>(balls.size()); ++i)
    if (!is_left_out[i]) result.push_back(i);
  return result;
}

/// Sign of a + b sqrt(c) for c >= 0.
int sign_with_root(const Rational& a, const Rational& b, const Rational& c) {
  const int sign_a = certain_sign(a);
  const int sign_b = certain_sign(c) == 0 ? 0 : certain_sign(b);
  if (sign_a == 0 || sign_b == 0 || sign_a == sign_b) return sign_a != 0 ? sign_a : sign_b;
  return certain_sign(Rational(a * a - b * b * c)) * sign_a;
}

/// Whether every ball of vectors around 0, which span space, has points that none of the vectors points towards.
bool has_free_direction(const std::vector<Vector<Rational>>& vectors) {
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vector<Rational> normal = cross_product(vectors[i], vectors[j]);
      if (certain_sign(dot_product(normal, normal)) == 0) continue;
      bool is_above = false;
      bool is_below = false;
      for (const auto& v : vectors) {
        const int side = certain_sign(dot_product(normal, v));
        is_above = is_above || side > 0;
        is_below = is_below || side < 0;
      }
      if (!is_above || !is_below) return true;
    }
  }
  return false;
}

/// Where the spheres of three balls meet: the center of their orthogonal sphere, and along the normal from there.
class Triple {
 public:
  Triple(std::span<const Ball_3> balls, const std::vector<int>& simplex)
      : balls_(balls), simplex_(simplex), sphere_(balls, simplex) {
    if (certain_sign(sphere_.determinant) == 0) return;
    // The determinant is the square of the normal.
    normal_ = cross_product(sphere_.sides[0], sphere_.sides[1]);
    square_ = -sphere_.power / sphere_.determinant / sphere_.determinant;
    is_real_ = certain_sign(square_) >= 0;
  }

  bool is_real() const { return is_real_; }
  bool is_single() const { return certain_sign(square_) == 0; }

  /// Sign of the power to the ball of the point above (side 1) or below (-1).
  int power_sign(int ball, int side) const {
    const Vector<Rational> u = vector<Rational>(balls_[simplex_[0]], balls_[ball]);
    const Rational at_center = sphere_.excess(balls_, simplex_[0], ball) / sphere_.determinant;
    return sign_with_root(at_center, Rational(-2 * side * dot_product(u, normal_)), square_);
  }
  /// Rounded.
  Point_3 point(int side) const {
    const double along = side * std::sqrt(CGAL::to_double(square_));
    Vector<Rational> foot{0, 0, 0};
    for (std::size_t i = 0; i < 2; ++i) {
      const Rational factor = sphere_.factors[i] / sphere_.determinant;
      foot.x += factor * sphere_.sides[i].x;
      foot.y += factor * sphere_.sides[i].y;
      foot.z += factor * sphere_.sides[i].z;
    }
    const Point_3 normal{CGAL::to_double(normal_.x), CGAL::to_double(normal_.y), CGAL::to_double(normal_.z)};
    const Point_3& c = balls_[simplex_[0]].center;
    return Point_3{CGAL::to_double(Rational(foot.x + Rational(c.x))), CGAL::to_double(Rational(foot.y + Rational(c.y))),
                   CGAL::to_double(Rational(foot.z + Rational(c.z)))} +
           along * normal;
  }

 private:
  std::span<const Ball_3> balls_;
  std::vector<int> simplex_;
  Orthogonal<Rational> sphere_;
  Vector<Rational> normal_{0, 0, 0};
  Rational square_ = -1;
  bool is_real_ = false;
};

/// Whether a point where these spheres meet, none of which has it inside its ball, is on the boundary of the union.
bool is_on_boundary(std::span<const Ball_3> balls, const std::vector<int>& on_sphere) {
  std::optional<bool> result;
  for_each_subset(on_sphere, 4, 4, [&](const std::vector<int>& simplex) {
    if (result) return;
    const Orthogonal<Rational> sphere(balls, simplex);
    if (certain_sign(sphere.determinant) == 0) return;
    Vector<Rational> center{0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      const Rational factor = sphere.factors[i] / sphere.determinant;
      center.x += factor * sphere.sides[i].x;
      center.y += factor * sphere.sides[i].y;
      center.z += factor * sphere.sides[i].z;
    }
    std::vector<Vector<Rational>> towards_centers;
    for (const int k : on_sphere) {
      const Vector<Rational> u = vector<Rational>(balls[simplex[0]], balls[k]);
      towards_centers.push_back({Rational(u.x - center.x), Rational(u.y - center.y), Rational(u.z - center.z)});
    }
    result = has_free_direction(towards_centers);
  });
  // Centers in a plane leave the directions along its normal free.
  return result.value_or(true);
}

}  // namespace

std::vector<int> members(Ball_set set) {
  std::vector<int> result;
  for (int i = 0; i < 32; ++i)
    if (set & bit(i)) result.push_back(i);
  return result;
}

int orientation(const Ball_3& a, const Ball_3& b, const Ball_3& c, const Ball_3& d) {
  const auto normal = cross_product(vector<Rational>(a, b), vector<Rational>(a, c));
  return certain_sign(dot_product(normal, vector<Rational>(a, d)));
}

int power_sign(std::span<const Ball_3> balls, const std::array<int, 4>& cell, int ball) {
  return certain_sign(Orthogonal<Rational>(balls, {cell.begin(), cell.end()}).excess(balls, cell[0], ball));
}

std::vector<std::uint8_t> are_concentric_with_another(std::span<const Ball_3> balls) {
  std::vector<std::uint8_t> result(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i)
    for (std::size_t j = 0; j < balls.size(); ++j)
      if (i != j && balls[i].center == balls[j].center &&
          (balls[j].radius > balls[i].radius || (balls[j].radius == balls[i].radius && j < i)))
        result[i] = 1;
  return result;
}

std::vector<Power_minimum> power_minima(std::span<const Ball_3> balls) {
  const std::vector<int> candidates = candidates_of(balls);
  std::vector<Power_minimum> result;
  for_each_subset(candidates, 1, 4, [&](const std::vector<int>& simplex) {
    if (is_out(balls, candidates, simplex)) return;
    const Orthogonal<Rational> sphere(balls, simplex);
    if (certain_sign(sphere.determinant) == 0 || certain_sign(sphere.power) > 0) return;
    Ball_set nearest = 0;
    for (const int k : candidates) {
      const int excess = certain_sign(sphere.excess(balls, simplex[0], k));
      if (excess < 0) return;
      if (excess == 0) nearest |= bit(k);
    }
    result.push_back({set_of(simplex), nearest, certain_sign(sphere.power) == 0});
  });
  return result;
}

bool is_general(std::span<const Power_minimum> minima) {
  return std::ranges::all_of(minima, [](const Power_minimum& m) { return m.simplex == m.nearest; });
}

std::vector<Ball_set> nerve(std::span<const Power_minimum> minima) {
  std::set<Ball_set> result;
  for (const Power_minimum& m : minima)
    for_each_subset(members(m.nearest), 1, 4, [&](const std::vector<int>& part) { result.insert(set_of(part)); });
  return {result.begin(), result.end()};
}

std::size_t rank_mod_2(std::vector<std::vector<int>> columns) {
  std::map<int, std::size_t> column_of_pivot;
  std::size_t rank = 0;
  std::vector<int> sum;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::vector<int>& column = columns[i];
    std::ranges::sort(column);
    while (!column.empty()) {
      const auto [it, is_new] = column_of_pivot.try_emplace(column.back(), i);
      if (is_new) {
        ++rank;
        break;
      }
      sum.clear();
      std::ranges::set_symmetric_difference(column, columns[it->second], std::back_inserter(sum));
      column.swap(sum);
    }
  }
  return rank;
}

Topology topology_of_simplices(const std::vector<Ball_set>& simplices) {
  std::array<std::map<Ball_set, int>, 4> index;
  std::array<std::vector<std::vector<int>>, 4> boundary;
  for (int size = 1; size <= 4; ++size) {
    for (const Ball_set simplex : simplices) {
      if (std::popcount(simplex) != size) continue;
      index[size - 1].emplace(simplex, static_cast<int>(index[size - 1].size()));
      if (size == 1) continue;
      std::vector<int> column;
      for (const int i : members(simplex)) column.push_back(index[size - 2].at(simplex & ~bit(i)));
      boundary[size - 1].push_back(column);
    }
  }
  std::array<std::int64_t, 5> rank{};
  for (int d = 1; d < 4; ++d) rank[d] = static_cast<std::int64_t>(rank_mod_2(boundary[d]));
  Topology result;
  for (int d = 0; d < 3; ++d) result.betti[d] = static_cast<std::int64_t>(index[d].size()) - rank[d] - rank[d + 1];
  result.euler = result.betti[0] - result.betti[1] + result.betti[2];
  return result;
}

std::vector<Oracle_vertex_3> vertices_by_definition(std::span<const Ball_3> balls) {
  const std::vector<int> candidates = candidates_of(balls);
  std::vector<Oracle_vertex_3> result;
  for_each_subset(candidates, 3, 3, [&](const std::vector<int>& simplex) {
    const Orthogonal<Interval> rough(balls, simplex);
    if (certain_sign(rough.determinant) == 1 && certain_sign(rough.power) == 1) return;
    const Triple triple(balls, simplex);
    if (!triple.is_real()) return;
    for (const int side : {1, -1}) {
      if (side == -1 && triple.is_single()) continue;
      std::vector<int> on_sphere;
      bool is_covered = false;
      for (const int k : candidates) {
        const int power = triple.power_sign(k, side);
        is_covered = is_covered || power < 0;
        if (power == 0) on_sphere.push_back(k);
      }
      if (is_covered) continue;
      // Once, from its first triple that is not on a line.
      bool is_first = true;
      for_each_subset(on_sphere, 3, 3, [&](const std::vector<int>& other) {
        if (other >= simplex || !is_first) return;
        is_first = certain_sign(Orthogonal<Rational>(balls, other).determinant) == 0;
      });
      if (is_first) result.push_back({set_of(on_sphere), triple.point(side), is_on_boundary(balls, on_sphere)});
    }
  });
  return result;
}

}  // namespace mesecina::test
