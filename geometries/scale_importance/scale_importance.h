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
struct Scale_importance {
  std::vector<double> values;
  std::vector<int> witnesses;  ///< per disk an index B' that attains the minimum; -1 where there is none
};

/// By a bounding volume hierarchy over (center, radius); near-linear in practice. Radii must be finite and >= 0.
/// Each value is the least of the quotients as rounded, so it is the same for every number of threads and search order.
Scale_importance scale_importance(std::span<const Point_2> centers, std::span<const double> radii, Progress& progress);

/// The same after some disks were exchanged: `old_index` says per disk which one of the old disks it is, unchanged; -1
/// for a new one. `old` is what scale_importance returned for the old disks. Equal values to those of a full
/// computation. O(n) for a few exchanged disks.
Scale_importance update_scale_importance(const Scale_importance& old, std::span<const int> old_index,
                                         std::span<const Point_2> centers, std::span<const double> radii,
                                         Progress& progress);

}  // namespace mesecina
