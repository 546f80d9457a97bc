// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mesecina {

/// The table of a run as CSV: one row per input. Its columns depend on the layers only: input, status, reason, seconds,
/// in space repair and error (Hausdorff distance relative to the diagonal), warnings, and per layer its number of
/// elements and, of complexes, Betti numbers. What is not known is empty. Lines end with a newline; numbers have a
/// decimal point; cells with commas, quotes or line breaks are quoted.
class Summary {
 public:
  /// `dimension`: of the space, 2 or 3.
  Summary(std::vector<std::string> layers, int dimension) : layers_(std::move(layers)), dimension_(dimension) {}

  std::string header() const;
  /// The row of an input. `statistics`: its line of the statistics (to_json_line).
  std::string row(std::string_view status, const std::string& statistics) const;

 private:
  std::vector<std::string> layers_;
  int dimension_;
};

}  // namespace mesecina
