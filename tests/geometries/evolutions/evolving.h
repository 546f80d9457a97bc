// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/evolution.h"
#include "geometries/modules_2.h"

namespace mesecina::test {

/// What steps make of inputs.
struct Evolved {
  Inputs inputs;
  Settings settings;
  Evolution_result result;

  template <class T>
  const T& operator[](Input_key<T> key) const {
    const auto value = inputs.get(key);
    if (value) return *value;
    ADD_FAILURE() << "no " << key.id << "; " << result.end_reason;
    static const T none{};
    return none;
  }
};

inline Evolved run_steps(const std::shared_ptr<const Registry>& registry, Inputs inputs, const std::string& id,
                         std::uint64_t steps, Settings settings = {}) {
  Graph graph(registry);
  graph.set_inputs(std::move(inputs));
  graph.set_settings(std::move(settings));
  Progress progress;
  Evolution_result result = evolve(graph, id, steps, progress);
  return {graph.inputs(), graph.settings(), std::move(result)};
}

/// In the plane.
inline Evolved evolved_2(Inputs inputs, const std::string& id, std::uint64_t steps, Settings settings = {}) {
  return run_steps(make_registry_2(), std::move(inputs), id, steps, std::move(settings));
}

}  // namespace mesecina::test
