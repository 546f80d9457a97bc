// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/bundle_library.h"

#include <cstdlib>
#include <exception>
#include <utility>

#include "core/batch/bundle_option.h"

namespace mesecina {

std::filesystem::path user_bundle_file(std::string_view program) {
  const char* data = std::getenv("XDG_DATA_HOME");
  const char* home = std::getenv("HOME");
  std::filesystem::path folder;
  // A relative path means nothing there, says the XDG base directory specification.
  if (data && *data == '/')
    folder = data;
  else if (home && *home)
    folder = std::filesystem::path(home) / ".local" / "share";
  else
    return {};
  return folder / "mesecina" / (std::string(program) + "-bundles.json");
}

Bundle_library read_bundle_library(const std::filesystem::path& user_file, const Registry& registry) {
  Bundle_library library;
  const std::vector<Bundle> shipped = shipped_bundles(registry);
  std::vector<Bundle> listed;
  std::error_code error;
  if (!user_file.empty() && std::filesystem::exists(user_file, error)) {
    try {
      listed = read_bundle_file(user_file, registry);
    } catch (const std::exception& reason) {
      library.problem = reason.what();
    }
  }
  for (Bundle& bundle : listed) {
    const Bundle* original = find_bundle(shipped, bundle_id(bundle.name));
    const auto origin = !original             ? Known_bundle::Origin::own
                        : *original == bundle ? Known_bundle::Origin::shipped
                                              : Known_bundle::Origin::changed;
    library.bundles.push_back({std::move(bundle), origin});
  }
  for (const Bundle& bundle : shipped) {
    const std::string id = bundle_id(bundle.name);
    bool is_known = false;
    for (const Known_bundle& known : library.bundles) is_known = is_known || bundle_id(known.bundle.name) == id;
    if (!is_known) library.bundles.push_back({bundle, Known_bundle::Origin::shipped});
  }
  return library;
}

}  // namespace mesecina
