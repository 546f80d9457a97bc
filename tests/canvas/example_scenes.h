// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/inputs.h"
#include "core/style.h"

namespace mesecina {

/// Adds a vertex, returns its index.
int add_vertex(Primitive_set& set, double x, double y);
void add_polygon(Primitive_set& set, std::initializer_list<Point_2> ring);
/// A visible layer.
Scene_layer make_layer(std::string id, std::shared_ptr<const Primitive_set> set, Color color, double opacity = 1);

/// Every kind of primitive, drawn as lines, with values "number" 0, 1, 2, ... in element order; in [0,100] x [0,80].
std::shared_ptr<Primitive_set> every_kind();
/// Disks, triangles, a polygon with a hole and one within the hole.
std::shared_ptr<Primitive_set> areas();
/// Adds the boundary of the union of disks in general position: those of which no three meet in a point.
void add_union_boundary(Primitive_set& set, const std::vector<Disk_2>& disks);
/// In [0,100] x [0,80]: unions of disks, one with holes; lenses, one very thin; nested circles; circles that touch in
/// one vertex, from inside and from outside; two loops crossing in a vertex; and arcs that bound nothing. The values
/// "number" as above.
std::shared_ptr<Primitive_set> closed_arcs();
/// 6 x 4 pixels of many colours and opacities, 5 units each, from (60, 50) on.
std::shared_ptr<Primitive_set> picture();
/// All of the above in layers of several styles.
Scene example_scene();

}  // namespace mesecina
