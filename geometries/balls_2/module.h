// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/balls_2/balls_2.h"

namespace mesecina {

/// The disks whose union is looked at, as the setting says.
inline constexpr Key<Balls_2> balls_2_key{"balls-2"};
/// The Voronoi disks that are centered inside the shape.
inline constexpr Key<Circumscribed_balls_2> inner_voronoi_balls_2_key{"inner-voronoi-balls-2"};

inline constexpr Setting<std::string> ball_source_setting{"ball-source"};
inline constexpr std::string_view ball_source_automatic = "automatic";
inline constexpr std::string_view ball_source_drawn = "drawn";
inline constexpr std::string_view ball_source_inner_voronoi = "inner-voronoi";
inline constexpr std::string_view ball_source_inner_poles = "inner-poles";

/// Facts of a disk of a set: center, radius, the samples on its circle; these are highlighted.
Element_description describe_ball(const Balls_2& balls, std::size_t ball);

/// Which disks structures "from balls" start from.
void register_balls_2(Registry& registry);

}  // namespace mesecina
