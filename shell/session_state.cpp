// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/session_state.h"

namespace mesecina {

Document_state state_of(const Session& session, const Registry& registry) {
  Document_state state{session.inputs, session.settings, with_missing_layers(session.layers, registry)};
  if (session.bundle) state.bundle = session.bundle->name;
  if (session.steps.empty()) return state;
  auto track = std::make_shared<Evolution_track>();
  track->read.insert(session.step_settings.begin(), session.step_settings.end());
  for (const Session::Step& step : session.steps)
    track->places.push_back({step.inputs, {step.settings.begin(), step.settings.end()}, step.evolution, step.number});
  state.track = std::move(track);
  state.position = session.position;
  return state;
}

Session session_of(const Document_state& state, int dimension) {
  Session session;
  session.dimension = dimension;
  session.inputs = state.inputs;
  session.settings = state.settings;
  session.layers = state.layers;
  if (!state.track) return session;
  session.position = state.position;
  session.step_settings.assign(state.track->read.begin(), state.track->read.end());
  for (const Evolution_track::Place& place : state.track->places)
    session.steps.push_back(
        {place.inputs, {place.settings.begin(), place.settings.end()}, place.evolution, place.number});
  return session;
}

}  // namespace mesecina
