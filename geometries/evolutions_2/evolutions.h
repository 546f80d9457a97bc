// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs.h"
#include "core/registry.h"

namespace mesecina {

/// What Lloyd's steps stay in where there is no outline: the bounding box of the points before the first of them.
inline constexpr Input_key<Box> lloyd_domain_input{"lloyd-domain"};

/// Of points on curves, and outlines.
Evolution_spec smoothing_2();
Evolution_spec subdivision_2();
Evolution_spec noise_2();
/// Of disks: given ones, or those of points and outlines.
Evolution_spec growing_2();
Evolution_spec shrinking_2();
Evolution_spec stepped_growing_2();
/// Of points.
Evolution_spec lloyd_2();

}  // namespace mesecina
