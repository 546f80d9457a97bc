// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"

namespace mesecina {

/// The layers of what was read in space: mesh, points, given balls.
void register_inputs_3(Registry& registry);

}  // namespace mesecina
