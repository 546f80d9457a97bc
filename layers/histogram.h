// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mesecina {

/// How many values lie where. The finite values are counted in bins of equal width, in the value or, where
/// `is_logarithmic`, in its logarithm.
struct Histogram {
  double minimum = 0;  ///< smallest and largest finite value
  double maximum = 0;
  double lower = 0;  ///< of the first bin; above `minimum` where values are too small for a logarithmic axis
  double upper = 0;  ///< of the last bin
  bool is_logarithmic = false;
  std::vector<std::size_t> bins;  ///< empty when there is no finite value
  std::size_t finite = 0;
  std::size_t below = 0;     ///< finite values less than `lower`: zeros, mostly; in no bin
  std::size_t infinite = 0;  ///< +infinity
  std::size_t other = 0;     ///< -infinity and not-a-number

  std::size_t total() const { return finite + infinite + other; }
  /// Place of a value on the axis: 0 at `lower`, 1 at `upper`, clamped.
  double position(double value) const;
  /// The value at a place in [0, 1].
  double value(double position) const;
};

/// Bins are logarithmic when no value is negative and the positive ones span more than three decades. Few different
/// integers get a bin each. Two passes over the values.
Histogram compute_histogram(std::span<const double> values, std::size_t bin_count = 120);

}  // namespace mesecina
