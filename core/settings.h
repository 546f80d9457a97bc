// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace mesecina {

using Setting_value = std::variant<bool, std::int64_t, double, std::string>;

/// Everything the panel, --set, session files and the manual need to know of one setting, declared once.
struct Setting_spec {
  std::string id;     ///< kebab-case, unique in the registry
  std::string label;  ///< a few words, shown in the window
  std::string help;   ///< definition, what a larger value does, the paper
  std::string unit;   ///< "degrees", "fraction of the diagonal", ""
  Setting_value default_value;
  double minimum = -std::numeric_limits<double>::infinity();  ///< for numbers
  double maximum = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices;  ///< for texts: the only values allowed, any if empty
  std::vector<std::string> tags;
};

/// Typed handle of a setting; T is bool, std::int64_t, double or std::string.
template <class T>
struct Setting {
  std::string_view id;
};

/// Values of settings that differ from their defaults. A value type; the registry knows the defaults.
class Settings {
 public:
  /// Null when the setting has its default.
  const Setting_value* find(std::string_view id) const {
    const auto it = values_.find(id);
    return it == values_.end() ? nullptr : &it->second;
  }
  [[nodiscard]] Settings with(std::string_view id, Setting_value value) const {
    Settings result = *this;
    result.values_.insert_or_assign(std::string(id), std::move(value));
    return result;
  }
  [[nodiscard]] Settings without(std::string_view id) const {
    Settings result = *this;
    if (const auto it = result.values_.find(id); it != result.values_.end()) result.values_.erase(it);
    return result;
  }
  const std::map<std::string, Setting_value, std::less<>>& changed() const { return values_; }
  bool operator==(const Settings&) const = default;

 private:
  std::map<std::string, Setting_value, std::less<>> values_;
};

/// Reads `text` as a value of the setting's type within its range and choices.
/// Throws std::invalid_argument with a sentence naming the setting, what was expected and what was found.
Setting_value parse_setting(const Setting_spec& spec, std::string_view text);
/// Throws as parse_setting when the value has the wrong type or lies out of range.
void check_setting(const Setting_spec& spec, const Setting_value& value);
/// C locale, shortest form that reads back to the same value.
std::string to_text(const Setting_value& value);

}  // namespace mesecina
