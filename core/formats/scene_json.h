// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/layer_list.h"
#include "core/registry.h"
#include "core/settings.h"
#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

// The parts of a scene as JSON, for bundles and sessions. Keys are sorted and numbers read back as they were; numbers
// that JSON has none for are the texts "inf", "-inf" and "nan".
//
// The functions that read take `path`, where in its file the JSON stands ("bundles[2].layers"). They throw
// std::invalid_argument for what cannot be meant, with the path, what was expected and what was found.

/// What was read without being understood: no reason to stop, and nothing that may get lost.
struct Unknown_parts {
  std::vector<std::string> notes;               ///< a sentence each, for the user
  std::map<std::string, std::string> layers;    ///< by id, the JSON of entries of `layers` that name no layer
  std::map<std::string, std::string> settings;  ///< by id, the JSON of values of settings that there are none of
  bool operator==(const Unknown_parts&) const = default;
};

/// All properties of the look but `visible`, named as those of --style.
nlohmann::json style_to_json(const Style& style);
/// The same, without the properties that are as in `usual`.
nlohmann::json style_to_json(const Style& style, const Style& usual);
/// `usual` with the properties that the object has. A property of another name gives a note.
Style style_from_json(const nlohmann::json& json, Style usual, const std::string& path, Unknown_parts& unknown);

/// {"id": value, ...}: booleans, numbers and texts. Numbers that are no integers have a decimal point or an exponent.
nlohmann::json settings_to_json(const Settings& settings, const std::map<std::string, std::string>& unknown = {});
/// Values are checked: type, range, choices.
Settings settings_from_json(const nlohmann::json& json, const Registry& registry, const std::string& path,
                            Unknown_parts& unknown);

/// [{"id": ..., "visible": true, "style": {...}}, ...] bottom to top, with whole looks, and then the `unknown` ones.
nlohmann::json layers_to_json(const Layer_list& layers, const std::map<std::string, std::string>& unknown = {});
/// The layers listed, in their order; "visible" may be absent for true, "style" for the usual look, and so may any
/// property in it. A layer may be listed once.
Layer_list layers_from_json(const nlohmann::json& json, const Registry& registry, const std::string& path,
                            Unknown_parts& unknown);

/// {"center": [x, y], "scale": logical pixels per unit}: also a view file of the plane.
nlohmann::json view_to_json(const View_2& view);
/// A positive, finite scale and a finite center, or a throw.
View_2 view_2_from_json(const nlohmann::json& json, const std::string& path);
/// What the view files of space hold.
nlohmann::json view_to_json(const View_3& view);
View_3 view_3_from_json(const nlohmann::json& json, const std::string& path);

/// "#rrggbb".
std::string color_to_text(const Color& color);
Color color_from_json(const nlohmann::json& json, const std::string& path);

/// Throws std::invalid_argument: "PATH: expected EXPECTED, found ..." with a short form of the JSON.
[[noreturn]] void refuse_json(const nlohmann::json& found, const std::string& path, const std::string& expected);

}  // namespace mesecina
