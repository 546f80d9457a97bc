// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/canvas_background.h"
#include "core/formats/scene_json.h"
#include "core/inputs.h"
#include "core/layer_list.h"
#include "core/registry.h"
#include "core/settings.h"
#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

/// A named preset: which layers are seen, in which order and looks, with which settings.
struct Bundle {
  std::string name;
  std::string help;                             ///< what it shows, and the paper
  Layer_list layers;                            ///< bottom to top; all others are switched off by it
  Settings settings;                            ///< those that it sets, also to their defaults; others stay as they are
  std::optional<View_2> view;                   ///< of a program in the plane; absent: the view stays
  std::optional<View_3> view_3;                 ///< of a program in space
  std::optional<Canvas_background> background;  ///< absent: it stays
  /// The digit that shows it; 0: none; absent: its place in the list, where no other bundle has that digit.
  std::optional<int> key;
  std::vector<std::string> needs;  ///< ids of inputs; without any of them it shows nothing. None: it can do with all
  Unknown_parts unknown;           ///< what it names that this program does not have
  bool operator==(const Bundle&) const = default;
};

/// What bundles change.
struct Arrangement {
  Settings settings;
  Layer_list layers;
  bool operator==(const Arrangement&) const = default;
};

/// What the arrangement becomes. Layers that the bundle does not have keep their looks, are switched off and go where
/// the registry has them.
Arrangement apply_bundle(const Bundle& bundle, const Registry& registry, const Arrangement& before);

/// The visible layers and the settings that are not at their defaults, or are limits and switches of these layers.
Bundle bundle_of(const Arrangement& arrangement, const Registry& registry, std::string name);

/// The name in kebab-case: "Scale axis, s = 1.2" is "scale-axis-s-1-2".
std::string bundle_id(std::string_view name);
/// The bundle of this name or id; null when there is none.
const Bundle* find_bundle(const std::vector<Bundle>& bundles, std::string_view name);
/// `name`, with a number behind it if one of the bundles has that name or its id.
std::string free_name(const std::vector<Bundle>& bundles, const std::string& name);

/// Of the digits 1 to this one each may show a bundle.
inline constexpr int most_bundle_keys = 9;
/// The digit that shows the bundle in this place of the list; 0 for none.
int key_of(const std::vector<Bundle>& bundles, std::size_t place);
/// The place of the bundle that the digit shows; absent for none.
std::optional<std::size_t> place_with_key(const std::vector<Bundle>& bundles, int key);
/// Gives the bundle in this place the digit, 0 for none, or none of its own; of two that are given the same the first
/// one loses it.
void give_key(std::vector<Bundle>& bundles, std::size_t place, std::optional<int> key);

/// Why a bundle with these `needs` has nothing to show of these inputs: "needs points or a mesh"; empty when there is
/// no such reason, and without any inputs.
std::string missing_input_text(const std::vector<std::string>& needs, const Inputs& inputs);

/// The text of a file of bundles: {"format": "mesecina-bundles", "version": 1, "dimension": 2, "bundles": [{"name":
/// ..., "help": ..., "layers": [...], "settings": {...}, "view": ..., "background": "dark", "key": 4, "needs":
/// ["points", ...]}]}; a bundle needs a name only.
std::string bundles_to_text(const std::vector<Bundle>& bundles, const Registry& registry);
/// Reads it; a bundle alone, without the frame, is read too. Throws std::invalid_argument with place, expected and
/// found for another text, another dimension and a version of the future.
std::vector<Bundle> parse_bundles(std::string_view text, const Registry& registry);

/// The bundles that come with the program of the registry's dimension, in their order.
std::vector<Bundle> shipped_bundles(const Registry& registry);

}  // namespace mesecina
