// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace mesecina {

/// A partition of 0 ... count - 1, at first into single numbers. A set is known by its least number, so it does not
/// matter in which order sets were joined.
class Disjoint_sets {
 public:
  explicit Disjoint_sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

  std::size_t size() const { return parent_.size(); }
  /// The least number of the set. O(log n) amortised.
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// False when they were in one set before.
  bool join(int i, int j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
    return i != j;
  }

 private:
  std::vector<int> parent_;
};

}  // namespace mesecina
