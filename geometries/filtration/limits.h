// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/registry.h"

namespace mesecina {

inline constexpr Setting<double> lambda_limit_setting{"lambda-limit"};
inline constexpr Setting<double> angle_limit_setting{"angle-limit"};
inline constexpr Setting<double> scale_limit_setting{"scale-limit"};

/// Registers the limits of the filtrations of a medial axis, the same in the plane and in space. `ball`: what a medial
/// ball is called there.
void add_filtration_limits(Registry& registry, const std::string& ball);

}  // namespace mesecina
