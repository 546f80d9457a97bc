// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// A vertex of an outline.
struct Vertex_2 {
  std::size_t ring = 0;
  std::size_t vertex = 0;
  auto operator<=>(const Vertex_2&) const = default;
};

/// Points and vertices of outlines, both sorted, each once.
struct Selection_2 {
  std::vector<std::size_t> points;
  std::vector<Vertex_2> vertices;
  bool is_empty() const { return points.empty() && vertices.empty(); }
  std::size_t size() const { return points.size() + vertices.size(); }
  bool operator==(const Selection_2&) const = default;
};

/// What can be taken hold of.
struct Reach_2 {
  bool points = true;
  bool vertices = true;
};

// Each of these is linear in the size of the inputs, and what they return holds only the keys that the inputs had,
// unless it says so. Selections that point beyond the data are ignored there.

/// The nearest point or vertex within `radius`; a point before a vertex at the same distance. Empty if there is none.
Selection_2 nearest(const Inputs& inputs, const Reach_2& reach, const Point_2& position, double radius);
Selection_2 all_of(const Inputs& inputs, const Reach_2& reach);
Selection_2 inside(const Inputs& inputs, const Reach_2& reach, const Box& box);
/// What is in exactly one of them.
Selection_2 toggled(const Selection_2& first, const Selection_2& second);
Selection_2 united(const Selection_2& first, const Selection_2& second);
bool contains(const Selection_2& selection, const Selection_2& part);
/// Without what the inputs do not have.
Selection_2 restricted(const Selection_2& selection, const Inputs& inputs);

std::vector<Point_2> positions(const Inputs& inputs, const Selection_2& selection);
Inputs moved(const Inputs& inputs, const Selection_2& selection, double dx, double dy);
/// Rings with fewer than three vertices left go, and so do points and outlines without anything left.
Inputs without(const Inputs& inputs, const Selection_2& selection);
/// The points are appended; there need not have been any.
Inputs with_points(const Inputs& inputs, const std::vector<Point_2>& points);
/// Does nothing for fewer than three vertices.
Inputs with_ring(const Inputs& inputs, Ring_2 ring);
/// Everything of both: points, disks and rings of `more` come after those of `inputs`; its image replaces the other.
Inputs appended(const Inputs& inputs, const Inputs& more);
/// With copies of the selected points, and of the rings that are selected as a whole, moved by (dx, dy). The second
/// is the selection of the copies.
std::pair<Inputs, Selection_2> duplicated(const Inputs& inputs, const Selection_2& selection, double dx, double dy);
/// The first point or vertex of the selection is placed there.
Inputs placed(const Inputs& inputs, const Selection_2& selection, const Point_2& position);

/// "x y" lines in shortest round-trip form.
std::string to_table(const std::vector<Point_2>& points);

}  // namespace mesecina
