// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/help_text.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace mesecina {

namespace {

bool is_id(std::string_view word) {
  return !word.empty() &&
         std::ranges::all_of(word, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

/// `name` gives what takes the place of an id and its braces; nullopt leaves them.
std::string named(std::string_view text, const std::function<std::optional<std::string>(std::string_view id)>& name) {
  std::string result;
  while (!text.empty()) {
    const auto open = text.find('{');
    const auto close = open == std::string_view::npos ? open : text.find('}', open);
    if (close == std::string_view::npos) break;
    const std::string_view id = text.substr(open + 1, close - open - 1);
    const std::optional<std::string> found = is_id(id) ? name(id) : std::nullopt;
    result += text.substr(0, open);
    result += found ? *found : std::string(text.substr(open, 1));
    text.remove_prefix(found ? close + 1 : open + 1);
  }
  return result.append(text);
}

}  // namespace

std::string with_labels(std::string_view text, const Registry& registry) {
  return named(text, [&](std::string_view id) -> std::optional<std::string> {
    const auto quoted = [](const std::string& label) { return "“" + label + "”"; };
    if (const Setting_spec* setting = registry.find_setting(id)) return quoted(setting->label);
    if (const Layer_spec* layer = registry.find_layer(id)) return quoted(layer->label);
    if (const Evolution_spec* evolution = registry.find_evolution(id)) return quoted(evolution->label);
    return std::nullopt;
  });
}

std::string with_ids(std::string_view text) {
  return named(text, [](std::string_view id) { return std::optional(std::string(id)); });
}

}  // namespace mesecina
