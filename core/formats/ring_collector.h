// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/formats/text_file.h"
#include "core/inputs.h"

namespace mesecina {

/// Makes an outline of the rings of a file, warning of what is odd about them. Rings and their segments are numbered
/// from 1 in the order of the file, rings that are dropped included.
class Ring_collector {
 public:
  explicit Ring_collector(Warning_list& warnings) : warnings_(warnings) {}

  /// How a ring ends in the file.
  enum class End {
    repeats_first,  ///< its last vertex must be its first again, else it is closed with a warning
    is_implied,     ///< the last vertex is joined to the first without being told so
  };
  /// Merges equal neighbours, silently; drops a ring of fewer than three distinct vertices. Vertices must be finite.
  /// `place` is where the ring is in the file, for warnings: "line 7".
  void add(Ring_2 vertices, End end, const std::string& place);

  /// The outline. Warns when it is empty or crosses itself; it is the same outline nevertheless.
  Outline_2 finish();

 private:
  Warning_list& warnings_;
  Outline_2 outline_;
  std::vector<std::size_t> numbers_;  ///< in the file, of each ring of the outline
  std::size_t count_ = 0;
};

/// "(x, y)" in shortest round-trip form.
std::string to_text(const Point_2& point);

}  // namespace mesecina
