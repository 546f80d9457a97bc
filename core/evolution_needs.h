// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "core/registry.h"

namespace mesecina {

/// What an evolution needs of the data, which can be told before anything is computed.
struct Evolution_needs {
  std::string what;  ///< "points along a curve, or an outline"; completes "needs"
  /// Why no step can start from the state: one line for the user. Empty where one may, though what is computed in the
  /// step can still say otherwise. Its time must not grow with the data.
  std::function<std::string(const Evolution_state&)> why_not;
};

/// For Evolution_spec::step: the step, refused with the reason of why_not where there is one.
std::function<Evolution_state(Context&, const Evolution_state&, std::uint64_t)> needing(
    Evolution_needs needs,
    std::function<Evolution_state(Context&, const Evolution_state& before, std::uint64_t step)> step);

/// What its step was made with by needing(); null for an evolution that starts from anything. Lives as long as the
/// spec.
const Evolution_needs* needs_of(const Evolution_spec& evolution);

/// Why the evolution does not suit the state, as Evolution_needs::why_not; empty where it does.
std::string why_unfit(const Evolution_spec& evolution, const Evolution_state& state);

}  // namespace mesecina
