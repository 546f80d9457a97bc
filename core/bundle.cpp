// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bundle.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/formats/json_text.h"
#include "core/shipped_bundle_files.h"

namespace mesecina {

namespace {

using Json = nlohmann::json;

constexpr const char* format_name = "mesecina-bundles";
constexpr int newest_version = 1;

std::string text_in(const Json& json, const char* key, const std::string& path) {
  const auto found = json.find(key);
  if (found == json.end()) return {};
  if (!found->is_string()) refuse_json(*found, path + "." + key, "a text");
  return found->get<std::string>();
}

Bundle bundle_from_json(const Json& json, const Registry& registry, const std::string& path) {
  if (!json.is_object()) refuse_json(json, path, "an object with \"name\" and \"layers\"");
  Bundle bundle;
  bundle.name = text_in(json, "name", path);
  if (bundle.name.empty()) throw std::invalid_argument(path + ".name: expected a text, found nothing");
  bundle.help = text_in(json, "help", path);
  if (const auto found = json.find("layers"); found != json.end())
    bundle.layers = layers_from_json(*found, registry, path + ".layers", bundle.unknown);
  if (const auto found = json.find("settings"); found != json.end())
    bundle.settings = settings_from_json(*found, registry, path + ".settings", bundle.unknown);
  if (const auto found = json.find("view"); found != json.end()) {
    if (registry.dimension() == 3)
      bundle.view_3 = view_3_from_json(*found, path + ".view");
    else
      bundle.view = view_2_from_json(*found, path + ".view");
  }
  if (const std::string name = text_in(json, "background", path); !name.empty()) {
    bundle.background = background_named(name);
    if (!bundle.background) refuse_json(name, path + ".background", "\"paper\", \"dark\", \"window\" or \"none\"");
  }
  if (const auto found = json.find("key"); found != json.end()) {
    if (!found->is_number_integer() || *found < 0 || *found > most_bundle_keys)
      refuse_json(*found, path + ".key", "a digit, 0 for no key");
    bundle.key = found->get<int>();
  }
  if (const auto found = json.find("needs"); found != json.end()) {
    if (!found->is_array()) refuse_json(*found, path + ".needs", "an array of inputs");
    for (const Json& input : *found) {
      if (!input.is_string()) refuse_json(input, path + ".needs", "texts");
      bundle.needs.push_back(input.get<std::string>());
    }
  }
  for (const auto& part : json.items()) {
    constexpr std::array known = {"name", "help", "layers", "settings", "view", "background", "key", "needs"};
    if (std::ranges::find(known, part.key()) == known.end())
      bundle.unknown.notes.push_back(path + ": '" + part.key() + "' means nothing");
  }
  return bundle;
}

Json to_json(const Bundle& bundle) {
  Json json;
  json["name"] = bundle.name;
  json["help"] = bundle.help;
  json["layers"] = layers_to_json(bundle.layers, bundle.unknown.layers);
  json["settings"] = settings_to_json(bundle.settings, bundle.unknown.settings);
  if (bundle.view) json["view"] = view_to_json(*bundle.view);
  if (bundle.view_3) json["view"] = view_to_json(*bundle.view_3);
  if (bundle.background) json["background"] = name_of(*bundle.background);
  if (bundle.key) json["key"] = *bundle.key;
  if (!bundle.needs.empty()) json["needs"] = bundle.needs;
  return json;
}

/// With its article.
std::string input_name(const std::string& id) {
  if (id == cloud_input.id) return "points";
  const bool is_one = id == mesh_input.id || id == outline_input.id || id == image_input.id;
  return is_one ? (id == mesh_input.id ? "a " : "an ") + id : id;
}

/// The same in the newest version. Before version 1 files were a bare list, or one bundle.
Json migrated(Json json) {
  if (json.is_array()) return {{"format", format_name}, {"version", newest_version}, {"bundles", std::move(json)}};
  if (json.is_object() && !json.contains("format") && json.contains("name"))
    return migrated(Json::array({std::move(json)}));
  return json;
}

}  // namespace

Arrangement apply_bundle(const Bundle& bundle, const Registry& registry, const Arrangement& before) {
  Arrangement after{before.settings, with_missing_layers(bundle.layers, registry)};
  for (Layer_entry& layer : after.layers) {
    if (find_entry(bundle.layers, layer.id)) continue;
    if (const Layer_entry* old = find_entry(before.layers, layer.id)) layer.style = old->style;
    layer.style.visible = false;
  }
  for (const auto& entry : bundle.settings.changed()) {
    const Setting_spec* spec = registry.find_setting(entry.first);
    after.settings = spec && spec->default_value == entry.second ? after.settings.without(entry.first)
                                                                 : after.settings.with(entry.first, entry.second);
  }
  return after;
}

Bundle bundle_of(const Arrangement& arrangement, const Registry& registry, std::string name) {
  Bundle bundle;
  bundle.name = std::move(name);
  bundle.settings = arrangement.settings;
  for (const Layer_entry& layer : arrangement.layers) {
    const Layer_spec* spec = registry.find_layer(layer.id);
    if (!spec || !layer.style.visible) continue;
    bundle.layers.push_back(layer);
    for (const std::string& setting : {spec->cut_setting, spec->cut_switch}) {
      if (!setting.empty())
        bundle.settings = bundle.settings.with(setting, registry.value(arrangement.settings, setting));
    }
  }
  return bundle;
}

std::string bundle_id(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool is_upper = c >= 'A' && c <= 'Z';
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
    if (is_upper)
      id += static_cast<char>(c - 'A' + 'a');
    else if (is_plain)
      id += c;
    else if (!id.empty() && id.back() != '-')
      id += '-';
  }
  while (!id.empty() && id.back() == '-') id.pop_back();
  return id;
}

const Bundle* find_bundle(const std::vector<Bundle>& bundles, std::string_view name) {
  auto found = std::ranges::find(bundles, name, &Bundle::name);
  if (found == bundles.end())
    found = std::ranges::find_if(bundles, [&](const Bundle& bundle) { return bundle_id(bundle.name) == name; });
  return found == bundles.end() ? nullptr : &*found;
}

std::string free_name(const std::vector<Bundle>& bundles, const std::string& name) {
  const auto is_taken = [&](const std::string& candidate) {
    return std::ranges::any_of(bundles,
                               [id = bundle_id(candidate)](const Bundle& b) { return bundle_id(b.name) == id; });
  };
  std::string candidate = name;
  for (int i = 2; is_taken(candidate); ++i) candidate = name + " " + std::to_string(i);
  return candidate;
}

int key_of(const std::vector<Bundle>& bundles, std::size_t place) {
  for (int key = 1; key <= most_bundle_keys; ++key)
    if (place_with_key(bundles, key) == place) return key;
  return 0;
}

std::optional<std::size_t> place_with_key(const std::vector<Bundle>& bundles, int key) {
  if (key < 1 || key > most_bundle_keys) return std::nullopt;
  for (std::size_t place = 0; place < bundles.size(); ++place)
    if (bundles[place].key == key) return place;
  const std::size_t usual = static_cast<std::size_t>(key) - 1;
  if (usual < bundles.size() && !bundles[usual].key) return usual;
  return std::nullopt;
}

void give_key(std::vector<Bundle>& bundles, std::size_t place, std::optional<int> key) {
  for (Bundle& bundle : bundles)
    if (key && *key > 0 && bundle.key == key) bundle.key.reset();
  bundles.at(place).key = key;
}

std::string missing_input_text(const std::vector<std::string>& needs, const Inputs& inputs) {
  const auto is_there = [&](const std::string& id) { return inputs.identity(id) != nullptr; };
  if (inputs.is_empty() || needs.empty() || std::ranges::any_of(needs, is_there)) return {};
  std::string text;
  for (const std::string& id : needs)
    text += (text.empty() ? "needs " : &id == &needs.back() ? " or " : ", ") + input_name(id);
  return text;
}

std::string bundles_to_text(const std::vector<Bundle>& bundles, const Registry& registry) {
  Json json{{"format", format_name}, {"version", newest_version}, {"dimension", registry.dimension()}};
  json["bundles"] = Json::array();
  for (const Bundle& bundle : bundles) json["bundles"].push_back(to_json(bundle));
  constexpr int indent = 2;
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<Bundle> parse_bundles(std::string_view text, const Registry& registry) {
  const Json json = migrated(parse_json(text));
  if (!json.is_object() || json.value("format", Json()) != format_name)
    refuse_json(json, "the file", "bundles: {\"format\": \"mesecina-bundles\", ...}");
  const Json version = json.value("version", Json());
  if (!version.is_number_integer() || version < 1) refuse_json(version, "version", "an integer from 1 on");
  if (version > newest_version)
    refuse_json(version, "version", "at most " + std::to_string(newest_version) + ", as a newer program wrote this");
  const Json dimension = json.value("dimension", Json(registry.dimension()));
  if (dimension != registry.dimension())
    refuse_json(dimension, "dimension", std::to_string(registry.dimension()) + ", for bundles of this program");
  const Json list = json.value("bundles", Json());
  if (!list.is_array()) refuse_json(list, "bundles", "an array of bundles");
  std::vector<Bundle> bundles;
  for (std::size_t i = 0; i < list.size(); ++i) {
    bundles.push_back(bundle_from_json(list[i], registry, "bundles[" + std::to_string(i) + "]"));
  }
  return bundles;
}

std::vector<Bundle> shipped_bundles(const Registry& registry) {
  std::vector<Bundle> bundles;
  for (const std::string_view file : shipped_bundle_files(registry.dimension())) {
    for (Bundle& bundle : parse_bundles(file, registry)) bundles.push_back(std::move(bundle));
  }
  return bundles;
}

}  // namespace mesecina
