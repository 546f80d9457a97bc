// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/animation.h"
#include "shell/frame_player.h"
#include "shell/popover.h"

namespace mesecina {

/// Asks how a setting shall move, and plays it. Stays open meanwhile.
struct Animation_popover_calls {
  std::function<void(const Sweep&)> play;
  std::function<void(const Sweep&)> record;
  std::function<void(const Sweep&)> remember;  ///< after each change
};
Popover* open_animation_popover(const Registry& registry, const Sweep& start, double frames_per_second,
                                Frame_player& player, QWidget* over, Animation_popover_calls calls);

}  // namespace mesecina
