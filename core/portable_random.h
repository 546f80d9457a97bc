// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "core/point.h"

namespace mesecina {

/// The same numbers on every machine for the same seed; std's distributions differ between libraries.
class Portable_random {
 public:
  explicit Portable_random(std::uint64_t seed) : engine_(seed) {}
  /// In [0, 1), evenly.
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Evenly between them.
  double within(double lower, double upper) { return lower + (upper - lower) * unit(); }
  /// Two numbers of the normal distribution, independent of each other.
  Point_2 normal_pair() {
    const double radius = std::sqrt(-2 * std::log(1 - unit()));
    const double angle = 2 * std::numbers::pi * unit();
    return {radius * std::cos(angle), radius * std::sin(angle)};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace mesecina
