// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// What a generator may use. The same values give the same data on every machine.
struct Generator_order_3 {
  std::size_t count = 100;  ///< of points or balls; of a mesh, segments around it
  std::uint64_t seed = 1;
  double least_radius = 0.1;  ///< of random balls
  double greatest_radius = 0.3;
  Point_3 center;   ///< of what is made
  double size = 1;  ///< what is made lies within this distance of the center along each axis, of balls the centers;
                    ///< lattices nearly so
};

/// What a generator makes.
enum class Product_3 { points, balls, mesh };

/// Makes points, balls or a mesh from nothing.
struct Generator_3 {
  std::string id;
  const char* label;  ///< English, as marked for translation
  const char* tip;
  Product_3 product = Product_3::points;
  std::size_t usual_count = 500;  ///< 0: it has no count
  bool has_seed = false;
  bool has_radii = false;
  Inputs (*make)(const Generator_order_3& order) = nullptr;
};

/// Never changes; the ids are those of the actions of the window after "insert-".
const std::vector<Generator_3>& generators_3();

}  // namespace mesecina
