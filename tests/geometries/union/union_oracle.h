// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <vector>

#include "tests/geometries/union/power_oracle.h"

/// The boundary of a union of closed disks by definition: all pairs of circles, exact decisions, positions of 50
/// digits.
namespace mesecina::test {

using Real = boost::multiprecision::cpp_bin_float_100;

struct Oracle_vertex {
  Real x;
  Real y;
  std::vector<int> sources;  ///< all disks whose circles pass through it, ascending; equal and hidden ones too
  /// Half the distance of the two points where the pair of source circles meets that meets most steeply, relative to
  /// the lesser radius: positions in doubles are uncertain by rounding divided by it.
  double steepness = 0;

  Point_2 point() const { return {static_cast<double>(x), static_cast<double>(y)}; }
};

/// Part of a circle that no disk covers, counterclockwise; -1, -1 for a whole circle without a vertex.
struct Oracle_arc {
  int ball = 0;
  int from = -1;
  int to = -1;
  auto operator<=>(const Oracle_arc&) const = default;
};

/// A disk to 100 digits.
struct Real_disk {
  Real x;
  Real y;
  Real weight;
  Real radius;  ///< 0 for an empty disk
};

struct Union_oracle {
  std::vector<Exact_disk> disks;
  std::vector<Real_disk> real_disks;
  std::vector<int> representative;  ///< per disk the least equal one; -1 for an empty disk
  std::vector<Oracle_vertex> vertices;
  std::vector<Oracle_arc> arcs;  ///< of disks that represent themselves
  int component_count = 0;       ///< of the union, by intersecting disks
  int curve_count = 0;           ///< boundary curves, each with the outside on its right
  int hole_count = 0;            ///< bounded components of the complement

  std::vector<Point_2> centers;  ///< rounded
  std::vector<double> radii;     ///< rounded; 0 for an empty disk
  double scale = 0;              ///< largest coordinate or radius

  /// To the nearest vertex; infinite without one.
  double vertex_distance(const Point_2& query) const;
  /// To the nearest point within an arc, if a nearest one of an arc is not at its ends; else infinite.
  double arc_distance(const Point_2& query) const;
  double boundary_distance(const Point_2& query) const;
  /// In one of the closed disks, to rounding: where disks surround a point it is on circles only.
  bool is_inside(const Point_2& query) const;
  /// By Green's theorem along the arcs.
  double area() const;
};

/// O(n^3).
Union_oracle union_oracle(const Balls_2& balls, double alpha = 0);

/// Whether two closed disks meet: exactly.
bool disks_meet(const Exact_disk& a, const Exact_disk& b);
Real to_real(const Rational& value);

}  // namespace mesecina::test
