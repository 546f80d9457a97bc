// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace mesecina {

/// The bytes as a zlib stream. The result depends only on the bytes.
std::string deflated(std::string_view bytes);
/// What was deflated. Throws std::invalid_argument when it is no complete zlib stream or holds more than `most` bytes.
std::string inflated(std::string_view stream, std::size_t most);

/// Base 64, with padding, on one line.
std::string to_base64(std::string_view bytes);
/// Reads it. Throws std::invalid_argument for anything else.
std::string from_base64(std::string_view text);

}  // namespace mesecina
