// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"

namespace mesecina {

/// Evolutions of points, outlines and disks in the plane, and the settings they read.
void register_evolutions_2(Registry& registry);

}  // namespace mesecina
