// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "core/style.h"

namespace mesecina {

/// Ranges of colour maps that are the same in all frames of a film: where a style leaves an end of the range to the
/// picture, the least or greatest value of what is drawn in any frame, so that a colour means the same throughout.
class Film_ranges {
 public:
  /// Whether some visible layer has a colour map without a range of its own.
  static bool are_wanted_by(const Scene& scene);

  /// Takes the values of a frame in. O(size of the scene).
  void widen(const Scene& scene);
  /// Gives the ranges so far to the layers that have none of their own.
  void apply_to(Scene& scene) const;

 private:
  struct Range {
    double minimum = 0;
    double maximum = 0;
  };
  std::map<std::string, Range> ranges_;  ///< by layer
};

}  // namespace mesecina
