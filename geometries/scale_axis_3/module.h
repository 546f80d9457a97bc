// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/scale_axis_3/scale_axis_3.h"

namespace mesecina {

/// Medial axis of the union of the grown balls.
inline constexpr Key<Medial_complex_3> grown_medial_axis_3_key{"grown-medial-axis-3"};
inline constexpr Key<Ball_complex_3> scale_axis_3_key{"scale-axis-3"};

/// The scale axis transform in space: grown balls, the medial axis of their union, and what is left of it, shrunk back.
void register_scale_axis_3(Registry& registry);

}  // namespace mesecina
