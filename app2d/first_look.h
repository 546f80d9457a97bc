// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs.h"
#include "core/registry.h"
#include "layers/layer_list.h"

namespace mesecina {

/// A few layers that tell a story together: of points and outlines the Voronoi diagram, the curve and what is inside
/// it; of disks alone the boundary and the medial axis of their union; of landmarks what they stand for.
Layer_list first_look(const Registry& registry, const Inputs& inputs);

/// What to show of `inputs` to somebody who sees `layers`: a first look if they are one, which means that the user has
/// chosen nothing yet; else the same layers.
Layer_list look_at(const Registry& registry, const Inputs& inputs, const Layer_list& layers);

}  // namespace mesecina
