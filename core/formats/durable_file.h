// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>

namespace mesecina {

/// As write_file, and when it returns the file is on the disk, not only in the memory of the system: it is there also
/// after the power fails. Costs a wait for the disk. Throws File_error.
void write_file_durably(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

}  // namespace mesecina
