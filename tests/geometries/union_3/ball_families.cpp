// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/geometries/shapes.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {

namespace {

using Balls = std::vector<Ball_3>;

/// An integer vector and its length, which is an integer too.
struct Whole_vector {
  Point_3 direction;
  double length = 1;
};

Whole_vector whole_vector(Random& random) {
  static constexpr std::array<std::array<int, 4>, 5> quadruples{
      {{0, 0, 1, 1}, {0, 3, 4, 5}, {1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}}};
  const auto& q = quadruples[random.index(static_cast<int>(quadruples.size()))];
  std::array<double, 3> v{};
  const int turn = random.index(3);
  for (int i = 0; i < 3; ++i) v[(i + turn) % 3] = random.chance(0.5) ? q[i] : -q[i];
  return {{v[0], v[1], v[2]}, static_cast<double>(q[3])};
}

Point_3 random_point(Random& random, double extent) {
  const double x = random.uniform(-extent, extent);
  const double y = random.uniform(-extent, extent);
  const double z = random.uniform(-extent, extent);
  return {x, y, z};
}

Point_3 random_direction(Random& random) {
  for (;;) {
    const Point_3 p = random_point(random, 1);
    const double square = dot(p, p);
    if (square > 0.01 && square < 1) return (1 / std::sqrt(square)) * p;
  }
}

Point_3 whole_point(Random& random, int extent) {
  const double x = random.index(extent);
  const double y = random.index(extent);
  const double z = random.index(extent);
  return {x, y, z};
}

Balls random_balls(Random& random, int count, double extent, double low, double high) {
  Balls result;
  for (int i = 0; i < count; ++i) {
    const Point_3 center = random_point(random, extent);
    result.push_back({center, random.uniform(low, high)});
  }
  return result;
}

Balls sparse(std::uint64_t seed) {
  Random random(seed);
  return random_balls(random, 1 + random.index(12), 6, 0, 4);
}
Balls dense(std::uint64_t seed) {
  Random random(seed);
  return random_balls(random, 4 + random.index(9), 4, 0.5, 4);
}
Balls equal_radii(std::uint64_t seed) {
  Random random(seed);
  return random_balls(random, 4 + random.index(9), 4, 2.5, 2.5);
}
Balls nested(std::uint64_t seed) {
  Random random(seed);
  Balls result = random_balls(random, 3, 4, 3, 5);
  while (result.size() < 10) {
    const Ball_3 outer = result[random.index(static_cast<int>(result.size()))];
    const double r = outer.radius * random.uniform(0.1, 0.9);
    const double reach = (outer.radius - r) * random.uniform(0, 1.2);
    result.push_back({outer.center + reach * random_direction(random), r});
  }
  return result;
}
/// Each ball touches an earlier one, from outside or inside, exactly.
Balls tangent(std::uint64_t seed) {
  Random random(seed);
  Balls result{{{0, 0, 0}, 3.0 * (1 + random.index(6))}};
  const int count = 2 + random.index(8);
  while (static_cast<int>(result.size()) < count) {
    const Ball_3 other = result[random.index(static_cast<int>(result.size()))];
    const Whole_vector v = whole_vector(random);
    const double r = v.length * (1 + random.index(4)) - other.radius;
    result.push_back({other.center + ((other.radius + r) / v.length) * v.direction, std::abs(r)});
  }
  return result;
}
Balls duplicates(std::uint64_t seed) {
  Random random(seed);
  Balls result = random_balls(random, 5, 3, 0.5, 3);
  for (int i = 0; i < 5; ++i) {
    const Ball_3 copy = result[random.index(static_cast<int>(result.size()))];
    result.insert(result.begin() + random.index(static_cast<int>(result.size()) + 1), copy);
  }
  return result;
}
Balls collinear(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  const Whole_vector v = whole_vector(random);
  const int count = 1 + random.index(8);
  for (int i = 0; i < count; ++i) {
    const double t = random.index(12);
    const double r = v.length * random.index(4);
    result.push_back({t * v.direction, r});
  }
  return result;
}
/// In a plane through whole points.
Balls coplanar(std::uint64_t seed) {
  Random random(seed);
  const Point_3 u = whole_vector(random).direction;
  const Point_3 v = whole_vector(random).direction;
  const bool is_whole = random.chance(0.5);
  Balls result;
  const int count = 3 + random.index(9);
  for (int i = 0; i < count; ++i) {
    const double a = random.index(5);
    const double b = random.index(5);
    const double r = random.uniform(1, 5);
    result.push_back({a * u + b * v, is_whole ? std::round(r) : r});
  }
  return result;
}
Balls coplanar_general(std::uint64_t seed) {
  Random random(seed);
  Balls result = random_balls(random, 3 + random.index(9), 4, 0.5, 3);
  for (Ball_3& b : result) b.center.z = 0;
  return result;
}
/// Whole centers and radii.
Balls grid(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  const int extent = 2 + random.index(5);
  const int count = 2 + random.index(10);
  for (int i = 0; i < count; ++i) {
    const Point_3 center = whole_point(random, extent);
    const double r = random.index(4);
    result.push_back({center, r});
  }
  return result;
}
/// Part of a lattice, equal balls: touching, crossing, or through the centers of cells.
Balls lattice(std::uint64_t seed) {
  Random random(seed);
  static constexpr std::array<std::array<double, 4>, 6> lattices{
      {{2, 2, 2, 1}, {2, 2, 2, 2}, {6, 8, 10, 5}, {4, 4, 2, 3}, {2, 4, 4, 3}, {2, 3, 6, 3.5}}};
  const auto& l = lattices[random.index(static_cast<int>(lattices.size()))];
  const double left_out = random.uniform(0, 0.6);
  Balls result;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j)
      for (int k = 0; k < 2; ++k)
        if (result.empty() || !random.chance(left_out)) result.push_back({{l[0] * i, l[1] * j, l[2] * k}, l[3]});
  return result;
}
/// On a grid of tenths, which are no doubles: touching on paper, and nearly so in fact.
Balls decimal(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  const int count = 2 + random.index(9);
  for (int i = 0; i < count; ++i) {
    const Point_3 p = whole_point(random, 6);
    const double r = 0.1 * random.index(4);
    result.push_back({{0.1 * p.x, 0.1 * p.y, 0.1 * p.z}, r});
  }
  return result;
}
/// All through one or two points, exactly, and a few others.
Balls through_points(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  const int count = 3 + random.index(8);
  for (int i = 0; i < count; ++i) {
    const Whole_vector v = whole_vector(random);
    const double factor = 1 + random.index(2);
    const Point_3 point{random.chance(0.3) ? 12.0 : 0.0, 0, 0};
    result.push_back({point + factor * v.direction, factor * v.length});
    if (random.chance(0.15)) result.push_back({point + 3 * random_direction(random), random.uniform(1, 3)});
  }
  return result;
}
/// Centers on a sphere, as seen from a point of equal power: one cell of the power diagram has many balls around it.
Balls cospherical(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  const int count = 4 + random.index(9);
  static constexpr std::array<double, 5> radii{4, 6, 7, 8, 9};
  const double r = radii[random.index(static_cast<int>(radii.size()))];
  for (int i = 0; i < count; ++i) {
    Point_3 p{2, 3, 6};
    if (random.chance(0.5)) std::swap(p.x, p.y);
    if (random.chance(0.5)) std::swap(p.y, p.z);
    if (random.chance(0.5)) p.x = -p.x;
    if (random.chance(0.5)) p.y = -p.y;
    if (random.chance(0.5)) p.z = -p.z;
    result.push_back({p, r});
  }
  return result;
}
/// All through one circle.
Balls pencil(std::uint64_t seed) {
  Random random(seed);
  static constexpr std::array<std::array<double, 2>, 7> on_axis{
      {{-9, 15}, {-5, 13}, {0, 12}, {5, 13}, {9, 15}, {16, 20}, {35, 37}}};
  Balls result;
  const int count = 2 + random.index(5);
  for (int i = 0; i < count; ++i) {
    const auto& b = on_axis[random.index(static_cast<int>(on_axis.size()))];
    result.push_back({{b[0], 0, 0}, b[1]});
  }
  const int others = random.index(4);
  for (int i = 0; i < others; ++i) result.push_back({random_point(random, 15), random.uniform(2, 10)});
  return result;
}
/// Around a tunnel.
Balls ring(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  const int count = 5 + random.index(7);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    const Point_3 shift = random_point(random, 0.3);
    result.push_back(
        {Point_3{5 * std::cos(angle), 5 * std::sin(angle), 0} + shift, 10.0 * std::numbers::pi / count * 0.6});
  }
  return result;
}
/// Around a cavity, when there are enough.
Balls shell(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  const double r = random.uniform(2.5, 4.5);
  const int count = 8 + random.index(5);
  for (int i = 0; i < count; ++i) {
    // Fibonacci's spiral, moved a little.
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double width = std::sqrt(1 - z * z);
    const Point_3 shift = random_point(random, 0.3);
    result.push_back({Point_3{5 * width * std::cos(angle), 5 * width * std::sin(angle), 5 * z} + shift, r});
  }
  return result;
}
Balls chain(std::uint64_t seed) {
  Random random(seed);
  Balls result{{{0, 0, 0}, 1}};
  const int count = 3 + random.index(9);
  while (static_cast<int>(result.size()) < count) {
    const Ball_3 last = result.back();
    const double r = random.uniform(0.4, 1.5);
    const double reach = random.uniform(0.5, 0.99) * (last.radius + r);
    result.push_back({last.center + reach * random_direction(random), r});
  }
  return result;
}
/// Clusters with tetrahedra, joined by single balls.
Balls clusters(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  for (int cluster = 0; cluster < 2; ++cluster)
    for (int i = 0; i < 4; ++i)
      result.push_back({Point_3{7.0 * cluster, 0, 0} + 1.2 * random_direction(random), random.uniform(1.2, 1.8)});
  const double height = random.uniform(-1, 1);
  result.push_back({{3, height, 0}, random.uniform(0.7, 1.4)});
  result.push_back({{4.5, 0, height}, random.uniform(0.7, 1.4)});
  return result;
}
Balls tiny_in_large(std::uint64_t seed) {
  Random random(seed);
  Balls result = random_balls(random, 4, 10, 5, 12);
  for (int i = 0; i < 6; ++i) {
    const Ball_3 outer = result[random.index(4)];
    const double r = std::ldexp(1.0, -random.index(12));
    result.push_back({outer.center + (outer.radius + r * random.uniform(-1, 1)) * random_direction(random), r});
  }
  return result;
}
Balls far_away(std::uint64_t seed) {
  Balls result = seed % 2 == 0 ? sparse(seed) : dense(seed);
  for (Ball_3& b : result) b.center = b.center + Point_3{1e6, -3e6, 2e6};
  return result;
}
/// Whole numbers moved by an ulp.
Balls nearly_special(std::uint64_t seed) {
  Random random(seed);
  Balls result;
  switch (seed % 4) {
    case 0:
      result = lattice(seed / 4);
      break;
    case 1:
      result = through_points(seed / 4);
      break;
    case 2:
      result = grid(seed / 4);
      break;
    default:
      result = cospherical(seed / 4);
  }
  const auto nudge = [&](double& value) {
    if (random.chance(0.3)) value = std::nextafter(value, random.chance(0.5) ? 1e3 : -1e3);
  };
  for (Ball_3& b : result) {
    nudge(b.center.x);
    nudge(b.center.y);
    nudge(b.center.z);
    if (b.radius > 0) nudge(b.radius);
  }
  return result;
}
Balls with_points(std::uint64_t seed) {
  Random random(seed);
  Balls result = seed % 2 == 0 ? dense(seed) : grid(seed);
  for (Ball_3& b : result)
    if (random.chance(0.3)) b.radius = 0;
  return result;
}
/// Balls through four samples, rounded: several spheres nearly through each sample.
Balls through_samples(std::uint64_t seed) {
  const std::vector<Smooth_solid> solids = smooth_solids();
  Balls result = inner_voronoi_balls(solids[seed % solids.size()], 9 + static_cast<int>(seed / 4 % 6), 0, seed);
  if (result.empty()) result.push_back({{0, 0, 0}, 1});
  if (result.size() > 12) result.resize(12);
  return result;
}

}  // namespace

std::vector<Ball_family> ball_families() {
  return {{"sparse", sparse},
          {"dense", dense},
          {"equal radii", equal_radii},
          {"nested", nested},
          {"tangent", tangent},
          {"duplicates", duplicates},
          {"collinear", collinear},
          {"coplanar", coplanar},
          {"coplanar, general", coplanar_general},
          {"grid", grid},
          {"lattice", lattice},
          {"decimal", decimal, true},
          {"through points", through_points},
          {"cospherical", cospherical},
          {"pencil", pencil},
          {"ring", ring},
          {"shell", shell},
          {"chain", chain},
          {"clusters", clusters},
          {"tiny in large", tiny_in_large},
          {"far away", far_away},
          {"nearly special", nearly_special, true},
          {"with points", with_points},
          {"through samples", through_samples, true}};
}

}  // namespace mesecina::test
