// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/style.h"

namespace mesecina {

/// The nearest view in which doubles still tell pixels apart and no length overflows; nullopt if a number is not finite
/// or the scale not positive.
std::optional<View_2> limited(const View_2& view);

/// The view in which the plane is `factor` times larger and the point under `pixel` stays where it is; at the limits of
/// zoom the factor is smaller.
View_2 zoomed(const View_2& view, double factor, const Point_2& pixel, double width, double height);
/// The view after dragging the plane by so many logical pixels, y down.
View_2 panned(const View_2& view, double dx, double dy);

/// The views one can go back to. Steps that belong together (those of one gesture, or small ones that follow each other
/// within half a second) are one entry. The newest hundred entries are kept.
class View_history {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// All steps until end_gesture are one entry, which starts at `view`.
  void begin_gesture(const View_2& view);
  void end_gesture();
  /// Says that the view goes from `from` to `to` now.
  void step(const View_2& from, const View_2& to, Time now);
  /// As step, but never joined with another.
  void jump(const View_2& from, const View_2& to);
  /// Takes the newest entry that differs from `current`; nullopt when there is none.
  std::optional<View_2> take(const View_2& current);

 private:
  void remember(const View_2& view);

  std::vector<View_2> views_;
  bool in_gesture_ = false;
  std::optional<Time> last_step_;
};

}  // namespace mesecina
