// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/registry.h"

namespace mesecina {

// Helps, reasons and warnings have {ID} where they name a setting, layer or evolution: a window calls it by its label,
// the command line by its id. What stands in braces and is no id is left as it is.

/// "choose another {ball-source}" is "choose another “Ball source”". O(length of the text).
std::string with_labels(std::string_view text, const Registry& registry);
/// The same with "ball-source".
std::string with_ids(std::string_view text);

}  // namespace mesecina
