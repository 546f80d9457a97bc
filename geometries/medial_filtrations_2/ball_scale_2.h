// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometries/medial_axis_2/medial_axis_2.h"
#include "geometries/scale_importance/scale_importance.h"

namespace mesecina {

/// Scale importance of the balls of a medial axis, with what an update compares.
///
/// Of two balls that nearly coincide (samples that would be cocircular but for the rounding of their coordinates)
/// centers and radii as rounded say nothing about d / (r' - r). Two facts about Delaunay disks replace them: the
/// quotient is at least 1 / slope of the smaller ball, and the ball beyond its longest contact edge attains that in the
/// limit of equal balls. So quotients of pairs are raised to the bound (scale_importance), and those of pairs with an
/// edge are also computed from their contact points (scale_along_edges).
struct Ball_scale_2 {
  std::vector<double> values;  ///< per ball, at least 1; +infinity for the largest
  std::vector<Point_2> centers;
  std::vector<double> radii;
  std::vector<int> triangles;
  std::vector<double> slopes;
  Scale_importance importance;  ///< of the balls as disks
};

/// Near-linear in practice.
Ball_scale_2 ball_scale(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress);

/// The same, equal values, from those of an earlier state of the shape; O(n) with a small constant when few balls have
/// changed and the triangles of the others have kept their numbers.
Ball_scale_2 update_ball_scale(const Ball_scale_2& previous, const Delaunay_2& triangulation, const Medial_axis_2& axis,
                               Progress& progress);

}  // namespace mesecina
