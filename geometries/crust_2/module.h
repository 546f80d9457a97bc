// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/crust_2/one_step_crust.h"

namespace mesecina {

inline constexpr Key<Crust_2> crust_2_key{"one-step-crust-2"};

/// Reconstruction of the curve from the samples.
void register_crust_2(Registry& registry);

}  // namespace mesecina
