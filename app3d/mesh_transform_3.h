// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/inputs.h"

namespace mesecina {

/// A way to move, turn, mirror and scale everything there is: about the pivot it is mirrored, scaled and turned about
/// the axes x, y and z, in this order; then shifted.
struct Transform_3 {
  Point_3 pivot;
  std::array<bool, 3> mirrored{};   ///< across the planes through the pivot whose normals are x, y, z
  double scale = 1;                 ///< positive
  std::array<double, 3> degrees{};  ///< about x, y, z, counterclockwise seen against the axis
  Point_3 shift;
  bool operator==(const Transform_3&) const = default;
};

/// Mesh, balls and points transformed. What the transformation leaves in place keeps its exact numbers; mirrors, shifts
/// about the origin and quarter turns about it are exact but for at most one rounding per coordinate. A mirrored mesh
/// has its triangles turned over, so that outside stays outside. Inputs of the plane are not touched. O(size).
Inputs transformed(const Inputs& inputs, const Transform_3& transform);

/// The same with another shift: the middle of the bounding box of the result is at the origin.
Transform_3 centered(const Inputs& inputs, Transform_3 transform);
/// The same with another scale and shift: the bounding box of the result has a diagonal of 1 and its middle at the
/// origin; only centered where there is no size.
Transform_3 normalized(const Inputs& inputs, Transform_3 transform);

}  // namespace mesecina
