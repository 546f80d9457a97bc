// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/style_option.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/formats/number.h"
#include "core/registry.h"

namespace mesecina {

namespace {

/// One property: its name, what it expects, and a function that sets it and returns false for any other text.
struct Property {
  const char* name;
  const char* expected;
  bool (*set)(Style& style, std::string_view text);
};

std::optional<Color> parse_color(std::string_view text) {
  constexpr std::size_t short_form = 4;
  constexpr std::size_t long_form = 7;
  if ((text.size() != short_form && text.size() != long_form) || text[0] != '#') return {};
  std::string digits;
  for (const char digit : text.substr(1)) digits.append(text.size() == short_form ? 2 : 1, digit);
  std::array<std::uint8_t, 3> components{};
  for (std::size_t i = 0; i < components.size(); ++i) {
    const char* const begin = digits.data() + 2 * i;
    const auto [end, error] = std::from_chars(begin, begin + 2, components[i], 16);
    if (error != std::errc() || end != begin + 2) return {};
  }
  return Color{components[0], components[1], components[2]};
}

template <double Style::*member, int greatest>
bool set_number(Style& style, std::string_view text) {
  const auto number = parse_number(text);
  if (!number || !(*number >= 0 && *number <= greatest)) return false;
  style.*member = *number;
  return true;
}

template <std::optional<double> Style::*member>
bool set_limit(Style& style, std::string_view text) {
  const auto number = parse_number(text);
  if (!number && !text.empty()) return false;
  style.*member = number;
  return true;
}

template <bool Style::*member>
bool set_flag(Style& style, std::string_view text) {
  if (text != "true" && text != "false") return false;
  style.*member = text == "true";
  return true;
}

template <std::string Style::*member>
bool set_text(Style& style, std::string_view text) {
  style.*member = text;
  return true;
}

constexpr const char* size_expected = "a number of pixels from 0 to 100";
constexpr const char* flag_expected = "true or false";
constexpr const char* limit_expected = "a number (with a decimal point), or nothing";

constexpr std::array properties = {
    Property{"color", "a colour as #rrggbb",
             [](Style& style, std::string_view text) {
               const auto color = parse_color(text);
               if (color) style.color = *color;
               return color.has_value();
             }},
    Property{"opacity", "a number from 0 to 1", set_number<&Style::opacity, 1>},
    Property{"point-size", size_expected, set_number<&Style::point_size, 100>},
    Property{"line-width", size_expected, set_number<&Style::line_width, 100>},
    Property{"filled", flag_expected, set_flag<&Style::filled>},
    Property{"edges", flag_expected, set_flag<&Style::edges>},
    Property{"vertices", flag_expected, set_flag<&Style::vertices>},
    Property{"smooth", flag_expected, set_flag<&Style::smooth>},
    Property{"sliced", flag_expected, set_flag<&Style::sliced>},
    Property{"value", "a name", set_text<&Style::value>},
    Property{"color-map", "a name", set_text<&Style::color_map>},
    Property{"color-map-reversed", flag_expected, set_flag<&Style::color_map_reversed>},
    Property{"range-minimum", limit_expected, set_limit<&Style::range_minimum>},
    Property{"range-maximum", limit_expected, set_limit<&Style::range_maximum>},
    Property{"threshold-minimum", limit_expected, set_limit<&Style::threshold_minimum>},
    Property{"threshold-maximum", limit_expected, set_limit<&Style::threshold_maximum>},
};

[[noreturn]] void refuse_unknown(const std::string& kind, std::string_view name,
                                 const std::vector<std::string>& known) {
  const std::string suggestion = nearest_name(name, known);
  std::string text = "unknown " + kind + " '" + std::string(name) + "'";
  if (!suggestion.empty()) throw std::invalid_argument(text + "; did you mean '" + suggestion + "'?");
  text += "; expected one of";
  for (const std::string& entry : known) text += (&entry == known.data() ? " " : ", ") + entry;
  throw std::invalid_argument(text);
}

}  // namespace

std::vector<std::string> style_properties() {
  std::vector<std::string> names;
  names.reserve(properties.size());
  for (const Property& property : properties) names.emplace_back(property.name);
  return names;
}

void set_style_property(Style& style, std::string_view property, std::string_view text,
                        const std::vector<std::string>& color_maps) {
  const auto* const found = std::ranges::find(properties, property, &Property::name);
  if (found == properties.end()) refuse_unknown("property of a style", property, style_properties());
  if (property == "color-map" && std::ranges::find(color_maps, text) == color_maps.end())
    refuse_unknown("colour map", text, color_maps);
  if (!found->set(style, text))
    throw std::invalid_argument(std::string(property) + ": expected " + found->expected + ", found '" +
                                std::string(text) + "'");
}

}  // namespace mesecina
