// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <vector>

#include "core/progress.h"

namespace mesecina {

/// Spreads labels from pole to pole, the surest first: what is surely outside is told by add_outer, and each pole that
/// gets its label is evidence for others, on the same or on the other side. Poles without evidence get no label.
/// [N. Amenta, S. Choi, R. Kolluri: The power crust, 2001]
class Pole_labelling {
 public:
  explicit Pole_labelling(std::size_t count) : evidence_(count), is_labelled_(count, 0) {}

  void add_outer(int pole) { add_evidence(pole, false, 1); }
  bool is_labelled(int pole) const { return is_labelled_[pole] != 0; }

  /// Calls spread(pole, offer) for each labelled pole; that shall call offer(other, is_same_side, factor) for those it
  /// is evidence for, with how sure this is in (0, 1]. Writes labels and how sure they are, at the numbers of the
  /// poles; of other poles both stay. O(n log n) offers.
  template <class Spread>
  void run(std::vector<std::uint8_t>& is_inner, std::vector<double>& confidence, const Progress& progress,
           const Spread& spread) {
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      constexpr std::size_t often = 4096;
      if (step % often == 0) progress.check();
      const Entry next = queue_.top();
      queue_.pop();
      if (is_labelled(next.pole) || next.priority != evidence_[next.pole].priority()) continue;
      is_labelled_[next.pole] = 1;
      const Evidence& evidence = evidence_[next.pole];
      const bool inner = evidence.inner > evidence.outer;
      const double sure = std::max(evidence.inner, evidence.outer);
      is_inner[next.pole] = inner ? 1 : 0;
      confidence[next.pole] = sure;
      spread(next.pole, [&](int other, bool is_same_side, double factor) {
        if (is_labelled(other)) return;
        // Long chains must not end by underflow.
        add_evidence(other, inner == is_same_side,
                     std::max(sure * std::min(factor, 1.0), std::numeric_limits<double>::min()));
      });
    }
  }

 private:
  struct Evidence {
    double inner = 0;
    double outer = 0;
    /// Those with evidence for one side only come first.
    double priority() const { return inner > 0 && outer > 0 ? std::abs(inner - outer) - 1 : std::max(inner, outer); }
  };
  struct Entry {
    double priority = 0;
    int pole = 0;
    bool operator<(const Entry& other) const {
      return priority != other.priority ? priority < other.priority : pole > other.pole;
    }
  };

  void add_evidence(int pole, bool is_inner, double weight) {
    double& side = is_inner ? evidence_[pole].inner : evidence_[pole].outer;
    if (weight <= side) return;
    side = weight;
    queue_.push({evidence_[pole].priority(), pole});
  }

  std::vector<Evidence> evidence_;
  std::vector<std::uint8_t> is_labelled_;
  std::priority_queue<Entry> queue_;
};

}  // namespace mesecina
