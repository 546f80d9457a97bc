// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/scene_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "core/formats/number.h"

namespace mesecina {

namespace {

using Json = nlohmann::json;

Json number_to_json(double number) { return std::isfinite(number) ? Json(number) : Json(format_number(number)); }

std::optional<double> number_in(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (!json.is_string()) return {};
  const auto& text = json.get_ref<const std::string&>();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  return text == "inf" || text == "-inf" ? parse_number(text) : std::nullopt;
}

double number_between(const Json& json, const std::string& path, double greatest) {
  const auto number = number_in(json);
  if (!number || !(*number >= 0 && *number <= greatest))
    refuse_json(json, path, "a number from 0 to " + format_number(greatest));
  return *number;
}

/// Calls visit(name, member) for each property of a look.
template <class Visit>
void for_each_property(const Visit& visit) {
  visit("color", &Style::color);
  visit("opacity", &Style::opacity);
  visit("point-size", &Style::point_size);
  visit("line-width", &Style::line_width);
  visit("filled", &Style::filled);
  visit("edges", &Style::edges);
  visit("vertices", &Style::vertices);
  visit("smooth", &Style::smooth);
  visit("sliced", &Style::sliced);
  visit("value", &Style::value);
  visit("color-map", &Style::color_map);
  visit("color-map-reversed", &Style::color_map_reversed);
  visit("range-minimum", &Style::range_minimum);
  visit("range-maximum", &Style::range_maximum);
  visit("threshold-minimum", &Style::threshold_minimum);
  visit("threshold-maximum", &Style::threshold_maximum);
}

Json property_to_json(const Color& color) { return color_to_text(color); }
Json property_to_json(double number) { return number_to_json(number); }
Json property_to_json(bool flag) { return flag; }
Json property_to_json(const std::string& text) { return text; }
Json property_to_json(const std::optional<double>& limit) { return limit ? number_to_json(*limit) : Json(); }

void read_property(const Json& json, const std::string& path, Color& color) { color = color_from_json(json, path); }
void read_property(const Json& json, const std::string& path, double& number) {
  constexpr double greatest_size = 100;
  const bool is_opacity = path.ends_with(".opacity");
  number = number_between(json, path, is_opacity ? 1 : greatest_size);
}
void read_property(const Json& json, const std::string& path, bool& flag) {
  if (!json.is_boolean()) refuse_json(json, path, "true or false");
  flag = json.get<bool>();
}
void read_property(const Json& json, const std::string& path, std::string& text) {
  if (!json.is_string()) refuse_json(json, path, "a text");
  text = json.get<std::string>();
}
void read_property(const Json& json, const std::string& path, std::optional<double>& limit) {
  limit = json.is_null() ? std::nullopt : number_in(json);
  if (!limit && !json.is_null()) refuse_json(json, path, "a number, or null for none");
}

std::vector<std::string> property_names() {
  std::vector<std::string> names;
  for_each_property([&](const char* name, auto) { names.emplace_back(name); });
  return names;
}

std::string suggestion_for(std::string_view name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

template <class Specs>
std::vector<std::string> ids_of(const Specs& specs) {
  std::vector<std::string> ids;
  ids.reserve(specs.size());
  for (const auto& spec : specs) ids.push_back(spec.id);
  return ids;
}

Json setting_to_json(const Setting_value& value) {
  if (const auto* number = std::get_if<double>(&value)) return number_to_json(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
  if (const auto* flag = std::get_if<bool>(&value)) return *flag;
  return std::get<std::string>(value);
}

Setting_value setting_from_json(const Json& json, const Setting_spec& spec, const std::string& path) {
  Setting_value value;
  if (std::holds_alternative<bool>(spec.default_value)) {
    if (!json.is_boolean()) refuse_json(json, path, "true or false");
    value = json.get<bool>();
  } else if (std::holds_alternative<std::int64_t>(spec.default_value)) {
    if (!json.is_number_integer()) refuse_json(json, path, "an integer");
    value = json.get<std::int64_t>();
  } else if (std::holds_alternative<double>(spec.default_value)) {
    const auto number = number_in(json);
    if (!number) refuse_json(json, path, "a number");
    value = *number;
  } else {
    if (!json.is_string()) refuse_json(json, path, "a text");
    value = json.get<std::string>();
  }
  try {
    check_setting(spec, value);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
  return value;
}

const Json& require(const Json& object, const char* key, const std::string& path) {
  const auto found = object.find(key);
  if (found == object.end()) throw std::invalid_argument(path + "." + key + ": expected, found nothing");
  return *found;
}

}  // namespace

void refuse_json(const Json& found, const std::string& path, const std::string& expected) {
  constexpr std::size_t longest = 40;
  std::string text = found.dump(-1, ' ', true, Json::error_handler_t::replace);
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  throw std::invalid_argument(path + ": expected " + expected + ", found " + text);
}

std::string color_to_text(const Color& color) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const unsigned component : {color.red, color.green, color.blue}) {
    text += digits[component / 16];
    text += digits[component % 16];
  }
  return text;
}

Color color_from_json(const Json& json, const std::string& path) {
  constexpr std::size_t length = 7;
  const std::string text = json.is_string() ? json.get<std::string>() : "";
  unsigned number = 0;
  const auto [end, error] =
      std::from_chars(text.data() + (text.empty() ? 0 : 1), text.data() + text.size(), number, 16);
  if (text.size() != length || text[0] != '#' || error != std::errc() || end != text.data() + length)
    refuse_json(json, path, "a colour as \"#rrggbb\"");
  const auto component = [number](unsigned shift) { return static_cast<std::uint8_t>(number >> shift & 0xff); };
  return {component(16), component(8), component(0)};
}

Json style_to_json(const Style& style) {
  Json json = Json::object();
  for_each_property([&](const char* name, auto member) { json[name] = property_to_json(style.*member); });
  return json;
}

Json style_to_json(const Style& style, const Style& usual) {
  Json json = Json::object();
  for_each_property([&](const char* name, auto member) {
    if (style.*member != usual.*member) json[name] = property_to_json(style.*member);
  });
  return json;
}

Style style_from_json(const Json& json, Style usual, const std::string& path, Unknown_parts& unknown) {
  if (!json.is_object()) refuse_json(json, path, "an object with properties of a look");
  const std::vector<std::string> names = property_names();
  for (const auto& property : json.items()) {
    if (std::ranges::find(names, property.key()) == names.end())
      unknown.notes.push_back(path + ": there is no property '" + property.key() + "'" +
                              suggestion_for(property.key(), names));
  }
  for_each_property([&](const char* name, auto member) {
    if (const auto found = json.find(name); found != json.end())
      read_property(*found, path + "." + name, usual.*member);
  });
  return usual;
}

Json settings_to_json(const Settings& settings, const std::map<std::string, std::string>& unknown) {
  Json json = Json::object();
  for (const auto& entry : unknown) json[entry.first] = Json::parse(entry.second);
  for (const auto& entry : settings.changed()) json[entry.first] = setting_to_json(entry.second);
  return json;
}

Settings settings_from_json(const Json& json, const Registry& registry, const std::string& path,
                            Unknown_parts& unknown) {
  if (!json.is_object()) refuse_json(json, path, "an object with values of settings");
  Settings settings;
  for (const auto& entry : json.items()) {
    const std::string& id = entry.key();
    const Setting_spec* spec = registry.find_setting(id);
    if (spec) {
      settings = settings.with(id, setting_from_json(entry.value(), *spec, path + "." + id));
    } else {
      unknown.settings[id] = entry.value().dump();
      unknown.notes.push_back(path + ": there is no setting '" + id + "'" +
                              suggestion_for(id, ids_of(registry.settings())));
    }
  }
  return settings;
}

Json layers_to_json(const Layer_list& layers, const std::map<std::string, std::string>& unknown) {
  Json json = Json::array();
  for (const Layer_entry& layer : layers)
    json.push_back({{"id", layer.id}, {"visible", layer.style.visible}, {"style", style_to_json(layer.style)}});
  for (const auto& entry : unknown) json.push_back(Json::parse(entry.second));
  return json;
}

Layer_list layers_from_json(const Json& json, const Registry& registry, const std::string& path,
                            Unknown_parts& unknown) {
  if (!json.is_array()) refuse_json(json, path, "an array of layers");
  Layer_list layers;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Json& entry = json[i];
    const std::string here = path + "[" + std::to_string(i) + "]";
    if (!entry.is_object()) refuse_json(entry, here, "an object with the \"id\" of a layer");
    const Json& id_json = require(entry, "id", here);
    if (!id_json.is_string()) refuse_json(id_json, here + ".id", "a text");
    const std::string id = id_json.get<std::string>();
    const Layer_spec* spec = registry.find_layer(id);
    if (!spec) {
      unknown.layers[id] = entry.dump();
      unknown.notes.push_back(here + ": there is no layer '" + id + "'" +
                              suggestion_for(id, ids_of(registry.layers())));
      continue;
    }
    if (find_entry(layers, id)) refuse_json(id_json, here + ".id", "each layer once");
    Style style = spec->style;
    if (const auto found = entry.find("style"); found != entry.end())
      style = style_from_json(*found, style, here + ".style", unknown);
    style.visible = true;
    if (const auto found = entry.find("visible"); found != entry.end())
      read_property(*found, here + ".visible", style.visible);
    for (const auto& part : entry.items()) {
      if (part.key() != "id" && part.key() != "visible" && part.key() != "style")
        unknown.notes.push_back(here + ": '" + part.key() + "' means nothing" +
                                suggestion_for(part.key(), {"id", "visible", "style"}));
    }
    layers.push_back({id, style});
  }
  return layers;
}

Json view_to_json(const View_2& view) { return {{"center", {view.center.x, view.center.y}}, {"scale", view.scale}}; }

View_2 view_2_from_json(const Json& json, const std::string& path) {
  if (!json.is_object()) refuse_json(json, path, "a view: {\"center\": [x, y], \"scale\": pixels per unit}");
  const Json& center = require(json, "center", path);
  const Json& scale = require(json, "scale", path);
  const auto is_finite = [](const Json& number) { return number.is_number() && std::isfinite(number.get<double>()); };
  if (!center.is_array() || center.size() != 2 || !std::ranges::all_of(center, is_finite))
    refuse_json(center, path + ".center", "two finite numbers [x, y]");
  if (!is_finite(scale) || !(scale.get<double>() > 0)) refuse_json(scale, path + ".scale", "a positive number");
  return {{center[0].get<double>(), center[1].get<double>()}, scale.get<double>()};
}

Json view_to_json(const View_3& view) { return Json::parse(to_json(view)); }

View_3 view_3_from_json(const Json& json, const std::string& path) {
  try {
    return parse_view_3(json.dump());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(path + ": " + error.what());
  }
}

}  // namespace mesecina
