// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/inputs.h"
#include "core/primitives.h"
#include "core/progress.h"
#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// The poles of samples in space, each once, as balls. The first pole of a sample is the farthest vertex of its Voronoi
/// cell; the second one is the farthest of those that lie on the other side of the sample (at an obtuse angle to the
/// first). Both are chosen by exact comparisons of Voronoi vertices; tetrahedra with one sphere are one Voronoi vertex,
/// exactly. Of equally far vertices the first in the order of the triangulation is the pole. Centers and radii are
/// rounded.
///
/// Eight corners of a cube about 1024 times as large as the samples bound the cells of samples on the convex hull.
/// Voronoi vertices that have one of them are *infinite*: their balls stand for the half-spaces behind the facets of
/// the hull. All of these are here, also those that are no sample's pole; they surround the others, and so the power
/// crust is closed. A sample that has infinite vertices points outward in the direction of the sum of their directions:
/// the nearest to that one is its first pole, and the farthest finite vertex at an obtuse angle to it the second. These
/// directions are rounded.
/// [N. Amenta, S. Choi, R. Kolluri: The power crust, 2001]
struct Poles_3 {
  std::vector<Point_3> points;   ///< the samples and behind them the eight corners
  std::size_t sample_count = 0;  ///< equal samples included
  std::vector<Ball_3> balls;     ///< first the finite poles, then the infinite ones
  std::size_t finite_count = 0;
  std::vector<int> contact_offsets;  ///< size() + 1 offsets into `contacts`
  std::vector<int> contacts;         ///< per pole the points on its sphere, ascending
  std::vector<int> first;            ///< per sample its first pole; -1 for those that equal another one
  std::vector<int> second;           ///< per sample its second pole; -1 for samples without one
  std::vector<int> sample_offsets;   ///< size() + 1 offsets into `samples`
  std::vector<int> samples;          ///< per pole the samples whose pole it is, ascending

  std::size_t size() const { return balls.size(); }
  bool is_infinite(int pole) const { return pole >= static_cast<int>(finite_count); }
  std::span<const int> contacts_of(int pole) const {
    return std::span(contacts).subspan(contact_offsets[pole], contact_offsets[pole + 1] - contact_offsets[pole]);
  }
  std::span<const int> samples_of(int pole) const {
    return std::span(samples).subspan(sample_offsets[pole], sample_offsets[pole + 1] - sample_offsets[pole]);
  }
  /// The other pole of a sample that this is a pole of; -1 if it has none.
  int opposite(int pole, int sample) const { return first[sample] == pole ? second[sample] : first[sample]; }
};

/// Coordinates must be finite. O(n log n) for points of a surface. Throws Cancelled, and Unavailable where the points
/// make no tetrahedron: fewer than four different ones, all in one plane, or so nearly that each sphere through four of
/// them has a radius of a thousand diagonals.
Poles_3 find_poles(const std::vector<Point_3>& samples, Progress& progress);

/// Poles with their sides of the shape.
struct Polar_balls_3 {
  std::shared_ptr<const Poles_3> poles;
  std::shared_ptr<const Regular_3> regular;  ///< of all balls of the poles
  std::vector<std::uint8_t> is_inner;        ///< per pole; infinite ones are outer
  /// Per pole how sure its side is, in (0,1]; 0 for those that nothing reached: they count as outer, for want of
  /// better.
  std::vector<double> confidence;
  std::vector<int> contradictions;  ///< samples with both poles on one side, ascending
  std::size_t unlabelled_count = 0;
};

/// Labels poles as in the plane (power_crust_2.h): infinite ones are outer; a labelled pole tells the other poles of
/// its samples that they are on the other side, the surer the nearer to opposite they lie, and its neighbours in the
/// regular triangulation that they are on the same side, by the cosine of the angle at which the balls meet, if that is
/// positive; the surest goes first, of equally sure ones that with the lesser number. O(n log n). `regular`: the
/// regular triangulation of the poles' balls. Cosines are rounded: on symmetric samples rounding may decide which of
/// two equally sure poles goes first, the same on every run.
Polar_balls_3 label_poles(std::shared_ptr<const Poles_3> poles, std::shared_ptr<const Regular_3> regular,
                          Progress& progress);

/// Cosine of the angle between two balls, rounded: 1 for equal ones, 0 where they meet at a right angle, -1 where they
/// touch from outside; beyond [-1,1] where they are apart or nested.
double intersection_cosine(const Poles_3& poles, int a, int b);

/// The finite inner poles in their order, centers moved by up to `perturbation` times the radius, as inner_poles of
/// samples_3.h does for a mesh. Throws Unavailable when there are none.
std::vector<Ball_3> inner_polar_balls(const Polar_balls_3& polar, double perturbation);

/// Faces of the power diagram of the poles between an inner and an outer one: polygons with shared vertices. Normals
/// (right-hand rule) point to the outer pole. The surface is closed, a manifold: it has two faces along every edge, and
/// the topology of the boundary of the power shape.
///
/// The faces are those of the regular triangulation, which is exact for the rounded balls. Spheres through one sample
/// meet there: cells of the triangulation whose balls all have one sample on their spheres have their vertex at this
/// sample, by construction. Such vertices that edges join are one, and edges and faces between them are none; unless
/// that would pinch the surface. Vertices of other cells are rounded.
struct Power_crust_3 {
  std::vector<Point_3> vertices;
  std::vector<int> samples;  ///< per vertex the sample that it is; -1 for none
  std::vector<int> face_offsets;
  std::vector<int> face_vertices;
  std::vector<std::array<int, 2>> poles;  ///< per face the inner and the outer one

  std::size_t face_count() const { return poles.size(); }
  std::span<const int> face(std::size_t i) const {
    return std::span(face_vertices).subspan(face_offsets[i], face_offsets[i + 1] - face_offsets[i]);
  }
};
/// O(n). No faces where no pole is inner.
Power_crust_3 power_crust(const Polar_balls_3& polar, Progress& progress);

/// The simplices of the regular triangulation whose corners are all inner, with their kinds in this complex; none of
/// its cells counts as flat. O(n log n).
Dual_3 power_shape(const Polar_balls_3& polar, Progress& progress);

}  // namespace mesecina
