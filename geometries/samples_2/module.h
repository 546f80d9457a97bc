// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/place.h"
#include "core/registry.h"
#include "geometries/samples_2/samples_2.h"

namespace mesecina {

inline constexpr Key<Samples_2> samples_2_key{"samples-2"};
inline constexpr Setting<double> sampling_step_setting{"sampling-step"};

/// The samples that every structure "from samples" starts from, and how densely an outline is sampled.
void register_samples_2(Registry& registry);

/// Where these samples are, for remarks; those that the user gave as points are elements of these.
std::vector<Place> sample_places(Context& context, std::span<const int> samples);

}  // namespace mesecina
