// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/point.h"

namespace mesecina {

/// Where in the data something is that the user is told of.
struct Place {
  Point_3 position;         ///< in the plane z is 0
  std::string input = {};   ///< id of the input that it is an element of; empty for no element
  std::size_t element = 0;  ///< its number in that input
  bool operator==(const Place&) const = default;
};

/// What the user is told of the data, and where it is; of very many places only the first ones.
struct Remark {
  std::string text;
  std::vector<Place> places = {};
  bool operator==(const Remark&) const = default;
};
inline constexpr std::size_t most_places = 1000;

/// What a window shows of the places: all of them, with enough of the data around them to see where they are. Empty for
/// no places. `data`: the box of all of it.
inline Box box_around(const std::vector<Place>& places, const Box& data) {
  constexpr double part_of_data = 0.03;
  const double around = part_of_data * data.diagonal();
  const Point_3 margin{around, around, around};
  Box box;
  for (const Place& place : places) {
    box.add(place.position - margin);
    box.add(place.position + margin);
  }
  return box;
}

}  // namespace mesecina
