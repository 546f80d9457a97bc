// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/point.h"
#include "core/progress.h"

namespace mesecina {

/// Per disk B the factor at which a single larger disk covers it when all grow together:
/// s(B) = min over B' with r' > r of d(c, c') / (r' - r); +infinity for the largest. Less than 1 when a larger disk
/// covers it as it is.
/// [B. Miklos: The Scale Axis Transform, 2010, section 6.2]
struct Scale_importance {
  std::vector<double> values;
  /// Per disk an index B' that attains the minimum, or one not above `least`; -1 where there is none.
  std::vector<int> witnesses;

  /// What an update searches in: a hierarchy of the disks of the last full computation, and which disk each of these is
  /// now, -1 for those that are gone.
  class Hierarchy;
  std::shared_ptr<const Hierarchy> hierarchy;
  std::vector<int> disk_of_entry;
};

/// By a bounding volume hierarchy over (center, radius); near-linear in practice. Radii must be finite and >= 0,
/// distances and radii such that their squares do not overflow (up to about 1e150). Each value is the least of the
/// quotients as rounded, so it is the same for every number of threads and search order.
///
/// least: values below it are raised to it. 0: nothing is. 1, for disks of which none lies within another: only
/// rounding can make such values less, and where thousands of disks differ by rounding alone (samples on one circle) a
/// search for the very least of them would not be near-linear.
Scale_importance scale_importance(std::span<const Point_2> centers, std::span<const double> radii, double least,
                                  Progress& progress);

/// The same after some disks were exchanged: `old_index` says per disk which one of the old disks it is, unchanged; -1
/// for a new one. `old` is what scale_importance or this returned for the old disks with the same `least`. Equal values
/// to those of a full computation. O(n) with a small constant for a few exchanged disks.
Scale_importance update_scale_importance(const Scale_importance& old, std::span<const int> old_index,
                                         std::span<const Point_2> centers, std::span<const double> radii, double least,
                                         Progress& progress);

}  // namespace mesecina
