// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "core/point.h"
#include "core/portable_random.h"
#include "core/progress.h"
#include "geometries/crust_2/one_step_crust.h"
#include "geometries/delaunay_2/delaunay_2.h"

namespace mesecina {

/// Points in some order along curves: per point the two that come before and after it, {-1, -1} where it does not have
/// exactly two neighbours (ends of curves, crossings, isolated points).
using Curve_neighbors_2 = std::vector<std::array<int, 2>>;

/// The neighbours on the crust, the lesser first; points with equal coordinates have the same. O(n).
Curve_neighbors_2 crust_neighbors(const Delaunay_2& triangulation, const Crust_2& crust);
/// The neighbours along a ring of `count` vertices; rings of less than three have none.
Curve_neighbors_2 ring_neighbors(std::size_t count);
bool has_neighbors(const Curve_neighbors_2& neighbors);

/// Every point with neighbours moves toward the middle between them by one factor after the other, all at once. O(n).
std::vector<Point_2> smoothed(std::vector<Point_2> points, const Curve_neighbors_2& neighbors,
                              std::span<const double> factors);

/// The rule of the cubic B-spline: a point with neighbours a and b moves to 3/4 of itself and 1/8 of each, the others
/// stay; then come the middles of the edges, in their order. O(n + edges).
std::vector<Point_2> subdivided(std::span<const Point_2> points, const Curve_neighbors_2& neighbors,
                                std::span<const std::array<int, 2>> edges);
/// The same for a ring, with the middles where they belong.
std::vector<Point_2> subdivided_ring(std::span<const Point_2> ring);

/// Every point with neighbours moves at right angles to the line through them, by up to `amplitude` times their
/// distance to either side, evenly at random. O(n).
std::vector<Point_2> with_noise(std::vector<Point_2> points, const Curve_neighbors_2& neighbors, double amplitude,
                                Portable_random& random);

}  // namespace mesecina
