// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/scene_json.h"
#include "core/layer_list.h"
#include "core/registry.h"
#include "core/settings.h"
#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

/// A named preset: which layers are seen, in which order and looks, with which settings.
struct Bundle {
  std::string name;
  std::string help;              ///< what it shows, and the paper
  Layer_list layers;             ///< bottom to top; all others are switched off by it
  Settings settings;             ///< those that it sets, also to their defaults; others stay as they are
  std::optional<View_2> view;    ///< of a program in the plane; absent: the view stays
  std::optional<View_3> view_3;  ///< of a program in space
  Unknown_parts unknown;         ///< what it names that this program does not have
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

/// The text of a file of bundles: {"format": "mesecina-bundles", "version": 1, "dimension": 2, "bundles": [{"name":
/// ..., "help": ..., "layers": [...], "settings": {...}, "view": ...}]}.
std::string bundles_to_text(const std::vector<Bundle>& bundles, const Registry& registry);
/// Reads it; a bundle alone, without the frame, is read too. Throws std::invalid_argument with place, expected and
/// found for another text, another dimension and a version of the future.
std::vector<Bundle> parse_bundles(std::string_view text, const Registry& registry);

/// The bundles that come with the program of the registry's dimension, in their order.
std::vector<Bundle> shipped_bundles(const Registry& registry);

}  // namespace mesecina
