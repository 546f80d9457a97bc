// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/inputs.h"
#include "core/point.h"

namespace mesecina::test {

struct Named_points {
  std::string name;
  std::vector<Point_2> points;
};

/// Reproducible on every machine: the standard's distributions are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// In [0, 1).
  double unit();
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  /// In [0, count).
  int index(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
  bool chance(double probability) { return unit() < probability; }

 private:
  std::uint64_t state_;
};

std::vector<Point_2> uniform_points(int count, std::uint64_t seed, double scale = 1);
/// Integer points exactly on x^2 + y^2 = (5 * 13 * 17 * 29)^2, every one of them.
std::vector<Point_2> cocircular_points();
std::vector<Point_2> grid_points(int columns, int rows);
/// On the sides of the rectangle from the origin to `corner`, in order: each side in equal steps of about `step`.
std::vector<Point_2> rectangle_samples(const Point_2& corner, double step);
/// On a line through integer points, in random order.
std::vector<Point_2> collinear_points(int count, std::uint64_t seed);
std::vector<Point_2> clustered_points(int count, std::uint64_t seed);
/// Times an exact power of two.
std::vector<Point_2> scaled(std::vector<Point_2> points, int exponent);
std::vector<Point_2> with_duplicates(std::vector<Point_2> points, int count, std::uint64_t seed);
std::vector<Point_2> shuffled(std::vector<Point_2> points, std::uint64_t seed);
std::vector<int> random_permutation(int count, std::uint64_t seed);

/// Every kind of degenerate or extreme point set, of at most about 300 points each.
std::vector<Named_points> difficult_point_sets();
/// Point sets without four cocircular or three collinear points: their Delaunay triangulation is unique.
std::vector<Named_points> general_point_sets();

/// One closed curve, as its samples in order.
using Closed_curve = std::vector<Point_2>;
Closed_curve ellipse(double a, double b, int count, double jitter = 0, std::uint64_t seed = 1);
/// |x|^4 + |y|^4 = 1.
Closed_curve superellipse(int count);
/// r = 1 + depth cos(petals t).
Closed_curve flower(int count, double depth = 0.3, int petals = 5, double jitter = 0, std::uint64_t seed = 1);

/// A shape bounded by smooth curves, sampled densely enough for every reconstruction guarantee.
struct Smooth_shape {
  std::string name;
  std::vector<Closed_curve> curves;
  std::function<bool(const Point_2&)> is_inside;

  std::vector<Point_2> samples() const;
  /// Pairs of consecutive samples, the lesser index first, sorted.
  std::vector<std::array<int, 2>> polygon_edges() const;
  Outline_2 outline() const { return {{curves.begin(), curves.end()}}; }
};
std::vector<Smooth_shape> smooth_shapes();

std::vector<Point_2> spiral_arc(int count);
std::vector<Point_2> noisy_curve(int count, double noise, std::uint64_t seed);

/// The folder of real shapes; nullopt when MESECINA_DATA is not set.
std::optional<std::filesystem::path> data_folder();
/// Files of data_folder()/2d with this extension, sorted; none without the folder.
std::vector<std::filesystem::path> planar_files(const std::string& extension);
std::vector<Point_2> points_of(const std::filesystem::path& file);
Outline_2 outline_of(const std::filesystem::path& file);
/// The rings' vertices, one after the other.
std::vector<Point_2> vertices_of(const Outline_2& outline);

}  // namespace mesecina::test

#define MESECINA_NEED_DATA()                                                 \
  if (!mesecina::test::data_folder()) {                                      \
    GTEST_SKIP() << "MESECINA_DATA does not name the folder of real shapes"; \
  }
