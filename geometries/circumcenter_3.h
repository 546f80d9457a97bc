// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/point.h"

namespace mesecina {

/// Where four points that lie in no plane have the same distance, rounded: also of tetrahedra so flat that a formula in
/// doubles would give noise.
Point_3 circumcenter(const std::array<Point_3, 4>& points);

}  // namespace mesecina
