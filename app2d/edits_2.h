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

/// Points, vertices of outlines and disks, all sorted, each once.
struct Selection_2 {
  std::vector<std::size_t> points{};
  std::vector<Vertex_2> vertices{};
  std::vector<std::size_t> disks{};
  bool is_empty() const { return points.empty() && vertices.empty() && disks.empty(); }
  std::size_t size() const { return points.size() + vertices.size() + disks.size(); }
  bool operator==(const Selection_2&) const = default;
};

/// What can be taken hold of.
struct Reach_2 {
  bool points = true;
  bool vertices = true;
  bool disks = true;
};

// Each of these is linear in the size of the inputs, and what they return holds only the keys that the inputs had,
// unless it says so. Selections that point beyond the data are ignored there.

/// The nearest point, vertex or center of a disk within `radius`, in this order at the same distance; where there is
/// none of them, the disk whose boundary is nearest within `radius`. Empty if that is none, too.
Selection_2 nearest(const Inputs& inputs, const Reach_2& reach, const Point_2& position, double radius);
Selection_2 all_of(const Inputs& inputs, const Reach_2& reach);
/// Of the disks those whose center is in the box.
Selection_2 inside(const Inputs& inputs, const Reach_2& reach, const Box& box);
/// What is in exactly one of them.
Selection_2 toggled(const Selection_2& first, const Selection_2& second);
Selection_2 united(const Selection_2& first, const Selection_2& second);
bool contains(const Selection_2& selection, const Selection_2& part);
/// Without what the inputs do not have.
Selection_2 restricted(const Selection_2& selection, const Inputs& inputs);

/// Of points, vertices and centers of disks, in this order.
std::vector<Point_2> positions(const Inputs& inputs, const Selection_2& selection);
std::vector<Disk_2> selected_disks(const Inputs& inputs, const Selection_2& selection);
Inputs moved(const Inputs& inputs, const Selection_2& selection, double dx, double dy);
/// With the radii of the selected disks multiplied. A radius that would not stay finite, or positive if it is so, is
/// kept.
Inputs resized(const Inputs& inputs, const Selection_2& selection, double factor);
/// Rings with fewer than three vertices left go, and so do points, outlines and disks without anything left.
Inputs without(const Inputs& inputs, const Selection_2& selection);
/// The points are appended; there need not have been any.
Inputs with_points(const Inputs& inputs, const std::vector<Point_2>& points);
/// As with_points.
Inputs with_disks(const Inputs& inputs, const std::vector<Disk_2>& disks);
/// Does nothing for fewer than three vertices.
Inputs with_ring(const Inputs& inputs, Ring_2 ring);
/// Everything of both: points, disks and rings of `more` come after those of `inputs`; its image replaces the other.
Inputs appended(const Inputs& inputs, const Inputs& more);
/// With copies of the selected points and disks, and of the rings that are selected as a whole, moved by (dx, dy). The
/// second is the selection of the copies.
std::pair<Inputs, Selection_2> duplicated(const Inputs& inputs, const Selection_2& selection, double dx, double dy);
/// The first point, vertex or center of a disk of the selection is placed there.
Inputs placed(const Inputs& inputs, const Selection_2& selection, const Point_2& position);
/// With another disk under this index.
Inputs with_disk(const Inputs& inputs, std::size_t index, const Disk_2& disk);

/// "x y" lines of points and "x y radius" lines of disks, in shortest round-trip form. Where there are both, a line
/// with the names of the columns comes before each kind.
std::string to_table(const std::vector<Point_2>& points, const std::vector<Disk_2>& disks = {});
/// The parts of such a text that a reader of tables takes one by one, each with as many empty lines before it as there
/// were lines of other parts: numbers of lines stay true.
std::vector<std::string> table_parts(const std::string& text);

}  // namespace mesecina
