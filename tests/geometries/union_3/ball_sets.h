// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/inputs.h"
#include "tests/geometries/results.h"

namespace mesecina::test {

struct Named_balls {
  std::string name;
  std::vector<Ball_3> balls;
  std::array<std::int64_t, 3> betti{};  ///< of the union
};

/// One of each special position, of at most about 20 balls each, with what is known of the union.
std::vector<Named_balls> difficult_ball_sets();

/// A way to make sets of balls from a seed.
struct Ball_family {
  std::string name;
  std::function<std::vector<Ball_3>(std::uint64_t seed)> make;
  bool is_nearly_special = false;  ///< what touches or meets on paper does so only to rounding
};
/// Sets of 1 to 12 balls, most families in special position again and again.
std::vector<Ball_family> ball_families();

using Balls_check = std::function<testing::AssertionResult(const std::vector<Ball_3>& balls)>;
/// Expects it of the difficult sets and of so many sets of each family; of each family that fails it tells the least
/// part of a set that does.
void expect_of_balls(std::uint64_t seeds, const Balls_check& check);
/// Not of families that are nearly special.
void expect_of_clear_balls(std::uint64_t seeds, const Balls_check& check);

/// Many balls in a cube, of which each meets so many others, about.
std::vector<Ball_3> many_balls(int count, double neighbors, std::uint64_t seed);

/// A solid bounded by a smooth surface.
struct Smooth_solid {
  std::string name;
  std::function<Point_3(double u, double v)> surface;  ///< u and v in [0, 1)
  std::function<bool(const Point_3&)> is_inside;
  std::array<std::int64_t, 3> betti{};
};
/// Sphere, ellipsoid, torus, and what lies between two spheres.
std::vector<Smooth_solid> smooth_solids();
/// The balls through four samples of the surface, without samples inside, that have their center in the solid; the
/// center moved by up to `perturbation` times the radius. Without it, many spheres go nearly through each sample.
std::vector<Ball_3> inner_voronoi_balls(const Smooth_solid& solid, int samples, double perturbation,
                                        std::uint64_t seed);

/// As source text, for messages.
std::string to_text(const std::vector<Ball_3>& balls);

}  // namespace mesecina::test
