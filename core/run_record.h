// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/graph.h"

namespace mesecina {

/// What statistics tell of a layer.
struct Layer_record {
  std::string id;
  std::string label;
  std::uint64_t elements = 0;
  std::uint64_t vertices = 0;
  std::optional<Topology> topology;  ///< of complexes, once it is known
  std::string reason;                ///< why there is nothing
};

/// What a computation of a window has cost and found out: one entry of the history of runs.
struct Run_record {
  int number = 1;
  std::string what;  ///< the step of the user that it followed: "Move 3 points"
  std::chrono::system_clock::time_point time;
  double seconds = 0;
  std::uint64_t memory = 0;                     ///< resident, in bytes, at its end
  std::map<std::string, std::uint64_t> counts;  ///< of the inputs
  std::vector<Layer_record> layers;             ///< the visible ones, from top to bottom
  std::vector<Graph::Stage> stages;
  std::map<std::string, double> measures;
  std::map<std::string, std::string> notes;
  std::vector<std::string> warnings;
};

/// A line of a table of statistics: a number with its unit, or a text.
struct Run_row {
  std::string section;  ///< "Input", "Layers", "Reached", "Notes", "Seconds", "Memory", "Warnings"
  std::string name;
  std::optional<double> number;
  std::string text;  ///< where there is no number
};

/// Everything a record tells, section by section. Stages that ran several times are added up.
std::vector<Run_row> rows_of(const Run_record& record);

/// The same line of several runs side by side.
struct Compared_row {
  std::string section;
  std::string name;
  std::vector<std::optional<Run_row>> runs;  ///< one per record; absent where it tells nothing of this
};
/// Lines in the order of the first record; those that only later ones have stand at the end of their section.
std::vector<Compared_row> compared_rows(std::span<const Run_record> records);

/// A table: section, name, and a column per record. Numbers in the C locale, shortest form.
std::string to_csv(std::span<const Run_record> records);
/// A list of objects, one per record, times in UTC.
std::string to_json(std::span<const Run_record> records);

}  // namespace mesecina
