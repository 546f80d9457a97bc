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
  explicit Graded_grid_3(double coarsest) : coarsest_(coarsest) {
    for (int level = 0; level < most_levels; ++level) {
      edges_[level] = std::ldexp(coarsest, -level);
      per_edge_[level] = std::ldexp(1 / coarsest, level);
    }
  }

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
    const int levels = levels_around(center);
    for (int level = 0; level < most_levels; ++level) {
      if ((levels >> static_cast<unsigned>(level) & 1) == 0) continue;
      const double reach = std::min(radius, 2 * edges_[level]);
      const Cell own = cell_of(center, level);
      if (const Block* block = find_block(block_of(own), level); block && has_any(*block, own, is_wanted)) return true;
      const Cell first = cell_of({center.x - reach, center.y - reach, center.z - reach}, level);
      const Cell last = cell_of({center.x + reach, center.y + reach, center.z + reach}, level);
      const Cell first_block = block_of(first);
      const Cell last_block = block_of(last);
      Cell at{};
      for (at.x = first_block.x; at.x <= last_block.x; ++at.x)
        for (at.y = first_block.y; at.y <= last_block.y; ++at.y)
          for (at.z = first_block.z; at.z <= last_block.z; ++at.z)
            if (const Block* block = find_block(at, level))
              if (any_between(*block, at, first, last, own, is_wanted)) return true;
    }
    return false;
  }

 private:
  static constexpr int most_levels = 15;
  /// Edge of a block, in cells: 1 << block_bits.
  static constexpr unsigned block_bits = 2;
  /// In place of a level: a region as large as a block of level 0 and, as bits, the levels of the points in and around
  /// it; the upper bits are those of the points in it.
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
    int value = 0;  ///< the number of a block, or bits
  };
  struct Block {
    std::uint64_t filled = 0;    ///< a bit per cell
    std::array<int, 64> last{};  ///< per cell the point that was added last, where its bit is set
  };

  Cell cell_of(const Point_3& p, int level) const {
    const double per_cell = per_edge_[level];
    return {static_cast<std::int64_t>(std::floor(p.x * per_cell)),
            static_cast<std::int64_t>(std::floor(p.y * per_cell)),
            static_cast<std::int64_t>(std::floor(p.z * per_cell))};
  }
  static Cell block_of(const Cell& cell) { return {cell.x >> block_bits, cell.y >> block_bits, cell.z >> block_bits}; }
  static unsigned place_in_block(const Cell& cell) {
    constexpr std::int64_t mask = (1 << block_bits) - 1;
    return static_cast<unsigned>((cell.x & mask) << 2 * block_bits | (cell.y & mask) << block_bits | (cell.z & mask));
  }
  Cell region_of(const Point_3& p) const { return block_of(cell_of(p, 0)); }
  std::size_t slot_of(const Name& name) const;
  const Entry* find(const Name& name) const {
    if (slots_.empty()) return nullptr;
    const int entry = slots_[slot_of(name)];
    return entry < 0 ? nullptr : &entries_[entry];
  }
  int levels_around(const Point_3& p) const {
    const Entry* here = find({region_of(p), around});
    return here ? here->value : 0;
  }
  const Block* find_block(const Cell& block, int level) const {
    const Entry* entry = find({block, level});
    return entry ? &blocks_[entry->value] : nullptr;
  }
  template <class Is_wanted>
  bool has_any(const Block& block, const Cell& cell, const Is_wanted& is_wanted) const {
    const unsigned place = place_in_block(cell);
    if ((block.filled >> place & 1U) == 0) return false;
    for (int i = block.last[place]; i >= 0; i = next_[i])
      if (is_wanted(i)) return true;
    return false;
  }
  /// Of the cells of the block at `at` between two corners, but for one.
  template <class Is_wanted>
  bool any_between(const Block& block, const Cell& at, const Cell& first, const Cell& last, const Cell& but,
                   const Is_wanted& is_wanted) const {
    constexpr std::int64_t edge = 1 << block_bits;
    const Cell from{std::max(first.x, at.x * edge), std::max(first.y, at.y * edge), std::max(first.z, at.z * edge)};
    const Cell to{std::min(last.x, at.x * edge + edge - 1), std::min(last.y, at.y * edge + edge - 1),
                  std::min(last.z, at.z * edge + edge - 1)};
    Cell cell{};
    for (cell.x = from.x; cell.x <= to.x; ++cell.x)
      for (cell.y = from.y; cell.y <= to.y; ++cell.y)
        for (cell.z = from.z; cell.z <= to.z; ++cell.z)
          if (!(cell == but) && has_any(block, cell, is_wanted)) return true;
    return false;
  }
  Entry& find_or_add(const Name& name, int value);

  double coarsest_;
  std::array<double, most_levels> edges_{};     ///< of cells, per level
  std::array<double, most_levels> per_edge_{};  ///< one by these
  std::vector<int> slots_;                      ///< into entries_; a power of two
  std::vector<Entry> entries_;
  std::vector<Block> blocks_;
  std::vector<Point_3> points_;
  std::vector<int> next_;  ///< per point the one that was added to its cell before it
};

}  // namespace mesecina
