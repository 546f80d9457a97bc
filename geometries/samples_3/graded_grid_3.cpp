// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/samples_3/graded_grid_3.h"

#include <bit>

namespace mesecina {

std::size_t Graded_grid_3::slot_of(const Name& name) const {
  constexpr std::uint64_t mix = 0x9E3779B97F4A7C15U;
  std::uint64_t hash = (static_cast<std::uint64_t>(name.cell.x) + static_cast<std::uint64_t>(name.level + 1)) * mix;
  hash = (std::rotl(hash, 23) ^ static_cast<std::uint64_t>(name.cell.y)) * mix;
  hash = (std::rotl(hash, 23) ^ static_cast<std::uint64_t>(name.cell.z)) * mix;
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = static_cast<std::size_t>(hash >> 20U) & mask;
  while (slots_[slot] >= 0 && !(entries_[slots_[slot]].name == name)) slot = (slot + 1) & mask;
  return slot;
}

Graded_grid_3::Entry& Graded_grid_3::find_or_add(const Name& name, int value) {
  if (2 * (entries_.size() + 1) > slots_.size()) {
    constexpr std::size_t least = 1024;
    slots_.assign(std::max(least, 2 * slots_.size()), -1);
    for (std::size_t i = 0; i < entries_.size(); ++i) slots_[slot_of(entries_[i].name)] = static_cast<int>(i);
  }
  int& entry = slots_[slot_of(name)];
  if (entry < 0) {
    entry = static_cast<int>(entries_.size());
    entries_.push_back({name, value});
  }
  return entries_[entry];
}

void Graded_grid_3::add(const Point_3& p, double spacing) {
  const int level = std::clamp(static_cast<int>(std::floor(std::log2(coarsest_ / spacing))), 0, most_levels - 1);
  const Cell cell = cell_of(p, level);
  const int number = find_or_add({block_of(cell), level}, static_cast<int>(blocks_.size())).value;
  if (number == static_cast<int>(blocks_.size())) blocks_.emplace_back();
  Block& block = blocks_[number];
  const unsigned place = place_in_block(cell);
  const bool is_first_of_block = block.filled == 0;
  const bool is_first_of_cell = (block.filled >> place & 1U) == 0;
  block.filled |= std::uint64_t{1} << place;
  next_.push_back(is_first_of_cell ? -1 : block.last[place]);
  block.last[place] = static_cast<int>(points_.size());
  points_.push_back(p);
  if (!is_first_of_block) return;
  const Cell region = region_of(p);
  const int is_in = 1 << (most_levels + level);
  int& levels = find_or_add({region, around}, 0).value;
  if ((levels & is_in) != 0) return;
  levels |= is_in;
  // Whoever looks from a neighbouring region shall know of it.
  for (std::int64_t x = region.x - 1; x <= region.x + 1; ++x)
    for (std::int64_t y = region.y - 1; y <= region.y + 1; ++y)
      for (std::int64_t z = region.z - 1; z <= region.z + 1; ++z)
        find_or_add({{x, y, z}, around}, 0).value |= 1 << level;
}

}  // namespace mesecina
