// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/medial_axis_2/medial_axis_2.h"

namespace mesecina {

inline constexpr Key<Medial_axis_2> medial_axis_2_key{"medial-axis-2"};

/// One number per edge and one per ball of the medial axis.
struct Importance_2 {
  std::vector<double> edges;
  std::vector<double> balls;
};
inline constexpr Key<Importance_2> lambda_2_key{"lambda-importance-2"};
inline constexpr Key<Importance_2> angle_2_key{"angle-importance-2"};

/// Facts of an edge of the axis and its contact points, for layers that show the axis. `element` counts isolated balls,
/// then edges.
Element_description describe_axis_element(Context& context, std::size_t element);
/// The balls that no edge of the axis has, in order.
std::vector<int> isolated_balls(const Medial_axis_2& axis);
/// The whole axis: isolated balls as points, then the edges; shared vertices, one per ball. Values are to be added by
/// the caller in that order.
Primitive_set axis_primitives(const Medial_axis_2& axis, const std::vector<int>& isolated);

/// Medial axis from samples, and its importance by lambda and contact angle.
void register_medial_axis_2(Registry& registry);

}  // namespace mesecina
