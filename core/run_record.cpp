// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run_record.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/formats/number.h"

namespace mesecina {

namespace {

std::string utc_text(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

/// As a field of CSV: quoted where it must be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + "\"";
}

std::string csv_field(const Run_row& row) { return row.number ? format_number(*row.number) : csv_field(row.text); }

/// Stages in the order they ended first, with the seconds of all their times.
std::vector<std::pair<std::string, double>> added_up(const std::vector<Graph::Stage>& stages) {
  std::vector<std::pair<std::string, double>> sums;
  for (const Graph::Stage& stage : stages) {
    auto it = std::ranges::find(sums, stage.id, &std::pair<std::string, double>::first);
    if (it == sums.end()) it = sums.insert(sums.end(), {stage.id, 0});
    it->second += stage.seconds;
  }
  return sums;
}

bool is_same_line(const Compared_row& line, const Run_row& row) {
  return line.section == row.section && line.name == row.name;
}

}  // namespace

std::vector<Run_row> rows_of(const Run_record& record) {
  std::vector<Run_row> rows;
  const auto add_number = [&](const char* section, std::string name, double number) {
    rows.push_back({section, std::move(name), number, {}});
  };
  const auto add_text = [&](const char* section, std::string name, std::string text) {
    rows.push_back({section, std::move(name), {}, std::move(text)});
  };
  for (const auto& [name, count] : record.counts) add_number("Input", name, static_cast<double>(count));
  for (const Layer_record& layer : record.layers) {
    if (!layer.reason.empty()) {
      add_text("Layers", layer.label, layer.reason);
      continue;
    }
    add_number("Layers", layer.label + ": elements", static_cast<double>(layer.elements));
    add_number("Layers", layer.label + ": vertices", static_cast<double>(layer.vertices));
    if (!layer.topology) continue;
    add_number("Layers", layer.label + ": Euler characteristic", static_cast<double>(layer.topology->euler));
    constexpr std::array names{": components (b0)", ": holes (b1)", ": voids (b2)"};
    for (std::size_t i = 0; i < names.size(); ++i)
      add_number("Layers", layer.label + names[i], static_cast<double>(layer.topology->betti[i]));
  }
  for (const auto& [name, value] : record.measures) add_number("Reached", name, value);
  for (const auto& [name, text] : record.notes) add_text("Notes", name, text);
  add_number("Seconds", "all", record.seconds);
  for (const auto& [id, seconds] : added_up(record.stages)) add_number("Seconds", id, seconds);
  if (record.memory > 0) add_number("Memory", "bytes", static_cast<double>(record.memory));
  for (std::size_t i = 0; i < record.warnings.size(); ++i)
    add_text("Warnings", std::to_string(i + 1), record.warnings[i]);
  return rows;
}

std::vector<Compared_row> compared_rows(std::span<const Run_record> records) {
  std::vector<Compared_row> lines;
  for (std::size_t i = 0; i < records.size(); ++i) {
    for (Run_row& row : rows_of(records[i])) {
      auto line = std::ranges::find_if(lines, [&](const Compared_row& known) { return is_same_line(known, row); });
      if (line == lines.end()) {
        const auto last = std::ranges::find(lines.rbegin(), lines.rend(), row.section, &Compared_row::section);
        line = lines.insert(last == lines.rend() ? lines.end() : last.base(),
                            {row.section, row.name, std::vector<std::optional<Run_row>>(records.size())});
      }
      line->runs[i] = std::move(row);
    }
  }
  return lines;
}

std::string to_csv(std::span<const Run_record> records) {
  std::string text = "section,name";
  for (const Run_record& record : records) text += ",run " + std::to_string(record.number);
  text += "\nRun,what";
  for (const Run_record& record : records) text += "," + csv_field(record.what);
  text += "\nRun,time";
  for (const Run_record& record : records) text += "," + utc_text(record.time);
  text += '\n';
  for (const Compared_row& line : compared_rows(records)) {
    text += csv_field(line.section) + "," + csv_field(line.name);
    for (const std::optional<Run_row>& row : line.runs) text += "," + (row ? csv_field(*row) : std::string());
    text += '\n';
  }
  return text;
}

std::string to_json(std::span<const Run_record> records) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Run_record& record : records) {
    Json json;
    json["run"] = record.number;
    json["what"] = record.what;
    json["time"] = utc_text(record.time);
    json["input"] = record.counts;
    json["layers"] = Json::object();
    for (const Layer_record& layer : record.layers) {
      Json& entry = json["layers"][layer.id];
      if (!layer.reason.empty()) {
        entry["reason"] = layer.reason;
        continue;
      }
      entry["elements"] = layer.elements;
      entry["vertices"] = layer.vertices;
      if (!layer.topology) continue;
      entry["euler"] = layer.topology->euler;
      entry["betti"] = layer.topology->betti;
    }
    json["reached"] = record.measures;
    json["notes"] = record.notes;
    json["seconds"]["all"] = record.seconds;
    for (const auto& [id, seconds] : added_up(record.stages)) json["seconds"][id] = seconds;
    json["memory"] = record.memory;
    json["warnings"] = record.warnings;
    list.push_back(std::move(json));
  }
  constexpr int indent = 2;
  return list.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace mesecina
