// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <typeindex>
#include <vector>

#include "core/primitives.h"
#include "core/settings.h"
#include "core/style.h"

namespace mesecina {

class Context;

/// Names a structure; two keys with the same id must have the same T.
template <class T>
struct Key {
  std::string_view id;
};

/// One row of what is known of an element: ("angle", "63.4 degrees").
struct Fact {
  std::string name;
  std::string text;
};

/// Answer to "what is this?" under the mouse.
struct Element_description {
  std::vector<Fact> facts;
  Primitive_set dual;  ///< drawn highlighted: the dual cell, the contact points, the source balls
};

struct Structure_spec {
  std::string id;
  std::type_index type = typeid(void);
  /// Returns the structure, or throws Unavailable.
  std::function<std::shared_ptr<void>(Context&)> compute;
  /// Optional. Given the value that `compute` or `update` returned last (never null) it returns what `compute` would
  /// return now (the same up to the order of its parts), faster when little has changed. It finds out what changed by
  /// comparing. It may change `previous` in place and return it when it holds the only reference (use_count() == 1).
  std::function<std::shared_ptr<void>(Context&, std::shared_ptr<void> previous)> update;
};

/// A named view of structures. Registered as data; everything the panel, the command line and the manual show of it is
/// here.
struct Layer_spec {
  std::string id;     ///< kebab-case, unique
  std::string label;  ///< a few words
  std::string stage;  ///< group in the panel: "Input", "Diagram", "Reconstruction", "Medial axis", "Filtration", ...
  std::string help;   ///< definition and paper; a sentence or two
  Style style;        ///< default look
  std::function<Primitive_set(Context&)> build;
  /// Optional: the value and setting by which elements belong to the layer. The setting's own number is the limit.
  std::string cut_value;
  std::string cut_setting;
  /// Optional: while this boolean setting is true the cut goes by `cut_value_when_switched` instead.
  std::string cut_switch;
  std::string cut_value_when_switched;
  /// Optional: facts of one element beyond its number and values, and what to highlight with it.
  std::function<Element_description(Context&, std::size_t element)> describe;
};

/// What an evolution changes step by step.
struct Evolution_state {
  Inputs inputs;
  Settings settings;
};

/// A change of the data that can be repeated: every step makes a new state of the last one. Steps are pure: the same
/// state, and the same number of the step, give the same next state.
/// What an evolution needs of the data, which can be told before anything is computed.
struct Evolution_needs {
  std::string what;  ///< "points along a curve, or an outline"; completes "needs". Empty: it starts from anything
  /// Optional: why no step can start from the state, one line for the user. Empty where one may, though what is
  /// computed in the step can still say otherwise. Its time must not grow with the data.
  std::function<std::string(const Evolution_state&)> why_not;
};

struct Evolution_spec {
  std::string id;                     ///< kebab-case, unique
  std::string label;                  ///< a few words
  std::string help;                   ///< what a step does, and the paper
  std::vector<std::string> settings;  ///< ids of those that a step reads, for the window
  Evolution_needs needs;
  /// Called only where needs.why_not says nothing. The state after step number `step` (1 for the first). The context
  /// has the structures, inputs and settings of the state before, which is also `before`. Throws Unavailable where
  /// there is nothing to change; a state that equals `before` (the same inputs by identity and the same settings) is
  /// the end of the evolution.
  std::function<Evolution_state(Context&, const Evolution_state& before, std::uint64_t step)> step;
};

/// Why the evolution does not suit the state, as Evolution_needs::why_not; empty where it does.
std::string why_unfit(const Evolution_spec& evolution, const Evolution_state& state);

struct Module_spec {
  std::string id;
  std::string label;
  std::string help;
};

/// All that geometry modules declare. Built once at start, then shared read-only.
class Registry {
 public:
  /// dimension: of the space that the modules are about.
  explicit Registry(int dimension = 2) : dimension_(dimension) {}
  int dimension() const { return dimension_; }

  /// Everything added after this call belongs to this module.
  void begin_module(Module_spec module);

  template <class T>
  void add_structure(Key<T> key, std::function<T(Context&)> compute,
                     std::function<std::shared_ptr<T>(Context&, std::shared_ptr<T>)> update = {}) {
    Structure_spec spec;
    spec.id = key.id;
    spec.type = typeid(T);
    spec.compute = [compute = std::move(compute)](Context& context) -> std::shared_ptr<void> {
      return std::make_shared<T>(compute(context));
    };
    if (update) {
      spec.update = [update = std::move(update)](Context& context,
                                                 std::shared_ptr<void> previous) -> std::shared_ptr<void> {
        auto typed = std::static_pointer_cast<T>(previous);
        previous.reset();
        return update(context, std::move(typed));
      };
    }
    add(std::move(spec));
  }
  /// In space areas are filled by default: outlines alone hide nothing and are hard to read.
  void add_layer(Layer_spec layer);
  void add_setting(Setting_spec setting);
  void add_evolution(Evolution_spec evolution);

  /// In the order of registration: the order of the panel, of --list and the default drawing order.
  const std::vector<Layer_spec>& layers() const { return layers_; }
  const std::vector<Setting_spec>& settings() const { return settings_; }
  const std::vector<Evolution_spec>& evolutions() const { return evolutions_; }
  const std::vector<Module_spec>& modules() const { return modules_; }
  const std::vector<Structure_spec>& structures() const { return structures_; }
  const Layer_spec* find_layer(std::string_view id) const;
  const Setting_spec* find_setting(std::string_view id) const;
  const Evolution_spec* find_evolution(std::string_view id) const;
  const Structure_spec* find_structure(std::string_view id) const;
  /// Module of a layer, setting or evolution.
  const Module_spec* module_of(std::string_view id) const;

  /// The cut of a layer under these settings; nullopt for layers without one.
  std::optional<Cut> cut(const Layer_spec& layer, const Settings& settings) const;
  /// Value of a known setting: the changed one or its default. Throws std::out_of_range for an unknown id.
  const Setting_value& value(const Settings& settings, std::string_view id) const;

 private:
  void add(Structure_spec spec);

  int dimension_;
  std::vector<Module_spec> modules_;
  std::vector<Structure_spec> structures_;
  std::vector<Layer_spec> layers_;
  std::vector<Setting_spec> settings_;
  std::vector<Evolution_spec> evolutions_;
  std::map<std::string, std::size_t, std::less<>> structure_index_;
  std::map<std::string, std::size_t, std::less<>> layer_index_;
  std::map<std::string, std::size_t, std::less<>> setting_index_;
  std::map<std::string, std::size_t, std::less<>> evolution_index_;
  std::map<std::string, std::size_t, std::less<>> module_index_;
};

/// The candidate nearest to `word` by edit distance, if any is near enough to be a misspelling; else empty.
std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace mesecina
