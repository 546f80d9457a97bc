// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/samples_3/ball_approximation_3.h"

namespace mesecina {

inline constexpr Key<Solid_3> solid_3_key{"solid-3"};
inline constexpr Key<Ball_approximation_3> ball_approximation_3_key{"ball-approximation-3"};
inline constexpr Key<Surface_samples_3> surface_samples_3_key{"surface-samples-3"};
/// The balls whose union is looked at: given ones, then the inner poles of the mesh; without both, those of the points.
/// ball-source may choose some of them.
inline constexpr Key<std::vector<Ball_3>> balls_3_key{"balls-3"};

inline constexpr Setting<std::string> ball_source_3_setting{"ball-source"};
inline constexpr const char* ball_source_3_automatic = "automatic";
inline constexpr const char* ball_source_3_given = "given";
inline constexpr const char* ball_source_3_computed = "computed";
inline constexpr Setting<std::string> repair_setting{"repair"};
inline constexpr Setting<double> delta_setting{"delta"};
inline constexpr Setting<double> perturbation_setting{"perturbation"};
inline constexpr Setting<double> given_perturbation_setting{"given-perturbation"};

/// Whether the balls are those that approximate the mesh and no others, of ball_approximation_3_key.
bool are_balls_of_mesh(Context& context);

/// From a mesh to a solid, samples of its surface, and the balls that approximate it.
void register_samples_3(Registry& registry);

}  // namespace mesecina
