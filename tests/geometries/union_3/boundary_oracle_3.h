// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "tests/geometries/union_3/power_oracle_3.h"

namespace mesecina::test {

/// Distances to the boundary of a union of at most 32 balls, by trying every patch, every circle and every vertex. To
/// rounding, on what exact arithmetic says of the vertices.
class Boundary_oracle_3 {
 public:
  explicit Boundary_oracle_3(std::span<const Ball_3> balls);

  /// Size of the union.
  double scale() const { return scale_; }
  /// What rounding may do to a position.
  double precision() const { return precision_; }
  /// V(U).
  const std::vector<Point_3>& vertices() const { return vertices_; }

  bool is_inside(const Point_3& point) const;
  /// Whether it is nearly on a sphere, and not clearly in the interior of a ball.
  bool is_on_boundary(const Point_3& point, double tolerance) const;
  /// A nearest point of the boundary, for points inside.
  Point_3 nearest(const Point_3& point) const;
  double distance_to_boundary(const Point_3& point) const { return distance(point, nearest(point)); }

 private:
  bool is_free(const Point_3& point) const;

  std::vector<Ball_3> balls_;
  std::vector<Point_3> vertices_;
  std::vector<Point_3> surrounded_;  ///< points on spheres but inside
  struct Circle {
    Point_3 center;
    Point_3 axis;  ///< unit length
    double radius = 0;
  };
  std::vector<Circle> circles_;
  double scale_ = 0;
  double precision_ = 0;
};

/// Distance to a triangle, which may be flat.
double distance_to_triangle(const Point_3& point, const Point_3& a, const Point_3& b, const Point_3& c);
double distance_to_segment(const Point_3& point, const Point_3& a, const Point_3& b);

/// A Voronoi face of two sites: the part of their bisecting plane that is nearer to no other site, as a polygon within
/// a cube of so much size around the first one. Empty where there is none with area.
std::vector<Point_3> voronoi_face(std::span<const Point_3> sites, int a, int b, double size);

}  // namespace mesecina::test
