// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string_view>

#include "core/inputs.h"

namespace mesecina {

// Inputs as they are in memory, for files that are written often and must be there soon: some ten times faster than
// JSON, and half as large. A file of another byte order is refused, and so is a damaged one: it ends with a checksum.

/// Writes the input of this id, one that has_input_json. Throws std::invalid_argument for others.
void write_input_bytes(std::ostream& stream, const Inputs& inputs, std::string_view id);

/// Whether this is what write_input_bytes writes, or the beginning of it.
bool is_input_bytes(std::string_view bytes);

/// `inputs` with what write_input_bytes wrote under this id. Throws std::invalid_argument, with what was expected and
/// what was found, for anything else.
Inputs with_input_bytes(const Inputs& inputs, std::string_view id, std::string_view bytes);

}  // namespace mesecina
