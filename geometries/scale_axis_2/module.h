// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/scale_axis_2/scale_axis_2.h"

namespace mesecina {

/// Boundary of the union of the grown medial disks.
inline constexpr Key<Union_boundary_2> grown_boundary_2_key{"grown-boundary-2"};
/// Its medial axis, with incomplete edges.
inline constexpr Key<Union_medial_axis_2> grown_medial_axis_2_key{"grown-medial-axis-2"};
inline constexpr Key<Scale_axis_2> scale_axis_2_key{"scale-axis-2"};
inline constexpr Key<Union_boundary_2> scale_axis_shape_2_key{"scale-axis-shape-2"};

inline constexpr Setting<double> scale_setting{"scale"};
inline constexpr Setting<double> scale_axis_min_angle_setting{"scale-axis-min-angle"};
inline constexpr Setting<double> sampling_min_angle_setting{"sampling-min-angle"};

/// The scale axis transform: grown disks, the medial axis of their union, and what is left of it when shrunk back.
void register_scale_axis_2(Registry& registry);

}  // namespace mesecina
