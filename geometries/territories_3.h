// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <thread>
#include <vector>

namespace mesecina {

/// Space cut by planes across the axes into boxes.
class Territories_3 {
 public:
  /// The box around a thing, which has to lie in one box of territories with all of it.
  struct Reach {
    std::array<double, 3> lower;
    std::array<double, 3> upper;
  };

  /// All of space is one box.
  Territories_3() = default;
  /// At most this many boxes, such that most things lie in one of them and these have about equally many. One box where
  /// no cut is worth while. O(n log n).
  static Territories_3 around(std::span<const Reach> things, int most_boxes);

  int box_count() const { return static_cast<int>(cuts_.size()) + 1; }
  int box_of(double x, double y, double z) const {
    if (cuts_.empty()) return 0;
    const std::array<double, 3> place{x, y, z};
    int next = 0;
    while (next >= 0) {
      const Cut& cut = cuts_[next];
      next = place[cut.axis] < cut.at ? cut.below : cut.above;
    }
    return -1 - next;
  }

 private:
  struct Cut {
    int axis = 0;
    double at = 0;
    int below = -1;  ///< a cut, or -1 - box
    int above = -1;
  };
  int add(std::vector<Reach> things, int most_boxes, int& boxes);

  std::vector<Cut> cuts_;
};

/// In place of the locks of points that CGAL's triangulations ask for while several threads change one of them: a
/// vertex may be taken by the thread that has its territory, and a vertex at no place (NaN) by none. So a thread
/// replaces only cells whose vertices are all its own; of a cell that has another one's vertex too it changes what lies
/// across from that vertex, which no other thread reads, and nothing else.
class Territory_locks_3 {
 public:
  /// No thread has a territory yet.
  explicit Territory_locks_3(Territories_3 territories)
      : territories_(std::move(territories)), owners_(territories_.box_count()) {}

  const Territories_3& territories() const { return territories_; }
  /// Gives the territory to this thread, until someone else takes it.
  void take(int box) { owners_[box].store(std::this_thread::get_id(), std::memory_order_relaxed); }
  void leave(int box) { owners_[box].store(std::thread::id(), std::memory_order_relaxed); }

  template <class Place>
  bool try_lock(const Place& place, int = 0) const {
    if (std::isnan(place.x())) return false;
    const int box = territories_.box_of(place.x(), place.y(), place.z());
    return owners_[box].load(std::memory_order_relaxed) == std::this_thread::get_id();
  }

 private:
  Territories_3 territories_;
  std::vector<std::atomic<std::thread::id>> owners_;
};

}  // namespace mesecina
