// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/point.h"
#include "core/progress.h"

namespace mesecina {

/// Per disk B the factor at which a single larger disk covers it when all grow together:
/// s(B) = min over B' with r' > r of d(c, c') / (r' - r); +infinity for the largest.
/// [B. Miklos: The Scale Axis Transform, 2010, section 6.2]
///
/// By a bounding volume hierarchy over (center, radius); near-linear in practice. Radii must be finite and >= 0.
/// Same result for every number of threads. `hints`, when not empty, holds per disk the index of another that is likely
/// to give a small value (any index is allowed; -1 for none): it only saves time.
std::vector<double> scale_importance(std::span<const Point_2> centers, std::span<const double> radii,
                                     std::span<const int> hints, Progress& progress);

}  // namespace mesecina
