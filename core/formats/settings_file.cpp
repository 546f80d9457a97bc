// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/settings_file.h"

#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>

#include "core/formats/format.h"
#include "core/formats/json_text.h"
#include "core/formats/scene_json.h"
#include "core/formats/text_file.h"

namespace mesecina {

namespace {

constexpr const char* format_name = "mesecina-settings";
constexpr int format_version = 1;

Settings without_defaults(const Settings& settings, const Registry& registry) {
  Settings result;
  for (const auto& [id, value] : settings.changed())
    if (value != registry.find_setting(id)->default_value) result = result.with(id, value);
  return result;
}

}  // namespace

void write_settings_file(std::ostream& stream, const Registry& registry, const Settings& settings,
                         const std::vector<std::string>& ids) {
  Settings written;
  for (const std::string& id : ids) written = written.with(id, registry.value(settings, id));
  const nlohmann::json json{
      {"format", format_name}, {"version", format_version}, {"settings", settings_to_json(written)}};
  stream << json.dump(2) << '\n';
}

Settings_file read_settings_file(const std::filesystem::path& file, const Registry& registry) {
  nlohmann::json json;
  try {
    json = parse_json(load_bytes(file).text);
  } catch (const std::invalid_argument& error) {
    throw File_error(file, 0, error.what());
  }
  const auto refuse = [&](const std::string& message) { throw File_error(file, 0, message); };
  if (!json.is_object() || json.value("format", nlohmann::json()) != format_name)
    refuse(std::string("expected a file with \"format\": \"") + format_name + "\"");
  const nlohmann::json version = json.value("version", nlohmann::json());
  if (!version.is_number_integer() || version.get<int>() < 1) refuse("expected a whole \"version\" from 1");
  if (version.get<int>() > format_version)
    refuse("expected version " + std::to_string(format_version) + " or less, found " + version.dump() +
           ": it comes from a newer program");
  if (!json.contains("settings")) refuse("expected \"settings\", found none");
  Settings_file result;
  Unknown_parts unknown;
  try {
    const Settings all = settings_from_json(json["settings"], registry, "settings", unknown);
    for (const auto& entry : json["settings"].items())
      if (registry.find_setting(entry.key())) result.ids.push_back(entry.key());
    result.settings = without_defaults(all, registry);
  } catch (const std::invalid_argument& error) {
    refuse(error.what());
  }
  result.notes = unknown.notes;
  return result;
}

Settings with_settings_of(const Settings_file& file, const Settings& settings) {
  Settings result = settings;
  for (const std::string& id : file.ids) {
    const Setting_value* value = file.settings.find(id);
    result = value ? result.with(id, *value) : result.without(id);
  }
  return result;
}

}  // namespace mesecina
