// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs.h"
#include "core/registry.h"
#include "geometries/dual_2/dual_2.h"
#include "geometries/landmark_disks_2/landmark_disks_2.h"

namespace mesecina {

/// Disks that were chosen, in the order in which they were: what the evolution landmark-disks adds to.
inline constexpr Input_key<std::vector<Disk_2>> landmark_disks_input{"landmark-disks"};

inline constexpr Key<Landmark_coverage_2> landmark_coverage_2_key{"landmark-coverage-2"};
/// Of the landmarks, grown until each disk is in one.
inline constexpr Key<Dual_2> landmark_dual_2_key{"landmark-dual-2"};

/// Landmarks among disks, what shape they describe, and the evolution that adds them.
void register_landmark_disks_2(Registry& registry);

}  // namespace mesecina
