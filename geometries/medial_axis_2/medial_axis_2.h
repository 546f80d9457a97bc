// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/labels_2/labels_2.h"

namespace mesecina {

/// Medial axis of a sampled shape: the inner Voronoi vertices and the Voronoi edges between two of them. Neighbouring
/// triangles with one circle (decided exactly) have one Voronoi vertex, so one ball, and no edge between them.
/// [B. Miklos: The Scale Axis Transform, 2010, Theorem 8 and section 4.3.3]
struct Medial_axis_2 {
  std::vector<Point_2> centers;  ///< of the medial balls
  std::vector<double> radii;     ///< of the medial balls
  /// Per ball a Delaunay triangle with its circle, the largest if there are several: its corners are contact points.
  std::vector<int> triangles;
  std::vector<std::array<int, 2>> further_triangles;  ///< pairs of a ball and another triangle with its circle, sorted
  std::vector<std::array<int, 2>> edges;              ///< pairs of balls
  /// Per edge the two samples that it lies between (points of the Delaunay triangulation), the lesser first. No two
  /// edges have the same.
  std::vector<std::array<int, 2>> contacts;
};

/// O(n) in practice.
Medial_axis_2 medial_axis(const Delaunay_2& triangulation, const Voronoi_2& voronoi, const Labels_2& labels,
                          Progress& progress);

/// The samples on the circle of a ball, ascending. O(log n) and the size of what it returns.
std::vector<int> contacts_of_ball(const Delaunay_2& triangulation, const Medial_axis_2& axis, int ball);

/// Per edge of the axis: half the distance of its contact points.
std::vector<double> lambda_of_edges(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress);
/// Per edge: the largest contact angle on it, in degrees in (0,180]: that at its point nearest to the midpoint of the
/// contact points, 180 if the edge passes between them.
std::vector<double> angle_of_edges(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress);
/// Per ball: radius of the smallest circle that encloses its contact points.
std::vector<double> lambda_of_balls(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress);
/// Per ball: the largest angle, in degrees, between two contact points seen from the center.
std::vector<double> angle_of_balls(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress);
/// Per ball: the slope, in [0,1], at which the distance to the nearest contact point grows from the center in the
/// direction in which it grows fastest: the cosine of half the angle of the ball, 0 where it grows in none.
std::vector<double> slope_of_balls(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress);
/// Per ball the least d / (r' - r) over larger balls at the other ends of its edges, at least 1; +infinity where there
/// is none. From the contact points, without the cancellation that leaves nothing of it where two balls nearly
/// coincide; edges at triangles too thin for that are left out.
std::vector<double> scale_along_edges(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress);

}  // namespace mesecina
