// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "geometries/solid_3/solid_3.h"
#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// A place where a union of balls is connected in another way than the solid that it stands for.
struct Union_defect_3 {
  Point_3 place;
  bool is_hole = false;                      ///< in the solid and not in the union, else the other way round
  std::array<int, 4> balls{-1, -1, -1, -1};  ///< two to four, to which it has the same power distance
};

/// The critical points of the power distance to the balls that lie in the solid and not in the union, or, with a power
/// of at least -`reach`^2, the other way round. Where there are none, balls that grow or shrink to the boundary of the
/// solid never change their topology. To rounding; none for balls in one plane. O(n).
/// [H. Edelsbrunner: Surface reconstruction by wrapping finite sets in space, 2003; T. Dey, J. Giesen, S. Goswami:
/// Shape segmentation and matching with flow discretization, 2003]
std::vector<Union_defect_3> union_defects(const Regular_3& regular, const Solid_3& solid, double reach,
                                          Progress& progress);

/// Points of arcs of the boundary of a union, where two spheres meet, at which it lies more than `depth` below the
/// tangent cone of their balls: where such a union is most likely to have pits. A few per arc. O(n).
std::vector<Point_3> deep_arc_points(const Regular_3& regular, double depth, Progress& progress);

}  // namespace mesecina
