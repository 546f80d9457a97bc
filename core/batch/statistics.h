// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/inputs.h"
#include "core/primitives.h"

namespace mesecina {

/// What came of one --evolve.
struct Evolution_statistics {
  std::string id;
  std::uint64_t steps = 0;  ///< that were done
  std::string end_reason;   ///< why there were fewer than asked for; empty if there were not
  double seconds = 0;
};

/// What --stats says of one input.
struct Input_statistics {
  std::string input;
  bool failed = false;
  std::string reason;
  std::map<std::string, std::string> refused;    ///< format and reason of each picture that could not be written
  std::map<std::string, double> seconds;         ///< "total", "read", "write", and one per stage
  std::vector<Evolution_statistics> evolutions;  ///< in the order of the command line
  std::map<std::string, std::uint64_t> counts;   ///< of the input
  std::vector<std::pair<std::string, std::string>> layers;  ///< id and its JSON object
  std::map<std::string, double> errors;                     ///< reached, relative to the diagonal
  std::map<std::string, std::string> notes;                 ///< on what was done to the input
  std::vector<std::string> warnings;
};

/// How much there is of each kind of input: "points", "triangles", "pixels", ...
std::map<std::string, std::uint64_t> count_inputs(const Inputs& inputs);
/// JSON object of counts, Euler characteristic and Betti numbers of a layer, as in the "layers" of a statistics line.
std::string layer_statistics(const Primitive_set* primitives, const std::string& reason);
/// One line, ended by a newline.
std::string to_json_line(const Input_statistics& statistics);
/// Largest resident memory of this process since forget_peak_memory, or so far, in bytes.
std::uint64_t peak_memory();
/// Of several inputs that one process computes, each is to have its own peak. Does nothing where the system cannot.
void forget_peak_memory();
/// Resident memory of this process now, in bytes; 0 where the system does not say.
std::uint64_t present_memory();

}  // namespace mesecina
