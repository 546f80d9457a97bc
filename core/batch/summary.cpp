// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/summary.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "core/formats/number.h"

namespace mesecina {

namespace {

using Json = nlohmann::json;

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) {
    if (c == '"') cell += c;
    cell += c;
  }
  return cell + '"';
}

std::string joined(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (&cell == cells.data() ? "" : ",") + quoted(cell);
  return line + "\n";
}

std::string text_at(const Json& json, const Json::json_pointer& place) {
  const Json value = json.value(place, Json());
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return format_number(value.get<double>());
  return value.is_null() ? "" : value.dump();
}

std::string warnings_of(const Json& json) {
  std::string text;
  for (const Json& warning : json.at("warnings")) text += (text.empty() ? "" : "; ") + warning.get<std::string>();
  return text;
}

/// Why it failed, or why pictures are missing.
std::string reason_of(const Json& json) {
  std::string text = text_at(json, Json::json_pointer("/reason"));
  for (const Json& reason : json.value("refused", Json::object()))
    text += (text.empty() ? "" : "; ") + reason.get<std::string>();
  return text;
}

/// Of all kinds of elements together; nothing for a layer that there is not.
std::string element_count(const Json& layer) {
  if (!layer.contains("vertices")) return {};
  std::uint64_t count = 0;
  for (const char* kind : {"points", "segments", "rays", "arcs", "triangles", "polygons", "balls"})
    count += layer.value(kind, std::uint64_t{0});
  return std::to_string(count);
}

}  // namespace

std::string Summary::header() const {
  std::vector<std::string> cells{"input", "status", "reason", "seconds"};
  if (dimension_ == 3) cells.insert(cells.end(), {"repair", "error"});
  cells.emplace_back("warnings");
  for (const std::string& layer : layers_)
    for (const char* column : {".elements", ".b0", ".b1", ".b2"}) cells.push_back(layer + column);
  return joined(cells);
}

std::string Summary::row(std::string_view status, const std::string& statistics) const {
  const Json json = Json::parse(statistics);
  std::vector<std::string> cells{text_at(json, Json::json_pointer("/input")), std::string(status), reason_of(json),
                                 text_at(json, Json::json_pointer("/seconds/total"))};
  if (dimension_ == 3) {
    cells.push_back(text_at(json, Json::json_pointer("/notes/repair")));
    cells.push_back(text_at(json, Json::json_pointer("/error/hausdorff")));
  }
  cells.push_back(warnings_of(json));
  const Json& layers = json.at("layers");
  for (const std::string& id : layers_) {
    const Json layer = layers.value(id, Json::object());
    cells.push_back(element_count(layer));
    const auto betti = layer.find("betti");
    for (std::size_t i = 0; i < 3; ++i) cells.push_back(betti == layer.end() ? "" : betti->at(i).dump());
  }
  return joined(cells);
}

}  // namespace mesecina
