// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/film_wish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "core/formats/scene_json.h"

namespace mesecina {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::pair<Film_wish::Source, const char*>, 4> source_names{
    {{Film_wish::Source::changes, "changes"},
     {Film_wish::Source::animation, "animation"},
     {Film_wish::Source::evolution, "evolution"},
     {Film_wish::Source::turntable, "turntable"}}};

constexpr int most_pixels = 32768;

int whole_number(const Json& json, const std::string& path, int least, int most) {
  const bool is_good = json.is_number_integer() && json >= least && json <= most;
  if (!is_good) refuse_json(json, path, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return json.get<int>();
}

void read_source(Film_wish& wish, const Json& json, const std::string& path, std::vector<std::string>& notes) {
  if (!json.is_string()) refuse_json(json, path, "a text like changes or evolution");
  const auto known = std::ranges::find_if(source_names, [&](const auto& name) { return json == name.second; });
  if (known == source_names.end()) {
    notes.push_back(path + ": this version cannot record '" + json.get<std::string>() + "'; it records what changes");
  } else {
    wish.source = known->first;
  }
}

void read_size(Film_wish& wish, const Json& json, const std::string& path) {
  if (!json.is_array() || json.size() != 2) refuse_json(json, path, "a width and a height in pixels");
  wish.width = whole_number(json[0], path + "[0]", 1, most_pixels);
  wish.height = whole_number(json[1], path + "[1]", 1, most_pixels);
}

void read_sweeps(Film_wish& wish, const Json& json, const Registry& registry, const std::string& path,
                 Film_wish::Unknown& unknown, std::vector<std::string>& notes) {
  if (!json.is_array()) refuse_json(json, path, "a list of sweeps ID=FROM:TO:STEPS");
  for (const Json& sweep : json) {
    if (!sweep.is_string()) refuse_json(sweep, path, "sweeps ID=FROM:TO:STEPS");
    const std::string text = sweep.get<std::string>();
    try {
      wish.sweeps.push_back(parse_sweep(registry, text));
    } catch (const std::invalid_argument& error) {
      notes.push_back(path + ": " + error.what() + "; it is kept, not shown");
      unknown.sweeps.push_back(text);
    }
  }
}

}  // namespace

Json film_wish_to_json(const Film_wish& wish, const Film_wish::Unknown& unknown) {
  Json json = Json::object();
  for (const auto& [name, text] : unknown.members) json[name] = Json::parse(text);
  const auto source = std::ranges::find(source_names, wish.source, [](const auto& name) { return name.first; });
  json["source"] = source->second;
  if (!wish.file.empty()) json["file"] = wish.file;
  json["size"] = {wish.width, wish.height};
  json["frames-per-second"] = wish.frames_per_second;
  json["transparent"] = wish.is_transparent;
  Json sweeps = Json::array();
  for (const Sweep& sweep : wish.sweeps) sweeps.push_back(to_text(sweep));
  for (const std::string& text : unknown.sweeps) sweeps.push_back(text);
  json["sweeps"] = std::move(sweeps);
  json["turntable"] = wish.turntable;
  return json;
}

Film_wish film_wish_from_json(const Json& json, const Registry& registry, const std::string& path,
                              Film_wish::Unknown& unknown, std::vector<std::string>& notes) {
  if (!json.is_object()) refuse_json(json, path, "an object about a film");
  Film_wish wish;
  for (const auto& entry : json.items()) {
    const std::string& name = entry.key();
    const Json& value = entry.value();
    const std::string here = path + "." + name;
    if (name == "source") {
      read_source(wish, value, here, notes);
    } else if (name == "file") {
      if (!value.is_string()) refuse_json(value, here, "the name of a file");
      wish.file = value.get<std::string>();
    } else if (name == "size") {
      read_size(wish, value, here);
    } else if (name == "frames-per-second") {
      const bool is_good = value.is_number() && value.get<double>() > 0 && std::isfinite(value.get<double>());
      if (!is_good) refuse_json(value, here, "a positive number");
      wish.frames_per_second = value.get<double>();
    } else if (name == "transparent") {
      if (!value.is_boolean()) refuse_json(value, here, "true or false");
      wish.is_transparent = value.get<bool>();
    } else if (name == "sweeps") {
      read_sweeps(wish, value, registry, here, unknown, notes);
    } else if (name == "turntable") {
      wish.turntable = whole_number(value, here, 1, most_sweep_steps);
    } else {
      notes.push_back("'" + here + "' means nothing to this version; it is kept");
      unknown.members[name] = value.dump();
    }
  }
  return wish;
}

}  // namespace mesecina
