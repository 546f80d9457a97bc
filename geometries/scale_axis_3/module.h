// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/scale_axis_3/scale_axis_3.h"

namespace mesecina {

/// Medial axis of the union of the grown balls.
inline constexpr Key<Medial_complex_3> grown_medial_axis_3_key{"grown-medial-axis-3"};
/// What pruning leaves of the grown axis: the scale axis before it is sampled; radii are not shrunk back.
struct Pruned_axis_3 {
  Medial_complex_3 complex;
  std::vector<double> angles;  ///< per face, before rims are smoothed
  Sheets_3 sheets;
};
inline constexpr Key<Pruned_axis_3> pruned_axis_3_key{"pruned-axis-3"};
inline constexpr Key<Ball_complex_3> scale_axis_3_key{"scale-axis-3"};

inline constexpr Setting<double> scale_3_setting{"scale"};

/// The scale axis transform in space: grown balls, the medial axis of their union, and what is left of it, shrunk back.
void register_scale_axis_3(Registry& registry);

}  // namespace mesecina
