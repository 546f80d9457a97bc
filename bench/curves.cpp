// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/curves.h"

#include <cmath>
#include <numbers>
#include <random>

namespace mesecina {

std::vector<Point_2> smooth_curve(std::size_t count) {
  std::vector<Point_2> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * (static_cast<double>(i) + 0.3) / static_cast<double>(count);
    const double r = 1 + 0.3 * std::cos(5 * t) + 0.1 * std::sin(3 * t);
    points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return points;
}

std::vector<Point_2> rippled_curve(std::size_t count) {
  std::vector<Point_2> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * (static_cast<double>(i) + 0.3) / static_cast<double>(count);
    const double r = 1 + 0.3 * std::cos(5 * t) + 0.1 * std::sin(3 * t) + 0.02 * std::sin(211 * t);
    points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return points;
}

Outline_2 noisy_star(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> noise(-0.01, 0.01);
  Ring_2 ring;
  ring.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const double r = 1 + 0.4 * std::cos(5 * t) + 0.05 * std::sin(23 * t) + noise(random);
    ring.push_back({1000 * r * std::cos(t), 1000 * r * std::sin(t)});
  }
  return {{std::move(ring)}};
}

}  // namespace mesecina
