// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"

namespace mesecina {

/// Parts of the Delaunay triangulation of the samples: the convex hull, the Gabriel complex.
void register_delaunay_parts_3(Registry& registry);

}  // namespace mesecina
