// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace mesecina {

/// Wall-clock seconds of one call.
double seconds(const std::function<void()>& run);

/// Prints figures as they come, and remembers whether all goals were met.
class Table {
 public:
  /// One row; a goal of 0 is none. `at_most`: the figure must not exceed the goal, else not fall short of it.
  void row(const std::string& what, double figure, const char* unit, double goal = 0, bool at_most = true);
  bool all_met() const { return all_met_; }

 private:
  bool all_met_ = true;
};

}  // namespace mesecina
