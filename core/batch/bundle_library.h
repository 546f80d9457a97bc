// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/bundle.h"

namespace mesecina {

/// Where a program ("mesecina2d") keeps its user's list of bundles: mesecina/PROGRAM-bundles.json in $XDG_DATA_HOME or
/// else ~/.local/share. Empty where the system names neither. The file is there only when the list was changed.
std::filesystem::path user_bundle_file(std::string_view program);

/// A bundle that a program knows by its name.
struct Known_bundle {
  enum class Origin {
    shipped,  ///< as it came with the program
    changed,  ///< the user's, in place of the one that came with the program
    own       ///< the user's alone
  };
  Bundle bundle;
  Origin origin = Origin::shipped;
};

/// The user's list, in its order, and then what came with the program and the user has taken from the list. No two have
/// the same id: of equal ones the user's is known.
struct Bundle_library {
  std::vector<Known_bundle> bundles;
  std::string problem;  ///< why the user's list cannot be read, with its file; those that are shipped are known then
};

/// Reads the user's list, if the file is there.
Bundle_library read_bundle_library(const std::filesystem::path& user_file, const Registry& registry);

}  // namespace mesecina
