// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs.h"

namespace mesecina {

/// A closed mesh that looks well and shows what a medial axis is: a ring whose flattened cross section turns and swells
/// on its way around, about 3 across, its axis along z. `segments` around the ring; a third as many around the cross
/// section.
Triangle_mesh_3 twisted_ring(int segments);

}  // namespace mesecina
