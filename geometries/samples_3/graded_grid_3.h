// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/point.h"

namespace mesecina {

/// Points with spacings that differ by powers of two and change slowly from place to place: a hashed grid per power.
/// Reading it from several threads at once is safe.
class Graded_grid_3 {
 public:
  /// Spacings are at most `coarsest`, and at least `coarsest` / 2^14.
  explicit Graded_grid_3(double coarsest) : coarsest_(coarsest) {}

  /// Points are numbered in the order in which they are added. O(1).
  void add(const Point_3& p, double spacing);
  std::size_t size() const { return points_.size(); }
  const Point_3& point(int i) const { return points_[i]; }

  /// Calls use(i) for all points within the radius whose distance is at most twice their spacing, and for some others.
  template <class Use>
  void for_near(const Point_3& center, double radius, const Use& use) const {
    any_near(center, radius, [&](int i) {
      use(i);
      return false;
    });
  }
  /// Whether is_wanted(i) is true for any of these; does not look further then.
  template <class Is_wanted>
  bool any_near(const Point_3& center, double radius, const Is_wanted& is_wanted) const {
    const Entry* here = find({region_of(center), around});
    if (!here) return false;
    for (int level = 0; level < most_levels; ++level) {
      if ((here->last >> static_cast<unsigned>(level) & 1) == 0) continue;
      const double reach = std::min(radius, 2 * edge_of(level));
      const Cell own = cell_of(center, level);
      if (has_any(own, level, is_wanted)) return true;
      const Cell first = cell_of({center.x - reach, center.y - reach, center.z - reach}, level);
      const Cell last = cell_of({center.x + reach, center.y + reach, center.z + reach}, level);
      Cell cell{};
      for (cell.x = first.x; cell.x <= last.x; ++cell.x)
        for (cell.y = first.y; cell.y <= last.y; ++cell.y)
          for (cell.z = first.z; cell.z <= last.z; ++cell.z)
            if (!(cell == own) && has_any(cell, level, is_wanted)) return true;
    }
    return false;
  }

 private:
  static constexpr int most_levels = 15;
  /// In place of a level: a region of several cells and, as bits, the levels of the points in and around it; the upper
  /// bits are those of the points in it.
  static constexpr int around = -1;

  struct Cell {
    std::int64_t x, y, z;
    bool operator==(const Cell&) const = default;
  };
  struct Name {
    Cell cell;
    int level;
    bool operator==(const Name&) const = default;
  };
  struct Entry {
    Name name;
    int last = -1;  ///< the point that was added last
  };

  double edge_of(int level) const { return std::ldexp(coarsest_, -level); }
  Cell cell_of(const Point_3& p, int level) const {
    const double edge = edge_of(level);
    return {static_cast<std::int64_t>(std::floor(p.x / edge)), static_cast<std::int64_t>(std::floor(p.y / edge)),
            static_cast<std::int64_t>(std::floor(p.z / edge))};
  }
  Cell region_of(const Point_3& p) const { return cell_of(p, -2); }
  std::size_t slot_of(const Name& name) const;
  const Entry* find(const Name& name) const {
    if (slots_.empty()) return nullptr;
    const int entry = slots_[slot_of(name)];
    return entry < 0 ? nullptr : &entries_[entry];
  }
  template <class Is_wanted>
  bool has_any(const Cell& cell, int level, const Is_wanted& is_wanted) const {
    if (const Entry* entry = find({cell, level}))
      for (int i = entry->last; i >= 0; i = next_[i])
        if (is_wanted(i)) return true;
    return false;
  }
  Entry& find_or_add(const Name& name, int last);

  double coarsest_;
  std::vector<int> slots_;  ///< into entries_; a power of two
  std::vector<Entry> entries_;
  std::vector<Point_3> points_;
  std::vector<int> next_;  ///< per point the one that was added to its cell before it
};

}  // namespace mesecina
