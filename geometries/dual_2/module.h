// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/dual_2/dual_2.h"

namespace mesecina {

inline constexpr Key<Dual_2> dual_2_key{"dual-2"};
inline constexpr Setting<double> alpha_setting{"alpha"};

/// Dual complex of the union of the disks.
void register_dual_2(Registry& registry);

}  // namespace mesecina
