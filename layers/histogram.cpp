// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesecina {

namespace {

constexpr double logarithmic_from_ratio = 1e3;
constexpr double largest_ratio = 1e12;  // what is smaller than the largest value by more than this counts as zero

}  // namespace

double Histogram::position(double value) const {
  if (!(value > lower)) return 0;
  if (value >= upper) return 1;
  return is_logarithmic ? std::log(value / lower) / std::log(upper / lower) : (value - lower) / (upper - lower);
}

double Histogram::value(double position) const {
  if (position <= 0) return lower;
  if (position >= 1) return upper;
  return is_logarithmic ? lower * std::exp(position * std::log(upper / lower)) : lower + position * (upper - lower);
}

Histogram compute_histogram(std::span<const double> values, std::size_t bin_count) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Histogram histogram;
  double minimum = infinity;
  double maximum = -infinity;
  double smallest_positive = infinity;
  bool are_integers = true;
  for (const double value : values) {
    if (!std::isfinite(value)) {
      ++(value == infinity ? histogram.infinite : histogram.other);
      continue;
    }
    ++histogram.finite;
    minimum = std::min(minimum, value);
    maximum = std::max(maximum, value);
    if (value > 0) smallest_positive = std::min(smallest_positive, value);
    are_integers = are_integers && value == std::floor(value);
  }
  if (histogram.finite == 0) return histogram;
  histogram.minimum = histogram.lower = minimum;
  histogram.maximum = histogram.upper = maximum;

  const double span = maximum - minimum;
  if (are_integers && span < static_cast<double>(bin_count)) {
    bin_count = static_cast<std::size_t>(span) + 1;
    histogram.lower -= 0.5;
    histogram.upper += 0.5;
  } else if (minimum >= 0 && maximum > logarithmic_from_ratio * smallest_positive) {
    histogram.is_logarithmic = true;
    histogram.lower = std::max(smallest_positive, maximum / largest_ratio);
  } else if (!(span > 0) || !std::isfinite(span)) {
    bin_count = 1;
    if (!(span > 0)) {
      const double margin = minimum == 0 ? 1 : std::abs(minimum) / 2;
      histogram.lower -= margin;
      histogram.upper += margin;
    }
  }

  histogram.bins.assign(bin_count, 0);
  const double scale =
      static_cast<double>(bin_count) /
      (histogram.is_logarithmic ? std::log(histogram.upper / histogram.lower) : histogram.upper - histogram.lower);
  const auto last = static_cast<double>(bin_count - 1);
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    if (value < histogram.lower) {
      ++histogram.below;
      continue;
    }
    const double bin = scale * (histogram.is_logarithmic ? std::log(value / histogram.lower) : value - histogram.lower);
    ++histogram.bins[static_cast<std::size_t>(std::clamp(bin, 0.0, last))];
  }
  return histogram;
}

}  // namespace mesecina
