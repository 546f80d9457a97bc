// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/union/disk_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "geometries/crust_2/one_step_crust.h"
#include "geometries/labels_2/labels_2.h"
#include "tests/geometries/union/power_oracle.h"

namespace mesecina::test {

namespace {

using Disks = std::vector<Disk_2>;

struct Triple {
  int a, b, c;  ///< a^2 + b^2 = c^2
};
constexpr std::array<Triple, 5> triples{{{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}}};

/// One of the integer vectors of length c.
Point_2 integer_vector(Random& random, const Triple& t) {
  double x = t.a;
  double y = t.b;
  if (random.chance(0.2)) {
    x = t.c;
    y = 0;
  }
  if (random.chance(0.5)) std::swap(x, y);
  return {random.chance(0.5) ? x : -x, random.chance(0.5) ? y : -y};
}

Disks random_disks(Random& random, int count, double extent, double low, double high) {
  Disks result;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-extent, extent);
    const double y = random.uniform(-extent, extent);
    result.push_back({{x, y}, random.uniform(low, high)});
  }
  return result;
}

Disks sparse(std::uint64_t seed) {
  Random random(seed);
  return random_disks(random, 1 + random.index(14), 10, 0, 4);
}
Disks dense(std::uint64_t seed) {
  Random random(seed);
  return random_disks(random, 6 + random.index(10), 4, 0.2, 4);
}
Disks nested(std::uint64_t seed) {
  Random random(seed);
  Disks result = random_disks(random, 3, 6, 3, 5);
  while (result.size() < 12) {
    const Disk_2& outer = result[random.index(static_cast<int>(result.size()))];
    const double r = outer.radius * random.uniform(0.1, 0.9);
    const double reach = (outer.radius - r) * random.uniform(0, 1.1);
    const double angle = random.uniform(0, 6.3);
    result.push_back({{outer.center.x + reach * std::cos(angle), outer.center.y + reach * std::sin(angle)}, r});
  }
  return result;
}
/// Each disk touches an earlier one, from outside or inside, exactly.
Disks tangent(std::uint64_t seed) {
  Random random(seed);
  Disks result{{{0, 0}, 5.0 * (1 + random.index(6))}};
  const int count = 2 + random.index(10);
  while (static_cast<int>(result.size()) < count) {
    const Disk_2 other = result[random.index(static_cast<int>(result.size()))];
    const double r = 5.0 * random.index(7);
    const double reach = (random.chance(0.6) ? other.radius + r : std::abs(other.radius - r)) / 5;
    const Point_2 v = integer_vector(random, triples[0]);
    result.push_back({{other.center.x + reach * v.x, other.center.y + reach * v.y}, r});
  }
  return result;
}
/// On a grid of tenths, which are no doubles: touching on paper, and nearly so in fact.
Disks decimal(std::uint64_t seed) {
  Random random(seed);
  Disks result;
  const int count = 2 + random.index(10);
  for (int i = 0; i < count; ++i) {
    const double x = 0.1 * random.index(8);
    const double y = 0.1 * random.index(8);
    result.push_back({{x, y}, 0.1 * random.index(4)});
  }
  return result;
}
Disks equal_radii(std::uint64_t seed) {
  Random random(seed);
  Disks result = random_disks(random, 4 + random.index(10), 5, 2, 2);
  return result;
}
Disks duplicates(std::uint64_t seed) {
  Random random(seed);
  Disks result = random_disks(random, 6, 4, 0.5, 3);
  for (int i = 0; i < 6; ++i) {
    const Disk_2 copy = result[random.index(static_cast<int>(result.size()))];
    result.insert(result.begin() + random.index(static_cast<int>(result.size()) + 1), copy);
  }
  return result;
}
/// Centers on a line, whole coordinates, so that many touch.
Disks collinear(std::uint64_t seed) {
  Random random(seed);
  Disks result;
  const Point_2 v = integer_vector(random, triples[0]);
  const int count = 1 + random.index(9);
  for (int i = 0; i < count; ++i) {
    const int t = random.index(12);
    const double r = 5.0 * random.index(4);
    result.push_back({{t * v.x, t * v.y}, r});
  }
  return result;
}
Disks grid(std::uint64_t seed) {
  Random random(seed);
  Disks result;
  const int count = 3 + random.index(11);
  const int extent = 3 + random.index(6);
  const int largest = 2 + random.index(4);
  for (int i = 0; i < count; ++i) {
    const double x = random.index(extent);
    const double y = random.index(extent);
    result.push_back({{x, y}, static_cast<double>(random.index(largest))});
  }
  return result;
}
/// Equal disks at the places of a grid, some left out: four and more circles through one point, with r = 5.
Disks regular_grid(std::uint64_t seed) {
  Random random(seed);
  Disks result;
  const std::array<Point_2, 4> steps{{{6, 8}, {8, 6}, {10, 10}, {5, 5}}};
  const Point_2 step = steps[random.index(4)];
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (random.chance(0.75)) result.push_back({{i * step.x, j * step.y}, 5});
  return result;
}
/// Circles through a few common points, with whole numbers.
Disks through_points(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point_2> points;
  for (int i = 0; i < 1 + random.index(3); ++i) {
    const double x = random.index(10);
    points.push_back({x, static_cast<double>(random.index(10))});
  }
  Disks result;
  const int count = 3 + random.index(8);
  for (int i = 0; i < count; ++i) {
    const Triple& t = triples[random.chance(0.7) ? 0 : random.index(3)];
    const Point_2& p = points[random.index(static_cast<int>(points.size()))];
    const Point_2 v = integer_vector(random, t);
    result.push_back({{p.x + v.x, p.y + v.y}, static_cast<double>(t.c)});
  }
  return result;
}
Disks concentric(std::uint64_t seed) {
  Random random(seed);
  Disks result;
  for (int i = 0; i < 3; ++i) {
    const Disks base = random_disks(random, 1, 3, 0, 3);
    for (int j = 0; j < 3; ++j) result.push_back({base[0].center, random.chance(0.2) ? 1 : random.uniform(0, 3)});
  }
  return result;
}
/// Circles through the same two points, or touching in the same point, besides a few others.
Disks pencil(std::uint64_t seed) {
  Random random(seed);
  constexpr std::array<std::array<double, 2>, 5> through_two{{{0, 12}, {5, 13}, {9, 15}, {16, 20}, {35, 37}}};
  Disks result;
  const bool touches = random.chance(0.4);
  const bool is_upright = random.chance(0.5);
  const int count = 2 + random.index(6);
  for (int i = 0; i < count; ++i) {
    auto [offset, r] = through_two[random.index(5)];
    if (touches) offset = r = random.index(9);
    if (random.chance(0.5)) offset = -offset;
    result.push_back({is_upright ? Point_2{offset, 0} : Point_2{0, offset}, r});
  }
  for (const Disk_2& disk : grid(seed + 1))
    if (random.chance(0.2)) result.push_back(disk);
  return result;
}
Disks ring(std::uint64_t seed) {
  Random random(seed);
  Disks result;
  const int count = 5 + random.index(9);
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    const double r = 10 * std::sin(3.141592653589793 / count) * random.uniform(0.95, 1.6);
    if (random.chance(0.98)) result.push_back({{10 * std::cos(angle), 10 * std::sin(angle)}, r});
  }
  if (random.chance(0.5)) result.push_back({{random.uniform(-3, 3), random.uniform(-3, 3)}, random.uniform(0, 6)});
  return result;
}
Disks with_points(std::uint64_t seed) {
  Random random(seed);
  Disks result = seed % 2 == 0 ? tangent(seed / 2) : grid(seed / 2);
  const int originals = static_cast<int>(result.size());
  for (int i = 0; i < 4; ++i) {
    const Disk_2 other = result[random.index(originals)];
    const Point_2 v = integer_vector(random, triples[0]);
    const double reach = random.chance(0.7) ? other.radius / 5 : 1;
    result.push_back({{other.center.x + reach * v.x, other.center.y + reach * v.y}, 0});
  }
  return result;
}
Disks tiny_in_large(std::uint64_t seed) {
  Random random(seed);
  Disks result = random_disks(random, 3, 3, 2, 4);
  for (const Disk_2& disk : random_disks(random, 9, 5, 1e-6, 0.05)) result.push_back(disk);
  return result;
}
Disks extreme_scale(std::uint64_t seed) {
  const Disks base = seed % 3 == 0 ? grid(seed) : seed % 3 == 1 ? through_points(seed) : dense(seed);
  return scaled(base, seed % 2 == 0 ? 90 : -90);
}
Disks far_away(std::uint64_t seed) {
  const Disks base = seed % 3 == 0 ? grid(seed) : seed % 3 == 1 ? through_points(seed) : tangent(seed);
  return moved(base, 0x1p30, -0x1p31);
}
Disks together(std::uint64_t seed) {
  Random random(seed);
  Disks result = through_points(seed);
  for (const Disk_2& disk : tangent(seed)) result.push_back(disk);
  for (const Disk_2& disk : random_disks(random, 3, 10, 0, 8)) result.push_back(disk);
  return result;
}

/// Special positions missed by the last digit.
Disks nearly_special(std::uint64_t seed) {
  Random random(seed);
  const std::uint64_t base = seed / 4;
  Disks result = seed % 4 == 0   ? through_points(base)
                 : seed % 4 == 1 ? tangent(base)
                 : seed % 4 == 2 ? regular_grid(base)
                                 : pencil(base);
  const auto nudge = [&](double& value) {
    if (value != 0 && random.chance(0.3)) value = std::nextafter(value, random.chance(0.5) ? 1e9 : -1e9);
  };
  for (Disk_2& disk : result) {
    nudge(disk.center.x);
    nudge(disk.center.y);
    if (disk.radius > 0) nudge(disk.radius);
  }
  return result;
}
/// Nearly half-planes around a few small disks.
Disks large_radii(std::uint64_t seed) {
  Random random(seed);
  Disks result = random_disks(random, 6, 10, 0, 4);
  for (int i = 0; i < 4; ++i) {
    const double angle = random.uniform(0, 6.3);
    const double r = std::pow(10.0, random.uniform(2, 7));
    const double away = r + random.uniform(5, 15);
    result.push_back({{away * std::cos(angle), away * std::sin(angle)}, r});
  }
  return result;
}
/// More disks than in the other families.
Disks many(std::uint64_t seed) {
  Random random(seed);
  Disks result = random_disks(random, 15, 6, 0, 3);
  for (int i = 0; i < 15; ++i) {
    const double x = random.index(13) - 6;
    const double y = random.index(13) - 6;
    result.push_back({{x, y}, static_cast<double>(random.index(4))});
  }
  return result;
}

Circumscribed_balls_2 some_triangles(std::span<const Point_2> samples, double share, std::uint64_t seed) {
  Random random(seed);
  Progress progress;
  const Delaunay_2 d = delaunay(samples, progress);
  const Voronoi_2 v = voronoi(d, progress);
  std::vector<std::uint8_t> is_chosen(d.triangles.size());
  for (auto& chosen : is_chosen) chosen = random.chance(share) ? 1 : 0;
  return circumscribed_balls(d, v, is_chosen, progress);
}

std::vector<Point_2> rectangle(int columns, int rows) {
  std::vector<Point_2> result;
  for (const Point_2& p : grid_points(columns, rows))
    if (p.x == 0 || p.y == 0 || p.x == columns - 1 || p.y == rows - 1) result.push_back(p);
  return result;
}

Sampled_shape sampled(std::span<const Point_2> samples, const Outline_2* outline) {
  Progress progress;
  Delaunay_2 d = delaunay(samples, progress);
  Voronoi_2 v = voronoi(d, progress);
  const Crust_2 crust = one_step_crust(d, progress);
  Labels_2 labels = outline ? outline_labels(d, v, crust, *outline, progress) : flood_labels(d, crust, progress);
  Circumscribed_balls_2 balls = circumscribed_balls(d, v, labels.is_inner, progress);
  return {std::move(d), std::move(v), std::move(labels.is_inner), std::move(balls)};
}

}  // namespace

namespace {

testing::AssertionResult checked(const Balls_check& check, const std::shared_ptr<const Balls_2>& balls) {
  try {
    return check(balls);
  } catch (const std::exception& exception) {
    return testing::AssertionFailure() << exception.what();
  }
}

/// Leaves out disks as long as the rest fails too.
std::shared_ptr<const Balls_2> shrunk(std::shared_ptr<const Balls_2> balls, const Balls_check& check) {
  for (int left_out = 0; left_out < static_cast<int>(balls->size());) {
    std::vector<int> kept;
    for (int i = 0; i < static_cast<int>(balls->size()); ++i)
      if (i != left_out) kept.push_back(i);
    auto rest = std::make_shared<const Balls_2>(subset(*balls, kept));
    if (checked(check, rest)) {
      ++left_out;
    } else {
      balls = std::move(rest);
      left_out = 0;
    }
  }
  return balls;
}

void expect_of_family(const std::string& name, std::uint64_t seeds, const std::function<Balls_2(std::uint64_t)>& make,
                      const Balls_check& check) {
  std::uint64_t failures = 0;
  std::uint64_t seed_of_smallest = 0;
  std::shared_ptr<const Balls_2> smallest;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const auto balls = std::make_shared<const Balls_2>(make(seed));
    if (checked(check, balls)) continue;
    ++failures;
    if (smallest && smallest->size() <= balls->size()) continue;
    smallest = balls;
    seed_of_smallest = seed;
  }
  if (failures == 0) return;
  smallest = shrunk(smallest, check);
  ADD_FAILURE() << failures << " of " << seeds << " sets '" << name << "', for example a part of seed "
                << seed_of_smallest << ": " << checked(check, smallest).message() << "\n  " << to_text(*smallest);
}

}  // namespace

void expect_of_given_balls(std::uint64_t seeds, const Balls_check& check) {
  for (const Named_disks& set : difficult_disk_sets())
    expect_of_family(
        set.name, 1, [&](std::uint64_t) { return given_balls(set.disks); }, check);
  for (const Disk_family& family : disk_families())
    expect_of_family(
        family.name, seeds, [&](std::uint64_t seed) { return given_balls(family.make(seed)); }, check);
}

void expect_of_circumscribed_balls(std::uint64_t seeds, const Balls_check& check) {
  for (const Sampled_family& family : sampled_families())
    expect_of_family(
        family.name, seeds, [&](std::uint64_t seed) { return family.make(seed).balls; }, check);
}

std::vector<Disk_2> scaled(std::vector<Disk_2> disks, int exponent) {
  for (Disk_2& d : disks)
    d = {{std::ldexp(d.center.x, exponent), std::ldexp(d.center.y, exponent)}, std::ldexp(d.radius, exponent)};
  return disks;
}

std::vector<Disk_2> moved(std::vector<Disk_2> disks, double x, double y) {
  for (Disk_2& d : disks) d.center = {d.center.x + x, d.center.y + y};
  return disks;
}

std::vector<Named_disks> difficult_disk_sets() {
  std::vector<Named_disks> result{
      {"none", {}},
      {"one", {{{3, -1}, 2}}},
      {"one point", {{{3, -1}, 0}}},
      {"two apart", {{{0, 0}, 1}, {{5, 0}, 2}}},
      {"two touching", {{{0, 0}, 1}, {{3, 0}, 2}}},
      {"two touching in decimals", {{{0, 0}, 0.1}, {{0.3, 0}, 0.2}}},
      {"two crossing", {{{0, 0}, 2}, {{3, 0}, 2}}},
      {"two crossing, one center in the other disk", {{{0, 0}, 5}, {{1, 0}, 4.5}}},
      {"two touching from inside", {{{0, 0}, 5}, {{3, 0}, 2}}},
      {"two nested", {{{0, 0}, 5}, {{1, 0}, 2}}},
      {"two concentric", {{{0, 0}, 5}, {{0, 0}, 2}}},
      {"two equal", {{{1, 1}, 2}, {{1, 1}, 2}}},
      {"two equal points", {{{1, 1}, 0}, {{1, 1}, 0}}},
      {"point on a circle", {{{0, 0}, 5}, {{3, 4}, 0}}},
      {"point in a disk", {{{0, 0}, 5}, {{1, 1}, 0}}},
      {"point where two circles cross", {{{-3, 0}, 5}, {{3, 0}, 5}, {{0, 4}, 0}}},
      {"pencil through two points", {{{-3, 0}, 5}, {{0, 0}, 4}, {{3, 0}, 5}}},
      {"pencil through two points, four", {{{-5, 0}, 13}, {{0, 0}, 12}, {{5, 0}, 13}, {{9, 0}, 15}}},
      {"pencil touching in one point", {{{1, 0}, 1}, {{2, 0}, 2}, {{3, 0}, 3}, {{-1, 0}, 1}}},
      {"three through a point, which they surround", {{{5, 0}, 5}, {{-3, 4}, 5}, {{-3, -4}, 5}}},
      {"three through a point, on one side", {{{5, 0}, 5}, {{3, 4}, 5}, {{3, -4}, 5}}},
      {"three through a point, two of them touching", {{{5, 0}, 5}, {{-5, 0}, 5}, {{0, 5}, 5}}},
      {"four through a point", {{{5, 0}, 5}, {{-5, 0}, 5}, {{0, 5}, 5}, {{0, -5}, 5}}},
      {"four through a point, pinched", {{{3, 4}, 5}, {{4, 3}, 5}, {{-3, -4}, 5}, {{-4, -3}, 5}}},
      {"three around a hole", {{{0, 0}, 5.5}, {{10, 0}, 5.5}, {{5, 8}, 5}}},
      {"four around a hole, touching", {{{0, 0}, 5}, {{10, 0}, 5}, {{10, 10}, 5}, {{0, 10}, 5}}},
      {"four around a hole with a disk in it", {{{0, 0}, 5}, {{10, 0}, 5}, {{10, 10}, 5}, {{0, 10}, 5}, {{5, 5}, 1}}},
      {"hidden in the middle", {{{-4, 0}, 5}, {{4, 0}, 5}, {{0, 0}, 1}}},
      {"hidden off the line of the others", {{{-4, 0}, 5}, {{4, 0}, 5}, {{0, 0.5}, 1}, {{0, 9}, 4}}},
      {"points on a line", {{{0, 0}, 0}, {{1, 0}, 0}, {{2, 0}, 0}}},
      {"chain of touching disks", {{{0, 0}, 1}, {{2, 0}, 1}, {{4, 0}, 1}, {{6, 0}, 1}}},
      {"triangle and a singular edge", {{{0, 0}, 5}, {{6, 0}, 5}, {{3, 4}, 5}, {{3, 13}, 5}}},
      {"two parts touching in a point", {{{-3, 4}, 5}, {{-4, 3}, 5}, {{4, -3}, 5}, {{3, -4}, 5}, {{-8, 0}, 3}}},
      {"center on the far side of the power line", {{{0, 0}, 10}, {{9, 0}, 2}, {{9.5, 1}, 1}}},
  };
  Disks ring_with_hole;
  for (int i = 0; i < 12; ++i) {
    const double angle = 6.283185307179586 * i / 12;
    ring_with_hole.push_back({{10 * std::cos(angle), 10 * std::sin(angle)}, 3});
  }
  result.push_back({"ring with a hole", ring_with_hole});
  ring_with_hole.push_back({{1, 2}, 1.5});
  result.push_back({"ring with an island in its hole", ring_with_hole});
  Disks full_grid;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) full_grid.push_back({{6.0 * i, 8.0 * j}, 5});
  result.push_back({"grid, four circles through each inner point", full_grid});
  return result;
}

std::vector<Disk_family> disk_families() {
  return {
      {"sparse", sparse},
      {"dense", dense},
      {"nested", nested},
      {"tangent", tangent},
      {"decimal", decimal},
      {"equal radii", equal_radii},
      {"duplicates", duplicates},
      {"collinear", collinear},
      {"grid", grid},
      {"regular grid", regular_grid},
      {"through points", through_points},
      {"concentric", concentric},
      {"pencil", pencil},
      {"ring", ring},
      {"with points", with_points},
      {"tiny in large", tiny_in_large},
      {"extreme scale", extreme_scale},
      {"far away", far_away},
      {"together", together},
      {"many", many},
      {"nearly special", nearly_special},
      {"large radii", large_radii},
  };
}

std::vector<Sampled_family> sampled_families() {
  const auto inner = [](const std::vector<Point_2>& points) { return inner_voronoi_disks(points).circumscribed; };
  return {
      {"ellipse", [=](std::uint64_t seed) { return inner(ellipse(2, 1, 14 + static_cast<int>(seed % 9), 0.6, seed)); }},
      {"flower", [=](std::uint64_t seed) { return inner(flower(25, 0.3, 3, 0.6, seed)); }},
      {"rectangle",
       [=](std::uint64_t seed) {
         return inner(rectangle(3 + static_cast<int>(seed % 6), 3 + static_cast<int>(seed / 6 % 4)));
       }},
      {"circle", [=](std::uint64_t seed) { return inner(ellipse(1, 1, 5 + static_cast<int>(seed % 17))); }},
      {"ring",
       [=](std::uint64_t seed) {
         std::vector<Point_2> points = ellipse(1, 1, 16, 0.2, seed);
         for (const Point_2& p : ellipse(0.5, 0.5, 12, 0.2, seed + 1)) points.push_back(p);
         return inner(points);
       }},
      {"letter L with even samples",
       [=](std::uint64_t seed) {
         std::vector<Point_2> points;
         const int width = 2 + static_cast<int>(seed % 3);
         const int length = width + 2 + static_cast<int>(seed / 3 % 2);
         for (const Point_2& p : grid_points(length + 1, length + 1)) {
           const bool is_on_outside = p.x == 0 || p.y == 0;
           const bool is_at_end = (p.x == length && p.y <= width) || (p.y == length && p.x <= width);
           const bool is_on_inside = (p.x == width && p.y >= width) || (p.y == width && p.x >= width);
           if (is_on_outside || is_at_end || is_on_inside) points.push_back(p);
         }
         return inner(points);
       }},
      {"noise", [=](std::uint64_t seed) { return inner(noisy_curve(18, 0.2, seed)); }},
      {"cocircular",
       [=](std::uint64_t seed) {
         std::vector<Point_2> points = shuffled(cocircular_points(), seed);
         points.resize(3 + seed % 20);
         points.push_back({static_cast<double>(1 + seed), 5});
         return some_triangles(points, 0.7, seed);
       }},
      {"some triangles of random points",
       [](std::uint64_t seed) { return some_triangles(uniform_points(14, seed, 10), 0.2 + 0.1 * (seed % 8), seed); }},
      {"some triangles of a grid",
       [](std::uint64_t seed) { return some_triangles(grid_points(5, 4), 0.2 + 0.1 * (seed % 8), seed); }},
      {"some triangles of grid points",
       [](std::uint64_t seed) {
         std::vector<Point_2> points = shuffled(grid_points(6, 6), seed);
         points.resize(14);
         return some_triangles(points, 0.2 + 0.1 * (seed % 8), seed);
       }},
  };
}

Sampled_shape inner_voronoi_disks(std::span<const Point_2> samples) { return sampled(samples, nullptr); }
Sampled_shape inner_voronoi_disks(std::span<const Point_2> samples, const Outline_2& outline) {
  return sampled(samples, &outline);
}

}  // namespace mesecina::test
