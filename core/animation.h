// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/registry.h"
#include "core/settings.h"

namespace mesecina {

/// A number that moves from one value to another, step by step: what it is depends on the number of the frame only,
/// never on time.
struct Sweep {
  enum class Easing { linear, smooth };  ///< smooth: starts and ends slowly

  std::string setting;
  double from = 0;
  double to = 1;
  int steps = 100;  ///< frames on the way there, both ends included; 1: only `from`
  Easing easing = Easing::linear;
  bool is_ping_pong = false;  ///< and the same way back, to where it began

  bool operator==(const Sweep&) const = default;
  /// steps, or 2 * steps - 1 for there and back.
  int frames() const { return is_ping_pong ? 2 * steps - 1 : steps; }
  /// In frame 0, 1, ...; exactly `from` and exactly `to` at the ends; after the last frame that of the last.
  double value(int frame) const;
};

/// The most steps that a sweep may have.
inline constexpr int most_sweep_steps = 1'000'000;

/// The settings in this frame of all sweeps together. Those of whole numbers get the nearest one. The sweeps must be of
/// numbers that the registry knows (check_sweep).
Settings swept(const Registry& registry, Settings settings, std::span<const Sweep> sweeps, int frame);
/// The frames of the longest; 0 for none.
int frames_of(std::span<const Sweep> sweeps);

/// Throws std::invalid_argument, with what is wrong and what was expected, for a setting that is unknown or no number,
/// ends that are no values of it, and steps beyond 1 ... most_sweep_steps.
void check_sweep(const Registry& registry, const Sweep& sweep);

/// Reads ID=FROM:TO:STEPS, followed by any of ":smooth" and ":ping-pong". Throws std::invalid_argument, with what was
/// expected, for other texts and as check_sweep does.
Sweep parse_sweep(const Registry& registry, std::string_view text);
/// What parse_sweep reads.
std::string to_text(const Sweep& sweep);

}  // namespace mesecina
