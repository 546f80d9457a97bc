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
  /// Per disk an index B' that attains the minimum, or one not above 1 if slopes were given; -1 where there is none.
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
/// slopes: empty, or one per disk, in [0,1], for disks whose numbers are rounded and of which none has a contact point
/// of another in its interior: at which slope the distance to the nearest contact point of the disk grows at most, from
/// its center on. Then no quotient can be less than 1 / (slope + d / 2r), because r' <= |c' - k| for every contact
/// point k. Quotients are raised to that and to 1: where two centers differ by little more than rounding nothing else
/// is left of them. It also keeps the search near-linear where that is so for thousands of disks (samples on one
/// circle).
Scale_importance scale_importance(std::span<const Point_2> centers, std::span<const double> radii,
                                  std::span<const double> slopes, Progress& progress);

/// The same of balls in space.
struct Scale_importance_3 {
  std::vector<double> values;
  std::vector<int> witnesses;
};

/// As in the plane, with the same bounds by slopes. Near-linear in practice for balls whose centers lie along surfaces.
Scale_importance_3 scale_importance(std::span<const Point_3> centers, std::span<const double> radii,
                                    std::span<const double> slopes, Progress& progress);

/// The same after some disks were exchanged: `old_index` says per disk which one of the old disks it is, unchanged
/// together with its slope; -1 for a new one. `old` is what scale_importance or this returned for the old disks. Equal
/// values to those of a full computation. O(n) with a small constant for a few exchanged disks.
Scale_importance update_scale_importance(const Scale_importance& old, std::span<const int> old_index,
                                         std::span<const Point_2> centers, std::span<const double> radii,
                                         std::span<const double> slopes, Progress& progress);

}  // namespace mesecina
