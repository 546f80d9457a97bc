// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "geometries/delaunay_3/delaunay_3.h"
#include "tests/geometries/power_crust_3/clouds_3.h"

namespace mesecina::test {

/// Points on one sphere, ascending; of equal ones the first.
using Contacts = std::vector<int>;

/// The spheres through four points or more that are in no plane, with no point inside, by trying all; exact. They are
/// the Voronoi vertices.
std::set<Contacts> empty_spheres(const Cloud& points);

/// A plane through the points, and a third one, has nothing on one of its sides; exact. With one point given twice: a
/// plane through that point.
bool is_on_hull(const Cloud& points, int a, int b);

/// The points of the cells with one sphere, for each sphere.
std::set<Contacts> spheres_of(const Delaunay_3& triangulation);

/// Of two spheres through four of their points that are in no plane.
bool has_larger_radius(const Cloud& points, const Contacts& one, const Contacts& other);
/// The centers, seen from a point on both, lie at an obtuse angle; exact.
bool are_opposite(const Cloud& points, int from, const Contacts& one, const Contacts& other);
double radius_of(const Cloud& points, const Contacts& sphere);

}  // namespace mesecina::test
