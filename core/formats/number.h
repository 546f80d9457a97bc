// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mesecina {

/// Shortest text that reads back to the same double, C locale; "inf", "-inf", "nan" for the others.
std::string format_number(double value);
/// Appends what format_number returns.
void append_number(std::string& text, double value);
/// The whole of `text` as a finite or infinite double, C locale; nullopt otherwise. Accepts a leading '+'.
std::optional<double> parse_number(std::string_view text);

}  // namespace mesecina
