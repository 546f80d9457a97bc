// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/formats/number.h"
#include "core/primitives.h"
#include "core/registry.h"

namespace mesecina {

inline Point_3 lifted(const Point_2& p) { return {p.x, p.y, 0}; }

inline std::vector<Point_3> lifted(std::span<const Point_2> points) {
  std::vector<Point_3> result;
  result.reserve(points.size());
  for (const Point_2& p : points) result.push_back(lifted(p));
  return result;
}

/// Appends a segment with two vertices of its own.
inline void add_segment(Primitive_set& set, const Point_2& p, const Point_2& q) {
  const int v = static_cast<int>(set.vertices.size());
  set.vertices.push_back(lifted(p));
  set.vertices.push_back(lifted(q));
  set.segments.push_back({v, v + 1});
}

/// Appends a point or a disk with a vertex of its own.
inline void add_point(Primitive_set& set, const Point_2& p) {
  set.points.push_back(static_cast<int>(set.vertices.size()));
  set.vertices.push_back(lifted(p));
}
inline void add_disk(Primitive_set& set, const Point_2& center, double radius) {
  set.balls.push_back({static_cast<int>(set.vertices.size()), radius});
  set.vertices.push_back(lifted(center));
}

/// The same elements, without the vertices that none of them uses.
inline Primitive_set without_unused_vertices(const Primitive_set& set) {
  return select(set, std::vector<bool>(set.element_count(), true));
}

inline Fact fact(std::string name, double value, std::string_view unit = "") {
  std::string text = format_number(value);
  if (!unit.empty()) (text += ' ') += unit;
  return {std::move(name), std::move(text)};
}
inline Fact fact(std::string name, const Point_2& p) {
  return {std::move(name), "(" + format_number(p.x) + ", " + format_number(p.y) + ")"};
}

/// "1, 2 and 3".
inline std::string enumeration(std::span<const int> numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0) text.append(i + 1 == numbers.size() ? " and " : ", ");
    text.append(std::to_string(numbers[i]));
  }
  return text;
}

/// A default look. Modules choose colours so that the layers of one picture can be told apart, also by the
/// colour-blind.
inline Style look(Color color, double line_width = 1.5) {
  Style style;
  style.color = color;
  style.line_width = line_width;
  return style;
}

}  // namespace mesecina
