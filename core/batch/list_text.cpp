// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "core/batch/bundle_library.h"
#include "core/batch/command_line.h"
#include "core/bundle.h"
#include "core/formats/number.h"
#include "core/help_text.h"

namespace mesecina {

namespace {

using Ordered_json = nlohmann::ordered_json;

Ordered_json to_json(const Setting_value& value) {
  return std::visit([](const auto& v) -> Ordered_json { return v; }, value);
}

const char* type_name(const Setting_value& value) {
  constexpr const char* names[] = {"boolean", "integer", "number", "text"};
  return names[value.index()];
}

Ordered_json list_layers(const Registry& registry) {
  Ordered_json list = Ordered_json::array();
  for (const Layer_spec& layer : registry.layers()) {
    Ordered_json entry{
        {"id", layer.id}, {"label", layer.label}, {"stage", layer.stage}, {"help", with_ids(layer.help)}};
    if (!layer.cut_setting.empty()) entry["limit"] = layer.cut_setting;
    list.push_back(std::move(entry));
  }
  return list;
}

Ordered_json list_settings(const Registry& registry) {
  Ordered_json list = Ordered_json::array();
  for (const Setting_spec& setting : registry.settings()) {
    Ordered_json entry{{"id", setting.id},
                       {"label", setting.label},
                       {"type", type_name(setting.default_value)},
                       {"default", to_json(setting.default_value)},
                       {"unit", setting.unit}};
    if (std::isfinite(setting.minimum)) entry["minimum"] = setting.minimum;
    if (std::isfinite(setting.maximum)) entry["maximum"] = setting.maximum;
    if (!setting.choices.empty()) entry["choices"] = setting.choices;
    entry["help"] = with_ids(setting.help);
    list.push_back(std::move(entry));
  }
  return list;
}

Ordered_json list_evolutions(const Registry& registry) {
  Ordered_json list = Ordered_json::array();
  for (const Evolution_spec& evolution : registry.evolutions()) {
    list.push_back({{"id", evolution.id},
                    {"label", evolution.label},
                    {"needs", evolution.needs.what},
                    {"settings", evolution.settings},
                    {"help", with_ids(evolution.help)}});
  }
  return list;
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text + "  ";
}

Ordered_json list_bundles(const Bundle_library& library) {
  constexpr const char* origins[] = {"shipped", "changed", "own"};
  Ordered_json list = Ordered_json::array();
  for (const Known_bundle& known : library.bundles) {
    const Bundle& bundle = known.bundle;
    Ordered_json layers = Ordered_json::array();
    for (const Layer_entry& layer : bundle.layers) layers.push_back(layer.id);
    list.push_back({{"id", bundle_id(bundle.name)},
                    {"name", bundle.name},
                    {"origin", origins[static_cast<std::size_t>(known.origin)]},
                    {"layers", std::move(layers)},
                    {"help", bundle.help}});
  }
  return list;
}

std::string bundles_text(const Bundle_library& library) {
  constexpr std::size_t width = 28;
  constexpr const char* marks[] = {"", "(changed by you) ", "(yours) "};
  std::string text;
  for (const auto& [bundle, origin] : library.bundles)
    text += padded(bundle_id(bundle.name), width) + marks[static_cast<std::size_t>(origin)] +
            (bundle.help.empty() ? bundle.name : bundle.help) + "\n";
  if (!library.problem.empty()) text += "Yours are missing: " + library.problem + "\n";
  return text;
}

Ordered_json list_formats(const Formats& formats) {
  Ordered_json list = Ordered_json::array();
  for (const Reader& reader : formats.readers) {
    list.push_back({{"use", "read"}, {"name", reader.name}, {"extensions", reader.extensions}});
  }
  const auto add = [&](const char* use, const auto& writer) {
    list.push_back({{"use", use}, {"name", writer.name}, {"extensions", {writer.extension}}, {"help", writer.help}});
  };
  for (const Layer_writer& writer : formats.layer_writers) add("write layers", writer);
  for (const Picture_writer& writer : formats.picture_writers) add("write pictures", writer);
  return list;
}

std::string range_text(const Setting_spec& setting) {
  std::string text = "default " + to_text(setting.default_value);
  if (std::isfinite(setting.minimum)) text += ", from " + format_number(setting.minimum);
  if (std::isfinite(setting.maximum)) text += ", to " + format_number(setting.maximum);
  if (!setting.unit.empty()) text += ", " + setting.unit;
  return text;
}

}  // namespace

std::string list_text(const std::string& what, bool as_json, const Registry& registry, const Formats& formats,
                      const std::filesystem::path& user_bundles) {
  if (as_json) {
    const Ordered_json list = what == "layers"       ? list_layers(registry)
                              : what == "settings"   ? list_settings(registry)
                              : what == "evolutions" ? list_evolutions(registry)
                              : what == "bundles"    ? list_bundles(read_bundle_library(user_bundles, registry))
                                                     : list_formats(formats);
    return list.dump(2) + "\n";
  }
  std::string text;
  if (what == "layers") {
    std::string stage;
    for (const Layer_spec& layer : registry.layers()) {
      if (layer.stage != stage) text += (text.empty() ? "" : "\n") + (stage = layer.stage) + "\n";
      text += "  " + padded(layer.id, 28) + with_ids(layer.help) + "\n";
    }
  } else if (what == "settings") {
    for (const Setting_spec& setting : registry.settings())
      text += padded(setting.id, 22) + range_text(setting) + "\n" + padded("", 22) + with_ids(setting.help) + "\n";
  } else if (what == "bundles") {
    text = bundles_text(read_bundle_library(user_bundles, registry));
  } else if (what == "evolutions") {
    for (const Evolution_spec& evolution : registry.evolutions()) {
      const std::string& needs = evolution.needs.what;
      text += padded(evolution.id, 22) + (needs.empty() ? needs : "Needs " + needs + ". ") + with_ids(evolution.help) +
              "\n";
    }
  } else {
    for (const Reader& reader : formats.readers) {
      std::string extensions;
      for (const std::string& extension : reader.extensions) extensions += " ." + extension;
      text += padded("read", 14) + padded(reader.name, 28) + extensions + "\n";
    }
    for (const Layer_writer& writer : formats.layer_writers)
      text += padded("write layers", 14) + padded(writer.name, 28) + writer.help + "\n";
    for (const Picture_writer& writer : formats.picture_writers)
      text += padded("write pictures", 14) + padded(writer.name, 28) + writer.help + "\n";
  }
  return text;
}

}  // namespace mesecina
