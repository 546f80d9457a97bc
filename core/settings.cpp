// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "core/formats/number.h"

namespace mesecina {

namespace {

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

[[noreturn]] void refuse(const Setting_spec& spec, const std::string& expected, std::string_view found) {
  throw std::invalid_argument("setting " + spec.id + ": expected " + expected + ", found '" + std::string(found) + "'");
}

std::string range_text(const Setting_spec& spec) {
  std::string text;
  if (std::isfinite(spec.minimum)) text += " >= " + format_number(spec.minimum);
  if (std::isfinite(spec.maximum)) text += (text.empty() ? " <= " : " and <= ") + format_number(spec.maximum);
  return text;
}

}  // namespace

void check_setting(const Setting_spec& spec, const Setting_value& value) {
  if (value.index() != spec.default_value.index()) refuse(spec, "a value of the type of its default", to_text(value));
  const auto check_range = [&](double number) {
    if (!(number >= spec.minimum && number <= spec.maximum))
      refuse(spec, "a number" + range_text(spec), to_text(value));
  };
  if (const auto* number = std::get_if<double>(&value)) check_range(*number);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) check_range(static_cast<double>(*integer));
  if (const auto* text = std::get_if<std::string>(&value)) {
    if (!spec.choices.empty() && std::ranges::find(spec.choices, *text) == spec.choices.end())
      refuse(spec, "one of " + join(spec.choices), *text);
  }
}

Setting_value parse_setting(const Setting_spec& spec, std::string_view text) {
  Setting_value value;
  if (std::holds_alternative<bool>(spec.default_value)) {
    if (text == "true" || text == "on" || text == "yes" || text == "1") {
      value = true;
    } else if (text == "false" || text == "off" || text == "no" || text == "0") {
      value = false;
    } else {
      refuse(spec, "true or false", text);
    }
  } else if (std::holds_alternative<std::int64_t>(spec.default_value)) {
    std::int64_t integer = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), integer);
    if (error != std::errc() || end != text.data() + text.size()) refuse(spec, "an integer", text);
    value = integer;
  } else if (std::holds_alternative<double>(spec.default_value)) {
    const auto number = parse_number(text);
    if (!number) refuse(spec, "a number" + range_text(spec) + " (with a decimal point)", text);
    value = *number;
  } else {
    value = std::string(text);
  }
  check_setting(spec, value);
  return value;
}

std::string to_text(const Setting_value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* number = std::get_if<double>(&value)) return format_number(*number);
  return std::get<std::string>(value);
}

}  // namespace mesecina
