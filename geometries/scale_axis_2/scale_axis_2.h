// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "geometries/union_2/union_medial_axis_2.h"

namespace mesecina {

/// The medial disks at all vertices of a medial axis, as disks that are given by their rounded numbers. Their union is
/// the union of the axis, to rounding.
Balls_2 medial_balls(const Union_medial_axis_2& axis);

/// The discrete scale axis transform: disks whose union is the simplified shape, and the graph of their centers.
struct Scale_axis_2 {
  std::vector<Point_2> centers;
  std::vector<double> radii;              ///< shrunk back: divided by the scale
  std::vector<std::array<int, 2>> edges;  ///< pairs of disks
  std::vector<double> angles;             ///< per edge the contact angle, in degrees, of the edge of the grown axis
  std::vector<double> monotone_angles;    ///< the same after the topology-preserving pass; +infinity: never removed
};

/// From the medial axis of the grown union: leaves with a contact angle of less than `min_angle` degrees are removed,
/// in order, as long as the topology stays; then edges are halved until disks at the ends of an edge, once shrunk by
/// `scale`, meet at no less than `sampling_min_angle` degrees (180: one within the other; values of 179 and more are
/// taken as 179). Incomplete edges of the axis are left out. Near a point where two disks only touch, radii go to zero
/// and halving stops after 24 steps. Throws Unavailable when that would give more than 20 million disks. O(output).
/// [B. Miklos: The Scale Axis Transform, 2010, section 6.1.2]
Scale_axis_2 scale_axis(const Union_medial_axis_2& grown_axis, double scale, double min_angle,
                        double sampling_min_angle, Progress& progress);

}  // namespace mesecina
