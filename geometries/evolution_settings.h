// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/evolution.h"
#include "core/registry.h"

namespace mesecina {

/// What evolutions of the plane and of space read alike.
inline constexpr Setting<double> smoothing_factor_setting{"smoothing-factor"};
inline constexpr Setting<bool> smoothing_keeps_size_setting{"smoothing-keeps-size"};
inline constexpr Setting<double> noise_amplitude_setting{"noise-amplitude"};
inline constexpr Setting<double> growing_step_setting{"growing-step"};

void add_smoothing_settings(Registry& registry);
/// noise-amplitude and evolution-seed.
void add_noise_settings(Registry& registry);
void add_growing_settings(Registry& registry);

/// The factors by which points move toward the middle of their neighbours in one step of smoothing, one after the
/// other: `factor`; and, if the size is to be kept, a negative one that undoes what the first does to waves longer than
/// about 15 points. `factor` is then taken for at most 0.69, beyond which the shortest waves would grow.
/// [G. Taubin: A signal processing approach to fair surface design, 1995]
std::vector<double> smoothing_passes(double factor, bool keeps_size);

/// By what to multiply radii that have grown by `percent` of what they were at first, `step` - 1 times, so that they
/// have grown once more (shrunk, for negative percents). 0 where nothing would be left.
double growth_of_step(double percent, std::uint64_t step);

/// Of the random numbers of a step.
std::uint64_t seed_of_step(std::int64_t seed, std::uint64_t step);

}  // namespace mesecina
