// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "core/registry.h"
#include "core/settings.h"

namespace mesecina {

/// Values of some settings as a file has them.
struct Settings_file {
  std::vector<std::string> ids;    ///< that the file names, and that there are
  Settings settings;               ///< of those, the values that are no defaults
  std::vector<std::string> notes;  ///< a line each on what else the file has
};

/// Writes the values that these settings have, also those that are defaults. Throws std::out_of_range for an id that
/// there is not. {"format": "mesecina-settings", "version": 1, "settings": {"delta": 0.01, ...}}
void write_settings_file(std::ostream& stream, const Registry& registry, const Settings& settings,
                         const std::vector<std::string>& ids);

/// Throws File_error for what is no such file, is newer than this program, or has a value that its setting cannot have.
/// A setting of another name gives a note.
Settings_file read_settings_file(const std::filesystem::path& file, const Registry& registry);

/// `settings` with what the file says.
Settings with_settings_of(const Settings_file& file, const Settings& settings);

}  // namespace mesecina
