// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_structural_filtering_traits.h>

#include <array>

namespace mesecina {

/// Five points as coordinates.
using Sphere_query_3 = std::array<std::array<double, 3>, 5>;

/// On which side of the oriented sphere through the first four points the fifth one lies, with the signs of CGAL;
/// ON_ORIENTED_BOUNDARY when about 100 bits do not tell. Requires that rounding is to nearest. The bound of the error
/// is that of the sums and products of its determinant, each known to 2^-102.
/// [T. Dekker: A floating-point technique for extending the available precision, 1971]
CGAL::Oriented_side side_of_sphere_by_double_doubles(const Sphere_query_3& points);

/// The kernel of Delaunay triangulations of points that lie on few spheres, up to rounding: there doubles and their
/// intervals decide little, and rational numbers would have to. Exact, and the decisions are those of CGAL's kernel.
struct Sphere_kernel_3 : CGAL::Exact_predicates_inexact_constructions_kernel {
  using Base = CGAL::Exact_predicates_inexact_constructions_kernel;

  struct Side_of_oriented_sphere_3 {
    using result_type = CGAL::Oriented_side;

    CGAL::Oriented_side operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s,
                                   const Point_3& t) const;
  };
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }
};

}  // namespace mesecina

/// As of the kernel it is made of: points are located by doubles first.
template <>
struct CGAL::Triangulation_structural_filtering_traits<mesecina::Sphere_kernel_3>
    : CGAL::Triangulation_structural_filtering_traits<mesecina::Sphere_kernel_3::Base> {};
