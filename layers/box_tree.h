// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "layers/clip_2.h"

namespace mesecina {

/// Finds among many boxes those that meet a given one: a static R-tree, packed along a Morton curve.
class Box_tree {
 public:
  Box_tree() = default;
  /// O(n log n). Boxes with coordinates that are not finite are never found.
  explicit Box_tree(const std::vector<Pixel_box>& boxes);

  /// Calls `visit(index)` for every box that meets `query`, in no particular order.
  template <class Visit>
  void query(const Pixel_box& query, Visit visit) const {
    if (levels_.empty()) return;
    descend(levels_.size() - 1, 0, levels_.back().size(), query, visit);
  }

 private:
  static constexpr std::size_t fan_out = 16;

  template <class Visit>
  void descend(std::size_t level, std::size_t first, std::size_t last, const Pixel_box& query, Visit& visit) const {
    const std::vector<Pixel_box>& boxes = levels_[level];
    for (std::size_t i = first; i < last; ++i) {
      if (!boxes[i].meets(query)) continue;
      if (level == 0) {
        visit(static_cast<std::size_t>(order_[i]));
      } else {
        descend(level - 1, i * fan_out, std::min((i + 1) * fan_out, levels_[level - 1].size()), query, visit);
      }
    }
  }

  std::vector<std::uint32_t> order_;
  std::vector<std::vector<Pixel_box>> levels_;  ///< the boxes themselves, then those around fan_out of them, ...
};

}  // namespace mesecina
