// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/animation.h"
#include "shell/frame_player.h"
#include "shell/popover.h"

namespace mesecina {

/// What is done with settings that shall move together.
struct Animation_popover_calls {
  std::function<void(const std::vector<Sweep>&)> play;
  std::function<void(const std::vector<Sweep>&)> record;
  std::function<void(const std::vector<Sweep>&)> remember;  ///< after each change
};

/// Asks how a setting shall move, and plays it. Stays open meanwhile. `animation`: what moved last, which it may move
/// along with; it does at first if it is among them.
Popover* open_animation_popover(const Registry& registry, const Sweep& start, const std::vector<Sweep>& animation,
                                double frames_per_second, Frame_player& player, QWidget* over,
                                Animation_popover_calls calls);

}  // namespace mesecina
