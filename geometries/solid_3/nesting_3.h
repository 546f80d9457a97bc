// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"
#include "geometries/solid_3/surface_locator_3.h"

namespace mesecina {

/// How closed oriented surfaces that do not cross lie in each other.
struct Nesting_3 {
  std::vector<std::uint8_t> is_inward;  ///< per component: its normals point to the side that it encloses
  std::vector<int> depth;               ///< per component: how many others are around it
};

/// `component` says for each triangle of the surface to which of `count` components it belongs. Exact. One ray per
/// component.
Nesting_3 find_nesting(const Surface_locator_3& locator, const std::vector<int>& component, int count,
                       Progress& progress);

}  // namespace mesecina
