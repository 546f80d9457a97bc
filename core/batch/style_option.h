// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/style.h"

namespace mesecina {

/// What --style can change of a layer's look: color, opacity, point-size, ... in the order of Style.
std::vector<std::string> style_properties();

/// Sets the property to what the text says: colours as #rrggbb or #rgb, numbers with a decimal point, true or false,
/// names as they are; empty for no limit and no value. Throws std::invalid_argument with a sentence that says what
/// was expected and what was found, for an unknown property or a colour map that is not among these with the nearest
/// name. Whether a layer has the value named is not known here.
void set_style_property(Style& style, std::string_view property, std::string_view text,
                        const std::vector<std::string>& color_maps);

}  // namespace mesecina
