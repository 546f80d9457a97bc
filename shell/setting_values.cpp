// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/setting_values.h"

namespace mesecina {

Settings with_value(const Settings& settings, const Setting_spec& spec, const Setting_value& value) {
  return value == spec.default_value ? settings.without(spec.id) : settings.with(spec.id, value);
}

Setting_value number_value(const Setting_spec& spec, double number) {
  if (std::holds_alternative<std::int64_t>(spec.default_value)) return static_cast<std::int64_t>(number);
  return number;
}

}  // namespace mesecina
