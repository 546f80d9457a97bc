// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/table.h"

#include <chrono>
#include <cstdio>

namespace mesecina {

double seconds(const std::function<void()>& run) {
  const auto start = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Table::row(const std::string& what, double figure, const char* unit, double goal, bool at_most) {
  const bool met = goal == 0 || (at_most ? figure <= goal : figure >= goal);
  all_met_ = all_met_ && met;
  std::printf("%-74s %9.3g %-9s", what.c_str(), figure, unit);
  if (goal != 0) std::printf(" goal %s %-6.3g %s", at_most ? "<=" : ">=", goal, met ? "met" : "MISSED");
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace mesecina
