// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/territories_3.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace mesecina {

namespace {

struct Choice {
  int axis = 0;
  double at = 0;
  double cost = 0;  ///< things in neither half, and those in the larger one
};

/// The best of some cuts; nullopt where all leave too much to one thread.
std::optional<Choice> best_cut(std::span<const Territories_3::Reach> things) {
  constexpr std::size_t tried = 64;
  constexpr std::size_t least = 2 * tried;
  constexpr double most_cost = 0.85;
  if (things.size() < least) return std::nullopt;
  std::optional<Choice> best;
  std::vector<double> lower(things.size());
  std::vector<double> upper(things.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < things.size(); ++i) {
      lower[i] = things[i].lower[axis];
      upper[i] = things[i].upper[axis];
    }
    std::ranges::sort(lower);
    std::ranges::sort(upper);
    for (std::size_t k = 1; k < tried; ++k) {
      const double at = lower[k * lower.size() / tried];
      const auto below = static_cast<double>(std::ranges::lower_bound(upper, at) - upper.begin());
      const auto above = static_cast<double>(lower.end() - std::ranges::lower_bound(lower, at));
      const double cost = static_cast<double>(things.size()) - std::min(below, above);
      if (!best || cost < best->cost) best = Choice{axis, at, cost};
    }
  }
  if (best->cost > most_cost * static_cast<double>(things.size())) return std::nullopt;
  return best;
}

}  // namespace

Territories_3 Territories_3::around(std::span<const Reach> things, int most_boxes) {
  Territories_3 result;
  int boxes = 0;
  result.add({things.begin(), things.end()}, most_boxes, boxes);
  return result;
}

/// Returns the cut, or -1 - box.
int Territories_3::add(std::vector<Reach> things, int most_boxes, int& boxes) {
  const std::optional<Choice> choice = most_boxes > 1 ? best_cut(things) : std::nullopt;
  if (!choice) return -1 - boxes++;
  const auto [axis, at, cost] = *choice;
  const auto number = static_cast<int>(cuts_.size());
  cuts_.push_back({axis, at});
  std::vector<Reach> below;
  std::vector<Reach> above;
  for (const Reach& thing : things) {
    if (thing.upper[axis] < at) below.push_back(thing);
    if (thing.lower[axis] >= at) above.push_back(thing);
  }
  things = {};
  const int first = add(std::move(below), most_boxes / 2, boxes);
  const int second = add(std::move(above), most_boxes - most_boxes / 2, boxes);
  cuts_[number].below = first;
  cuts_[number].above = second;
  return number;
}

}  // namespace mesecina
