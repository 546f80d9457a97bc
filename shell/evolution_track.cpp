// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/evolution_track.h"

#include <algorithm>
#include <utility>

namespace mesecina {

namespace {

std::optional<Setting_value> value_in(const Settings& settings, std::string_view id) {
  const Setting_value* value = settings.find(id);
  return value ? std::optional(*value) : std::nullopt;
}

std::set<std::string, std::less<>> different(const Settings& first, const Settings& second) {
  std::set<std::string, std::less<>> ids;
  for (const Settings* settings : {&first, &second})
    for (const auto& [id, value] : settings->changed())
      if (value_in(first, id) != value_in(second, id)) ids.insert(id);
  return ids;
}

std::vector<Evolution_track::Place> first_places(const Evolution_track& track, std::size_t count) {
  const auto end = track.places.begin() + static_cast<std::ptrdiff_t>(std::min(count, track.places.size()));
  return {track.places.begin(), end};
}

}  // namespace

Track_pointer start_track(const Inputs& inputs) {
  auto track = std::make_shared<Evolution_track>();
  track->places.push_back({inputs, {}, {}, 0});
  return track;
}

Track_pointer with_step(const Evolution_track& track, std::size_t position, const Evolution_spec& evolution,
                        const Evolution_state& before, const Evolution_state& after) {
  auto longer = std::make_shared<Evolution_track>();
  longer->places = first_places(track, position + 1);
  longer->read = track.read;
  longer->read.insert(evolution.settings.begin(), evolution.settings.end());
  for (const std::string& id : different(before.settings, after.settings))
    for (Evolution_track::Place& place : longer->places) place.settings.emplace(id, value_in(before.settings, id));
  const Evolution_track::Place& last = longer->places.back();
  Evolution_track::Place place{after.inputs, {}, evolution.id, last.evolution == evolution.id ? last.number + 1 : 1};
  for (const auto& [id, value] : last.settings) place.settings.emplace(id, value_in(after.settings, id));
  longer->places.push_back(std::move(place));
  return longer;
}

Track_pointer branched(const Evolution_track& track, std::size_t position, const Inputs& inputs,
                       const Settings& settings) {
  if (position == 0 || position >= track.places.size()) return nullptr;
  auto branch = std::make_shared<Evolution_track>();
  branch->places = first_places(track, position + 1);
  branch->read = track.read;
  Evolution_track::Place& place = branch->places.back();
  place.inputs = inputs;
  for (auto& [id, value] : place.settings) value = value_in(settings, id);
  return branch;
}

Settings settings_at(const Evolution_track& track, std::size_t position, Settings settings) {
  for (const auto& [id, value] : track.places.at(position).settings)
    settings = value ? settings.with(id, *value) : settings.without(id);
  return settings;
}

bool concerns(const Evolution_track& track, const Settings& before, const Settings& after) {
  const auto& driven = track.places.front().settings;
  return std::ranges::any_of(different(before, after), [&](const std::string& id) {
    return track.read.contains(id) || driven.find(id) != driven.end();
  });
}

}  // namespace mesecina
