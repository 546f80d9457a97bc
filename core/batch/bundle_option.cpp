// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/bundle_option.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "core/batch/bundle_library.h"
#include "core/formats/text_file.h"
#include "core/historical_bundles.h"

namespace mesecina {

namespace {

std::vector<std::string> names_of(const std::vector<Bundle>& bundles, bool as_ids) {
  std::vector<std::string> names;
  names.reserve(bundles.size());
  for (const Bundle& bundle : bundles) names.push_back(as_ids ? bundle_id(bundle.name) : bundle.name);
  return names;
}

Bundle pick(const std::vector<Bundle>& bundles, const std::string& name, const std::string& otherwise) {
  if (const Bundle* bundle = find_bundle(bundles, name)) return *bundle;
  std::string nearest = nearest_name(name, names_of(bundles, true));
  if (nearest.empty()) nearest = nearest_name(name, names_of(bundles, false));
  throw std::invalid_argument("unknown bundle '" + name + "'" +
                              (nearest.empty() ? "; " + otherwise : "; did you mean '" + nearest + "'?"));
}

/// As the shipped bundles are called, whatever the user has made of them.
constexpr std::string_view shipped_mark = "shipped:";

Bundle pick_known(const std::string& name, const Registry& registry, const std::filesystem::path& user_file,
                  std::vector<std::string>& warnings) {
  constexpr const char* otherwise = "--list bundles shows them all";
  if (name.starts_with(shipped_mark))
    return pick(shipped_bundles(registry), name.substr(shipped_mark.size()), otherwise);
  const Bundle_library library = read_bundle_library(user_file, registry);
  if (!library.problem.empty()) warnings.push_back(library.problem + "; only shipped bundles are known");
  std::vector<Bundle> bundles;
  for (const Known_bundle& known : library.bundles) bundles.push_back(known.bundle);
  Bundle bundle = pick(bundles, name, otherwise);
  const bool is_changed = std::ranges::any_of(library.bundles, [&](const Known_bundle& known) {
    return known.origin == Known_bundle::Origin::changed && known.bundle.name == bundle.name;
  });
  if (is_changed)
    warnings.push_back("bundle '" + bundle.name + "' is yours, from " + user_file.string() +
                       "; the one of the program is '" + std::string(shipped_mark) + bundle_id(bundle.name) + "'");
  return bundle;
}

bool is_file(const std::string& text) {
  std::error_code error;
  return std::filesystem::is_regular_file(text, error);
}

}  // namespace

std::vector<Bundle> read_bundle_file(const std::filesystem::path& file, const Registry& registry) {
  const Text_file content = load_bytes(file);
  const bool is_historical = lower_case(file.extension().string()) == ".bnd";
  try {
    return is_historical ? parse_historical_bundles(content.text, registry) : parse_bundles(content.text, registry);
  } catch (const std::invalid_argument& error) {
    throw File_error(file, 0, error.what());
  }
}

Bundle read_bundle_option(const std::string& text, const Registry& registry, const std::filesystem::path& user_file,
                          std::vector<std::string>& warnings) {
  const auto hash = text.rfind('#');
  const std::string file = is_file(text) || hash == std::string::npos ? text : text.substr(0, hash);
  if (!is_file(file)) {
    const bool looks_like_file =
        text.find('/') != std::string::npos || file.ends_with(".json") || file.ends_with(".bnd");
    if (looks_like_file) throw std::invalid_argument(file + ": there is no such file");
    return pick_known(text, registry, user_file, warnings);
  }
  const std::vector<Bundle> bundles = read_bundle_file(file, registry);
  if (bundles.empty()) throw std::invalid_argument(file + ": there is no bundle in it");
  if (file.size() == text.size()) return bundles.front();
  std::string known = "there are";
  for (const Bundle& bundle : bundles) known += (&bundle == bundles.data() ? " '" : ", '") + bundle.name + "'";
  return pick(bundles, text.substr(hash + 1), known);
}

void take_bundle(Command_line& command_line, const Bundle& bundle, const Registry& registry) {
  const Arrangement arrangement = apply_bundle(bundle, registry, {Settings(), default_layers(registry)});
  command_line.settings = arrangement.settings;
  command_line.layers.clear();
  for (const Layer_entry& layer : bundle.layers) {
    command_line.styles.insert_or_assign(layer.id, layer.style);
    if (layer.style.visible) command_line.layers.push_back(layer.id);
  }
  command_line.as_listed = true;
  command_line.view = bundle.view;
  command_line.view_3 = bundle.view_3;
  if (bundle.background) command_line.background = bundle.background;
  command_line.bundle_needs = bundle.needs;
  for (const std::string& note : bundle.unknown.notes)
    command_line.warnings.push_back("bundle '" + bundle.name + "': " + note);
}

}  // namespace mesecina
