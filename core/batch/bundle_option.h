// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/batch/command_line.h"
#include "core/bundle.h"

namespace mesecina {

/// The bundles of a file, `.bnd` or JSON. Throws File_error.
std::vector<Bundle> read_bundle_file(const std::filesystem::path& file, const Registry& registry);

/// The bundle that --bundle means: one of the library of `user_file`, by name or id; with "shipped:" before the name as
/// it came with the program, whatever the user made of it; or of a file of bundles or `.bnd` file its first, or
/// FILE#NAME. Adds to `warnings` when it is not the shipped one of that name, and when the user's list cannot be read.
/// Throws File_error, or std::invalid_argument that says what is wrong, of an unknown name with the nearest one.
Bundle read_bundle_option(const std::string& text, const Registry& registry, const std::filesystem::path& user_file,
                          std::vector<std::string>& warnings);

/// Gives the command line the bundle's layers in their order, looks, settings, view and background, and its notes as
/// warnings. What was in the command line before goes.
void take_bundle(Command_line& command_line, const Bundle& bundle, const Registry& registry);

}  // namespace mesecina
