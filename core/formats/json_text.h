// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace mesecina {

/// The JSON that a text holds. Throws std::invalid_argument, with the line and the byte, for other text, and for lists
/// and objects within each other deeper than any file of this program: writing them again would exhaust the stack.
nlohmann::json parse_json(std::string_view text);

}  // namespace mesecina
