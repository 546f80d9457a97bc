// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"

namespace mesecina {

/// Evolutions of meshes, points and balls in space, and the settings they read.
void register_evolutions_3(Registry& registry);

}  // namespace mesecina
