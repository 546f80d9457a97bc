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
  for (const auto& part : json.items()) {
    constexpr std::array known = {"name", "help", "layers", "settings", "view"};
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
  return json;
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
