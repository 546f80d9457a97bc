// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/settings.h"

namespace mesecina {

/// The settings with this one changed; a default leaves them as if it had never been.
Settings with_value(const Settings& settings, const Setting_spec& spec, const Setting_value& value);

/// The number in the type of the setting: whole numbers lose what is behind the point.
Setting_value number_value(const Setting_spec& spec, double number);

}  // namespace mesecina
