// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

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
/// 6 x 4 pixels of many colours and opacities, 5 units each, from (60, 50) on.
std::shared_ptr<Primitive_set> picture();
/// All of the above in layers of several styles.
Scene example_scene();

}  // namespace mesecina
