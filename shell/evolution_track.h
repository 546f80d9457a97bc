// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/inputs.h"
#include "core/registry.h"
#include "core/settings.h"

namespace mesecina {

/// The states that evolutions went through, from where the first one began. An immutable value: what is changed is
/// another track, and undo keeps the old one.
struct Evolution_track {
  struct Place {
    Inputs inputs;
    /// Of all that some step changes, the values here; nullopt: the default.
    std::map<std::string, std::optional<Setting_value>, std::less<>> settings;
    std::string evolution;     ///< that led here; empty for the start
    std::uint64_t number = 0;  ///< of the step in its evolution; 0 for the start
  };
  std::vector<Place> places;                ///< never empty; the first is the start
  std::set<std::string, std::less<>> read;  ///< settings that the steps were made by

  std::size_t step_count() const { return places.size() - 1; }
};

using Track_pointer = std::shared_ptr<const Evolution_track>;

/// A track without steps that starts here.
Track_pointer start_track(const Inputs& inputs);

/// The places up to `position`, and one more: `after`, which one step of the evolution made of `before`. Of the
/// settings those that steps change belong to places; they are given to earlier places as they were there. O(places).
Track_pointer with_step(const Evolution_track& track, std::size_t position, const Evolution_spec& evolution,
                        const Evolution_state& before, const Evolution_state& after);

/// The places before `position`, and at it what the user made of the place by hand. Null where that leaves no step.
Track_pointer branched(const Evolution_track& track, std::size_t position, const Inputs& inputs,
                       const Settings& settings);

/// The settings as they are at a place of the track. Throws std::out_of_range for a position that is none.
Settings settings_at(const Evolution_track& track, std::size_t position, Settings settings);

/// True when a change of these settings makes other steps: they were read by steps, or belong to places.
bool concerns(const Evolution_track& track, const Settings& before, const Settings& after);

}  // namespace mesecina
