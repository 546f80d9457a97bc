// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// What a generator may use. The same values give the same points and disks on every machine.
struct Generator_order_2 {
  std::size_t count = 100;
  std::uint64_t seed = 1;
  double amount = 0.01;     ///< of noise, as a fraction of the diagonal; for those that have it
  double least_radius = 2;  ///< of random disks
  double greatest_radius = 8;
  double relative_radius = 0.5;  ///< of regular disks, in distances of neighbours: at 0.5 they touch
  Box box;                       ///< where the points or centers should lie; not empty
  Inputs inputs;                 ///< what there is already
};

enum class Radii_2 { none, between, relative };

/// Makes points or disks from nothing or from what there is.
struct Generator_2 {
  std::string id;
  const char* label;  ///< English, as marked for translation
  const char* tip;
  bool has_count = true;
  bool has_seed = false;
  bool has_amount = false;
  /// No points where there is nothing to start from; null for a generator of disks.
  std::vector<Point_2> (*make)(const Generator_order_2& order) = nullptr;
  std::vector<Disk_2> (*make_disks)(const Generator_order_2& order) = nullptr;  ///< null for a generator of points
  Radii_2 radii = Radii_2::none;
  std::size_t usual_count = 100;
};

/// What the generator makes, without what there was.
Inputs generated(const Generator_2& generator, const Generator_order_2& order);

const std::vector<Generator_2>& generators_2();

/// A closed wiggly curve of `count` points in about [-1, 1]², scaled by `size`: what a first start shows.
std::vector<Point_2> wiggly_curve(std::size_t count, double size);

}  // namespace mesecina
