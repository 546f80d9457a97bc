// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "core/inputs.h"

namespace mesecina {

/// Whether append_input_json can write the input of this id: one of a type of core/inputs.h.
bool has_input_json(const Inputs& inputs, std::string_view id);

/// Appends the input of this id as JSON. Numbers are flat lists, one element per line, in the C locale and in the
/// shortest form that reads back to the same double (infinities and NaN as texts); pixels are base 64 of a zlib stream.
/// An input whose id is none of core/inputs.h is {"type": that of them with the same type, "value": ...}.
/// Throws std::invalid_argument where has_input_json is false. O(size).
void append_input_json(std::string& text, const Inputs& inputs, std::string_view id);

/// Whether with_input_json knows what the JSON under this id is.
bool is_input_json(std::string_view id, const nlohmann::json& json);

/// `inputs` with what append_input_json wrote under this id. Throws std::invalid_argument, with the place within the
/// JSON, what was expected and what was found, for anything else: wrong counts, corners that are no vertices, pixels
/// that do not fill the picture.
Inputs with_input_json(const Inputs& inputs, std::string_view id, const nlohmann::json& json);

/// `inputs` with the input of this id that `source` has, the very same value. Throws as append_input_json.
Inputs with_input_of(const Inputs& inputs, std::string_view id, const Inputs& source);

}  // namespace mesecina
