// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <CGAL/Exact_rational.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometries/crust_2/one_step_crust.h"
#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/labels_2/labels_2.h"

/// Slow code that follows the definitions, every decision in exact rational arithmetic.
namespace mesecina::test {

using Rational = CGAL::Exact_rational;

struct Exact_point {
  Rational x;
  Rational y;
};
Exact_point exact(const Point_2& p);

/// Sign of the area of pqr: 1 counterclockwise, 0 on a line.
int orientation(const Point_2& p, const Point_2& q, const Point_2& r);
/// 1 if d is strictly inside the circle through a, b, c (counterclockwise), 0 on it, -1 outside.
int in_circle(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d);
/// The same by rational arithmetic alone, without a filter.
int in_circle_by_rationals(const Point_2& a, const Point_2& b, const Point_2& c, const Point_2& d);
bool is_on_segment(const Point_2& p, const Point_2& q, const Point_2& r);
/// pqr must not be on a line.
Exact_point exact_circumcenter(const Point_2& p, const Point_2& q, const Point_2& r);

bool exact_is_crust_edge(const Point_2& p, const Point_2& q, const Point_2& r, const Point_2& s);
bool exact_is_crust_hull_edge(const Point_2& p, const Point_2& q, const Point_2& r);
/// Even-odd rule by crossing every edge with the ray to the right.
bool exact_is_inside(const Outline_2& outline, const Point_2& query);
bool is_on_boundary(const Outline_2& outline, const Point_2& query);

using Edge = std::array<int, 2>;
using Triangle = std::array<int, 3>;
Edge sorted_edge(Edge edge);
std::vector<Edge> sorted_edges(std::span<const Edge> edges);
/// Least corner first, same orientation; the triangles sorted.
std::vector<Triangle> normalized(std::vector<Triangle> triangles);

/// Whether the arrays are a Delaunay triangulation of `points`, in every respect the header promises.
/// Up to 300 sites every triangle is tried against every site, above that against its neighbours.
testing::AssertionResult is_delaunay(const Delaunay_2& triangulation, std::span<const Point_2> points);
/// Fields equal, bit for bit.
testing::AssertionResult is_identical(const Delaunay_2& a, const Delaunay_2& b);

/// Every Delaunay edge in the crust, by definition, sorted.
std::vector<Edge> crust_by_definition(const Delaunay_2& triangulation);
/// Every edge across which the labels do not do what the crust says; outside of the hull is outside. Sorted.
std::vector<Edge> conflicts_by_definition(const Delaunay_2& triangulation, const Crust_2& crust,
                                          std::span<const std::uint8_t> is_inner);
/// True iff no point has an odd number of crust edges, which is when labels without conflicts exist.
bool crust_separates(const Delaunay_2& triangulation, const Crust_2& crust);

}  // namespace mesecina::test
