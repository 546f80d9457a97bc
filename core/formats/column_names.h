// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mesecina {

/// The lower-case names of the columns if the fields of a first line are only words, with or without double quotes;
/// else nothing.
std::vector<std::string> column_names(const std::vector<std::string_view>& fields);

/// "1 column", "3 columns".
std::string count_of_columns(std::size_t count);

}  // namespace mesecina
