// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <ctime>
#include <limits>

namespace mesecina::test {

/// The processor time that `work` takes of this process, in seconds: what others do on the machine does not count.
template <class Work>
double processor_seconds(Work&& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// How many times longer `large` takes than `small`; the least of up to three attempts, of which the first that is
/// below `enough` ends them. Tells quadratic growth from linear growth on any machine and under sanitizers, which
/// absolute times do not.
template <class Small, class Large>
double growth(Small&& small, Large&& large, double enough) {
  double least = std::numeric_limits<double>::infinity();
  for (int attempt = 0; attempt < 3 && least >= enough; ++attempt) {
    const double first = std::min(processor_seconds(small), processor_seconds(small));
    least = std::min(least, processor_seconds(large) / std::max(first, 1e-6));
  }
  return least;
}

}  // namespace mesecina::test
