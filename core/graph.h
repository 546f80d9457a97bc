// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/inputs.h"
#include "core/outcome.h"
#include "core/place.h"
#include "core/progress.h"
#include "core/registry.h"
#include "core/settings.h"

namespace mesecina {

class Graph;

/// What the function of a structure or a layer may read. Every call is recorded, and the result is computed anew only
/// when something that was read has changed since.
class Context {
 public:
  /// The structure; throws Unavailable with its reason when it could not be computed.
  template <class T>
  std::shared_ptr<const T> get(Key<T> key) {
    return std::static_pointer_cast<const T>(structure(key.id, typeid(T)));
  }
  /// Null when the user gave none.
  template <class T>
  std::shared_ptr<const T> input(Input_key<T> key) {
    record_input(key.id);
    return inputs().get(key);
  }
  template <class T>
  T setting(Setting<T> setting) {
    return std::get<T>(setting_value(setting.id));
  }
  Progress& progress();
  /// A remark for the user that is no failure ("12 of 1000 points are duplicates"), and where it is seen; kept with the
  /// result.
  void warn(std::string text, std::vector<Place> places = {});
  /// A number reached that statistics shall tell ("hausdorff"); kept with the result.
  void measure(std::string name, double value);
  /// A fact that statistics shall tell ("repair": "oriented"); kept with the result.
  void note(std::string name, std::string text);

 private:
  friend class Graph;
  struct Frame;
  Context(Graph& graph, Frame& frame) : graph_(graph), frame_(frame) {}
  std::shared_ptr<const void> structure(std::string_view id, std::type_index type);
  void record_input(std::string_view id);
  const Inputs& inputs() const;
  const Setting_value& setting_value(std::string_view id);

  Graph& graph_;
  Frame& frame_;
};

/// Computes structures and layers on demand and keeps them while what they read stays the same.
/// Dependencies are what a function asked for, never declared. A failure is kept like a value, with its reason, and
/// tried again only when something it read has changed. Not thread-safe: one thread uses it at a time.
class Graph {
 public:
  explicit Graph(std::shared_ptr<const Registry> registry);
  ~Graph();
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;

  void set_inputs(Inputs inputs);
  void set_settings(Settings settings);
  const Inputs& inputs() const;
  const Settings& settings() const;
  const Registry& registry() const;

  /// Throws Cancelled; what was complete by then is kept. Unknown id: std::out_of_range.
  Outcome<Primitive_set> layer(std::string_view id, Progress& progress);
  template <class T>
  Outcome<T> structure(Key<T> key, Progress& progress) {
    auto [value, reason] = evaluate(key.id, progress);
    return {std::static_pointer_cast<const T>(std::move(value)), std::move(reason)};
  }
  /// What the layer's own `describe` says of an element; empty where it has none, where it fails, or when the element
  /// is out of range. Throws as `layer`.
  Element_description describe(std::string_view layer_id, std::size_t element, Progress& progress);

  /// The state after step number `step` of an evolution from the present inputs and settings, which stay as they are;
  /// or the reason why there is none. Throws as `layer`.
  Outcome<Evolution_state> evolve(std::string_view evolution_id, std::uint64_t step, Progress& progress);

  /// True when `layer` would answer from what is kept, without computing.
  bool is_current(std::string_view layer_id);

  struct Stage {
    std::string id;        ///< of the structure or layer
    double seconds = 0;    ///< own time, without what it waited for
    bool updated = false;  ///< by the incremental path
  };
  /// The computations since the last call of clear_stages, in the order they ended.
  const std::vector<Stage>& stages() const;
  void clear_stages();
  /// What all structures that the layer rests on have warned of, each once.
  std::vector<Remark> remarks(std::string_view layer_id) const;
  /// Their texts.
  std::vector<std::string> warnings(std::string_view layer_id) const;
  /// What all structures that have been computed and are up to date have measured.
  std::map<std::string, double> measures() const;
  /// What all structures that have been computed and are up to date have noted.
  std::map<std::string, std::string> notes() const;
  /// How often the function of a structure or layer has run; for tests and statistics.
  std::uint64_t computations(std::string_view id) const;

 private:
  friend class Context;
  struct Node;
  struct State;
  std::pair<std::shared_ptr<const void>, std::string> evaluate(std::string_view id, Progress& progress);
  std::unique_ptr<State> state_;
};

}  // namespace mesecina
