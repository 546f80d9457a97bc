// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evolution_needs.h"

#include <utility>

#include "core/graph.h"

namespace mesecina {

namespace {

struct Needing_step {
  Evolution_needs needs;
  std::function<Evolution_state(Context&, const Evolution_state&, std::uint64_t)> step;

  Evolution_state operator()(Context& context, const Evolution_state& before, std::uint64_t number) const {
    const std::string reason = needs.why_not(before);
    if (!reason.empty()) throw Unavailable(reason);
    return step(context, before, number);
  }
};

}  // namespace

std::function<Evolution_state(Context&, const Evolution_state&, std::uint64_t)> needing(
    Evolution_needs needs, std::function<Evolution_state(Context&, const Evolution_state&, std::uint64_t)> step) {
  return Needing_step{std::move(needs), std::move(step)};
}

const Evolution_needs* needs_of(const Evolution_spec& evolution) {
  const auto* step = evolution.step.target<Needing_step>();
  return step ? &step->needs : nullptr;
}

std::string why_unfit(const Evolution_spec& evolution, const Evolution_state& state) {
  const Evolution_needs* needs = needs_of(evolution);
  return needs ? needs->why_not(state) : std::string();
}

}  // namespace mesecina
