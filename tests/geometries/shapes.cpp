// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "core/formats/format.h"

namespace mesecina::test {

namespace {
constexpr double pi = std::numbers::pi;

Point_2 flower_point(double t, double depth, int petals) {
  const double r = 1 + depth * std::cos(petals * t);
  return {r * std::cos(t), r * std::sin(t)};
}

/// count parameters in [0, 2 pi), each moved by up to `jitter` of their distance.
std::vector<double> parameters(int count, double jitter, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> result;
  for (int i = 0; i < count; ++i)
    result.push_back(2 * pi * (i + (jitter > 0 ? jitter * random.uniform(-0.5, 0.5) : 0)) / count);
  return result;
}
}  // namespace

std::uint64_t Random::next() {
  state_ += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

double Random::unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

std::vector<Point_2> uniform_points(int count, std::uint64_t seed, double scale) {
  Random random(seed);
  std::vector<Point_2> result;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-scale, scale);
    result.push_back({x, random.uniform(-scale, scale)});
  }
  return result;
}

std::vector<Point_2> cocircular_points() {
  constexpr std::int64_t radius = 5 * 13 * 17 * 29;
  std::vector<Point_2> result;
  for (std::int64_t x = -radius; x <= radius; ++x) {
    const auto y = static_cast<std::int64_t>(std::llround(std::sqrt(static_cast<double>(radius * radius - x * x))));
    if (x * x + y * y != radius * radius) continue;
    result.push_back({static_cast<double>(x), static_cast<double>(y)});
    if (y != 0) result.push_back({static_cast<double>(x), static_cast<double>(-y)});
  }
  return result;
}

std::vector<Point_2> grid_points(int columns, int rows) {
  std::vector<Point_2> result;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      result.push_back({static_cast<double>(column), static_cast<double>(row)});
  return result;
}

std::vector<Point_2> rectangle_samples(const Point_2& corner, double step) {
  const std::array<Point_2, 4> corners{Point_2{0, 0}, Point_2{corner.x, 0}, corner, Point_2{0, corner.y}};
  std::vector<Point_2> points;
  for (int side = 0; side < 4; ++side) {
    const Point_2& from = corners[side];
    const Point_2& to = corners[(side + 1) % 4];
    const int count = static_cast<int>(std::lround(distance(from, to) / step));
    for (int i = 0; i < count; ++i)
      points.push_back({from.x + (to.x - from.x) * i / count, from.y + (to.y - from.y) * i / count});
  }
  return points;
}

std::vector<Point_2> collinear_points(int count, std::uint64_t seed) {
  std::vector<Point_2> result;
  for (int i = 0; i < count; ++i) result.push_back({7 + 3.0 * i, -2 + 5.0 * i});
  return shuffled(std::move(result), seed);
}

std::vector<Point_2> clustered_points(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point_2> result;
  for (int i = 0; i < count; ++i) {
    const int cluster = random.index(5);
    const double spread = std::pow(10.0, -2 * cluster);
    const double x = 3.0 * cluster + spread * random.uniform(-1, 1);
    result.push_back({x, (cluster % 2) + spread * random.uniform(-1, 1)});
  }
  return result;
}

std::vector<Point_2> scaled(std::vector<Point_2> points, int exponent) {
  for (Point_2& p : points) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  return points;
}

std::vector<Point_2> with_duplicates(std::vector<Point_2> points, int count, std::uint64_t seed) {
  Random random(seed);
  const int originals = static_cast<int>(points.size());
  for (int i = 0; i < count; ++i) {
    const Point_2 copy = points[random.index(originals)];
    points.insert(points.begin() + random.index(static_cast<int>(points.size()) + 1), copy);
  }
  return points;
}

std::vector<int> random_permutation(int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<int> result(count);
  std::iota(result.begin(), result.end(), 0);
  for (int i = count - 1; i > 0; --i) std::swap(result[i], result[random.index(i + 1)]);
  return result;
}

std::vector<Point_2> shuffled(std::vector<Point_2> points, std::uint64_t seed) {
  std::vector<Point_2> result;
  for (const int i : random_permutation(static_cast<int>(points.size()), seed)) result.push_back(points[i]);
  return result;
}

std::vector<Named_points> difficult_point_sets() {
  const std::vector<Point_2> circle = shuffled(cocircular_points(), 3);
  std::vector<Point_2> circle_with_center = circle;
  circle_with_center.push_back({0, 0});
  std::vector<Point_2> line_and_one = collinear_points(40, 5);
  line_and_one.insert(line_and_one.begin() + 20, Point_2{1, 1});
  std::vector<Point_2> nearly_collinear;
  for (int i = 0; i < 100; ++i) nearly_collinear.push_back({0.1 * i, 0.1 * i + (i == 57 ? 1e-15 : 0)});
  std::vector<Point_2> far_from_origin;
  for (const Point_2& p : uniform_points(150, 21)) far_from_origin.push_back({p.x + 1e9, p.y - 1e9});
  std::vector<Point_2> mixed_scales;
  for (int i = -60; i < 60; ++i)
    mixed_scales.push_back({std::ldexp(1.0, 5 * i), std::ldexp(1.0 + 0.1 * (i % 3), 5 * i)});
  return {
      {"none", {}},
      {"one", {{3, 4}}},
      {"two", {{3, 4}, {-1, 2}}},
      {"three", {{0, 0}, {4, 1}, {1, 3}}},
      {"three on a line", {{0, 0}, {4, 4}, {1, 1}}},
      {"four", {{0, 0}, {4, 1}, {1, 3}, {5, 5}}},
      {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}},
      {"triangle and a point on its side", {{0, 0}, {4, 0}, {0, 4}, {2, 2}}},
      {"two equal", {{1, 2}, {1, 2}}},
      {"all equal", std::vector<Point_2>(50, Point_2{0.1, -7})},
      {"zeros of both signs", {{0.0, -0.0}, {-0.0, 0.0}, {1, 0}, {0, 1}}},
      {"collinear", collinear_points(200, 1)},
      {"collinear with duplicates", with_duplicates(collinear_points(60, 2), 90, 7)},
      {"horizontal", {{3, 1}, {-2, 1}, {8, 1}, {0, 1}}},
      {"vertical", {{1, 3}, {1, -2}, {1, 8}, {1, 0}}},
      {"nearly collinear", nearly_collinear},
      {"line and one point", line_and_one},
      {"cocircular", circle},
      {"cocircular with center", circle_with_center},
      {"cocircular with duplicates", with_duplicates(circle, 40, 8)},
      {"grid", shuffled(grid_points(15, 12), 4)},
      {"grid in order", grid_points(16, 16)},
      {"grid with duplicates", with_duplicates(grid_points(12, 10), 100, 9)},
      {"clusters", clustered_points(300, 11)},
      {"far from the origin", far_from_origin},
      {"mixed scales", mixed_scales},
      {"tiny", scaled(uniform_points(120, 13), -100)},
      {"very tiny", scaled(uniform_points(120, 14), -490)},
      {"huge", scaled(uniform_points(120, 15), 100)},
      {"very huge", scaled(uniform_points(120, 16), 490)},
      {"tiny grid", scaled(grid_points(9, 9), -490)},
      {"huge grid", scaled(grid_points(9, 9), 490)},
      {"random with duplicates", with_duplicates(uniform_points(150, 17), 100, 18)},
  };
}

std::vector<Named_points> general_point_sets() {
  return {
      {"random 10", uniform_points(10, 31)},       {"random 100", uniform_points(100, 32)},
      {"random 300", uniform_points(300, 33)},     {"random 1000", uniform_points(1000, 34)},
      {"clusters 500", clustered_points(500, 35)}, {"noisy curve 400", noisy_curve(400, 0.02, 36)},
  };
}

Closed_curve ellipse(double a, double b, int count, double jitter, std::uint64_t seed) {
  Closed_curve result;
  for (const double t : parameters(count, jitter, seed)) result.push_back({a * std::cos(t), b * std::sin(t)});
  return result;
}

Closed_curve superellipse(int count) {
  // By the angle from the origin: the usual parametrisation leaves the four flat sides bare.
  Closed_curve result;
  for (const double t : parameters(count, 0, 1)) {
    const double r = std::pow(std::pow(std::cos(t), 4) + std::pow(std::sin(t), 4), -0.25);
    result.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return result;
}

Closed_curve flower(int count, double depth, int petals, double jitter, std::uint64_t seed) {
  Closed_curve result;
  for (const double t : parameters(count, jitter, seed)) result.push_back(flower_point(t, depth, petals));
  return result;
}

std::vector<Point_2> Smooth_shape::samples() const {
  std::vector<Point_2> result;
  for (const Closed_curve& curve : curves) result.insert(result.end(), curve.begin(), curve.end());
  return result;
}

std::vector<std::array<int, 2>> Smooth_shape::polygon_edges() const {
  std::vector<std::array<int, 2>> result;
  int first = 0;
  for (const Closed_curve& curve : curves) {
    const int count = static_cast<int>(curve.size());
    for (int i = 0; i < count; ++i) {
      const int p = first + i;
      const int q = first + (i + 1) % count;
      result.push_back({std::min(p, q), std::max(p, q)});
    }
    first += count;
  }
  std::ranges::sort(result);
  return result;
}

std::vector<Smooth_shape> smooth_shapes() {
  const auto in_disk = [](const Point_2& p, double x, double radius) { return std::hypot(p.x - x, p.y) < radius; };
  const auto circle = [](double x, double radius, int count, double jitter) {
    Closed_curve curve = ellipse(radius, radius, count, jitter, 77);
    for (Point_2& p : curve) p.x += x;
    return curve;
  };
  const auto in_flower = [](const Point_2& p) {
    return std::hypot(p.x, p.y) < 1 + 0.3 * std::cos(5 * std::atan2(p.y, p.x));
  };
  std::vector<Point_2> integer_circle = cocircular_points();
  std::ranges::sort(integer_circle, {}, [](const Point_2& p) { return std::atan2(p.y, p.x); });
  return {
      {"circle", {circle(0, 1, 60, 0)}, [=](const Point_2& p) { return in_disk(p, 0, 1); }},
      {"circle of exactly cocircular points",
       {integer_circle},
       [](const Point_2& p) { return std::hypot(p.x, p.y) < 5 * 13 * 17 * 29; }},
      {"ellipse", {ellipse(2, 1, 240)}, [](const Point_2& p) { return p.x * p.x / 4 + p.y * p.y < 1; }},
      {"jittered ellipse", {ellipse(2, 1, 400, 0.8)}, [](const Point_2& p) { return p.x * p.x / 4 + p.y * p.y < 1; }},
      {"superellipse", {superellipse(400)}, [](const Point_2& p) { return std::pow(p.x, 4) + std::pow(p.y, 4) < 1; }},
      {"flower", {flower(1200)}, in_flower},
      {"jittered flower", {flower(2500, 0.3, 5, 0.8)}, in_flower},
      {"two disjoint circles",
       {circle(0, 1, 80, 0.5), circle(2.5, 1, 90, 0.5)},
       [=](const Point_2& p) { return in_disk(p, 0, 1) || in_disk(p, 2.5, 1); }},
      {"annulus",
       {circle(0, 1, 150, 0.5), circle(0.1, 0.6, 120, 0.5)},
       [=](const Point_2& p) { return in_disk(p, 0, 1) && !in_disk(p, 0.1, 0.6); }},
  };
}

std::vector<Point_2> spiral_arc(int count) {
  std::vector<Point_2> result;
  for (int i = 0; i < count; ++i) {
    const double t = 3.0 * i / count;
    result.push_back({(1 + 0.2 * t) * std::cos(t), (1 + 0.2 * t) * std::sin(t)});
  }
  return result;
}

std::vector<Point_2> noisy_curve(int count, double noise, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point_2> result = flower(count);
  for (Point_2& p : result) {
    p.x += random.uniform(-noise, noise);
    p.y += random.uniform(-noise, noise);
  }
  return result;
}

std::optional<std::filesystem::path> data_folder() {
  const char* folder = std::getenv("MESECINA_DATA");
  if (!folder || !*folder) return std::nullopt;
  return std::filesystem::path(folder);
}

std::vector<std::filesystem::path> planar_files(const std::string& extension) {
  std::vector<std::filesystem::path> result;
  if (const auto folder = data_folder()) {
    for (const auto& entry : std::filesystem::directory_iterator(*folder / "2d"))
      if (entry.path().extension() == "." + extension) result.push_back(entry.path());
  }
  std::ranges::sort(result);
  return result;
}

std::vector<Point_2> points_of(const std::filesystem::path& file) {
  const auto points = read_file(planar_formats(), file).inputs.get(points_input);
  return points ? *points : std::vector<Point_2>{};
}

Outline_2 outline_of(const std::filesystem::path& file) {
  const auto outline = read_file(planar_formats(), file).inputs.get(outline_input);
  return outline ? *outline : Outline_2{};
}

std::vector<Point_2> vertices_of(const Outline_2& outline) {
  std::vector<Point_2> result;
  for (const Ring_2& ring : outline.rings) result.insert(result.end(), ring.begin(), ring.end());
  return result;
}

}  // namespace mesecina::test
