// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// Samples, in order, of a smooth closed curve with five lobes and no symmetry.
std::vector<Point_2> smooth_curve(std::size_t count);
/// The same with 211 ripples: a medial axis with as many branches.
std::vector<Point_2> rippled_curve(std::size_t count);
/// A five-armed star with a ripple and noise, as one ring of `count` segments. Simple: radius is a function of the
/// angle.
Outline_2 noisy_star(std::size_t count, std::uint64_t seed);

}  // namespace mesecina
