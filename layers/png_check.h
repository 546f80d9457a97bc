// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace mesecina {

/// Throws File_error when the file starts as a PNG but its chunks are cut short or damaged: the decoder itself would
/// say so on stderr, and decode the rest as black. Files of other formats pass.
void check_png(const std::filesystem::path& file);

}  // namespace mesecina
