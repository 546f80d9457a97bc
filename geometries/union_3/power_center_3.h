// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// The point with the same power to all four balls of a finite cell, each coordinate to about `error`: by intervals or,
/// where these are wider, by rationals. Safe to call from several threads. O(1), slow where cells are nearly flat.
Point_3 power_center(const Regular_3& regular, int cell, double error);

}  // namespace mesecina
