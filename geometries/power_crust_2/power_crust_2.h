// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/progress.h"
#include "geometries/balls_2/balls_2.h"
#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/regular_2/regular_2.h"

namespace mesecina {

/// The poles of samples, each once, as disks. The first pole of a sample is the farthest vertex of its Voronoi cell;
/// the second one is the farthest of those that lie on the other side of the sample (at an obtuse angle to the first).
/// Triangles with one circle are one Voronoi vertex. Of equally far ones the one with the lesser samples on its circle
/// is the pole.
///
/// The cell of a sample on the hull is unbounded: its first pole is at infinity, in the direction of the sum of the
/// outward unit normals of its two hull edges. The disk of such a pole is the half-plane behind the sample; here it is
/// a disk that touches the sample from outside, with a radius of 1024 diagonals of the samples. The disks at infinity
/// close the power crust around the hull.
/// [N. Amenta, S. Choi, R. Kolluri: The power crust, 2001]
struct Poles_2 {
  /// First the finite poles, by the samples on their circles; then those at infinity, by their samples. The disks'
  /// `samples` are the points of the Delaunay triangulation, and behind them two auxiliary points per pole at infinity.
  std::shared_ptr<const Balls_2> balls;
  std::vector<int> triangles;       ///< per finite pole a Delaunay triangle that its disk is circumscribed to
  std::vector<int> first;           ///< per point its first pole; -1 for points that are no site
  std::vector<int> second;          ///< per point its second pole; -1 for points without one
  std::vector<int> sample_offsets;  ///< size() + 1 offsets into `samples`
  std::vector<int> samples;         ///< per pole the points whose pole it is, ascending

  std::size_t size() const { return balls->size(); }
  std::size_t finite_count() const { return triangles.size(); }
  bool is_infinite(int pole) const { return pole >= static_cast<int>(triangles.size()); }
  std::span<const int> samples_of(int pole) const {
    return std::span(samples).subspan(sample_offsets[pole], sample_offsets[pole + 1] - sample_offsets[pole]);
  }
  /// The other pole of a sample that this is a pole of; -1 if it has none.
  int opposite(int pole, int sample) const { return first[sample] == pole ? second[sample] : first[sample]; }
};

/// By exact comparisons. None unless the dimension is 2. O(n log n).
Poles_2 find_poles(const Delaunay_2& triangulation, const Voronoi_2& voronoi, Progress& progress);

/// Poles with their sides of the shape.
struct Polar_balls_2 {
  std::shared_ptr<const Poles_2> poles;
  std::shared_ptr<const Regular_2> regular;  ///< of all disks of the poles
  std::vector<std::uint8_t> is_inner;        ///< per pole, those at infinity too; they are outer
  /// Per pole how sure its side is, in (0,1]; 0 for those that nothing reached: they count as outer, for want of
  /// better.
  std::vector<double> confidence;
  std::vector<int> contradictions;  ///< samples with both poles on one side, ascending
  std::size_t unlabelled_count = 0;

  /// Per Delaunay triangle whether it is that of an inner pole: the choice of `circumscribed_balls`.
  std::vector<std::uint8_t> inner_triangles(std::size_t triangle_count) const;
};

/// Labels poles, beginning with those at infinity, which are outer, and always going on with the surest. A labelled
/// pole tells the other poles of its samples that they are on the other side, the surer the nearer to opposite they lie
/// (by the cosine of the angle at the sample); and its neighbours in the regular triangulation that they are on the
/// same side, by the cosine of the angle at which the disks meet, if that is positive. Of equally sure ones the one
/// with the lesser index goes first; it is outer when there is as much for both sides. O(n log n). `regular`: the
/// regular triangulation of the poles' disks.
Polar_balls_2 label_poles(std::shared_ptr<const Poles_2> poles, std::shared_ptr<const Regular_2> regular,
                          Progress& progress);

/// The vertices of the power diagram of the poles. Circles through one sample meet there: triangles of the regular
/// triangulation whose disks all touch one sample share the vertex that is this sample.
///
/// Poles outside of nearly straight edges lie very far away. The vertices are those of the disks as they are, not as
/// their centers and radii are rounded, to 1e-9 of the diagonal of the samples.
struct Polar_diagram_2 {
  std::vector<Point_2> vertices;
  std::vector<int> vertex_of_triangle;  ///< per triangle of the regular triangulation
};
Polar_diagram_2 polar_power_diagram(const Polar_balls_2& polar, Progress& progress);

/// An edge of the regular triangulation, see Regular_2.
struct Regular_edge {
  int triangle = 0;
  int corner = 0;
};
/// The edges of the regular triangulation whose power edge has a length, each once: first those with a power vertex at
/// both ends, then those whose power edge is a ray.
std::vector<Regular_edge> power_edges(const Polar_balls_2& polar, const Polar_diagram_2& diagram);
/// Those of them between an inner and an outer pole: their power edges are the power crust. Closed polygons, and
/// possibly curves that end in rays.
std::vector<Regular_edge> power_crust(const Polar_balls_2& polar, const Polar_diagram_2& diagram);

/// The faces of the regular triangulation whose corners are all inner.
struct Power_shape_2 {
  std::vector<int> isolated;                  ///< poles without an edge in it
  std::vector<std::array<int, 2>> edges;      ///< pairs of poles
  std::vector<std::array<int, 3>> triangles;  ///< poles, counterclockwise
};
Power_shape_2 power_shape(const Polar_balls_2& polar);

/// A sample that lies on the circles of all these disks; -1 when there is none (known). `disks` must not be empty.
/// O(log n) per contact of the disk that has the fewest.
int shared_sample(const Balls_2& balls, std::span<const int> disks);

/// Cosine of the angle between two disks, rounded: 1 for equal ones, 0 where they meet at a right angle, -1 where they
/// touch from outside; beyond [-1,1] where they are apart or nested.
double intersection_cosine(const Balls_2& balls, int a, int b);

}  // namespace mesecina
