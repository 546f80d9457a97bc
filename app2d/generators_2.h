// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// What a generator may use. The same values give the same points on every machine.
struct Generator_order_2 {
  std::size_t count = 100;
  std::uint64_t seed = 1;
  double amount = 0.01;  ///< of noise, as a fraction of the diagonal; for those that have it
  Box box;               ///< where the points should lie; not empty
  Inputs inputs;         ///< what there is already
};

/// Makes points from nothing or from what there is.
struct Generator_2 {
  std::string id;
  const char* label;  ///< English, as marked for translation
  const char* tip;
  bool has_count = true;
  bool has_seed = false;
  bool has_amount = false;
  /// No points where there is nothing to start from.
  std::vector<Point_2> (*make)(const Generator_order_2& order);
};

const std::vector<Generator_2>& generators_2();

/// A closed wiggly curve of `count` points in about [-1, 1]², scaled by `size`: what a first start shows.
std::vector<Point_2> wiggly_curve(std::size_t count, double size);

}  // namespace mesecina
