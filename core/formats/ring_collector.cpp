// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/ring_collector.h"

#include <algorithm>
#include <utility>

#include "core/formats/number.h"
#include "core/formats/outline_crossings.h"

namespace mesecina {
namespace {

void merge_equal_neighbours(Ring_2& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
}

bool has_three_distinct_vertices(const Ring_2& ring) {
  const auto second = std::ranges::find_if(ring, [&](const Point_2& p) { return p != ring.front(); });
  return std::any_of(second, ring.end(), [&](const Point_2& p) { return p != ring.front() && p != *second; });
}

}  // namespace

std::string to_text(const Point_2& point) {
  std::string text = "(";
  append_number(text, point.x);
  text += ", ";
  append_number(text, point.y);
  return text += ')';
}

void Ring_collector::add(Ring_2 vertices, End end, const std::string& place) {
  ++count_;
  const auto ring_name = [&] { return place + ": ring " + std::to_string(count_); };
  if (end == End::repeats_first && vertices.size() > 1 && vertices.front() != vertices.back()) {
    warnings_.add(ring_name() + " is not closed: it starts at " + to_text(vertices.front()) + " and ends at " +
                  to_text(vertices.back()) + "; a segment joins them");
  }
  merge_equal_neighbours(vertices);
  if (!has_three_distinct_vertices(vertices)) {
    warnings_.add(ring_name() + " has fewer than 3 distinct vertices; it is left out");
    return;
  }
  outline_.rings.push_back(std::move(vertices));
  numbers_.push_back(count_);
}

Outline_2 Ring_collector::finish() {
  if (outline_.rings.empty()) warnings_.add("the outline is empty: the file has no ring of at least 3 vertices");
  const Outline_crossings crossings = find_crossings(outline_);
  if (crossings.count != 0) {
    const auto name = [&](const Outline_side& side) {
      return "segment " + std::to_string(side.segment + 1) + " of ring " + std::to_string(numbers_[side.ring]);
    };
    warnings_.add(std::string("outline crosses itself ") + (crossings.is_complete ? "" : "at least ") +
                  std::to_string(crossings.count) + (crossings.count == 1 ? " time" : " times, first") + " near " +
                  to_text(crossings.place) + " between " + name(crossings.first) + " and " + name(crossings.second) +
                  "; inside is decided by the even-odd rule");
  }
  return std::move(outline_);
}

}  // namespace mesecina
