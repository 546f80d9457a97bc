// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/primitives.h"
#include "layers/gl_geometry_2.h"

namespace mesecina {

/// Circular segments, between an arc and its chord, that need as many corners.
struct Segment_run {
  std::size_t first = 0;  ///< instance
  std::size_t count = 0;
  double bend = 0;  ///< largest radius times squared angle
};

/// The area bounded by arcs as shapes of which those inside are covered an odd number of times. Lengths in units of the
/// plane relative to the origin; ends of shapes that meet are the same floats.
struct Arc_fill {
  Point_2 origin;
  std::vector<float> triangles;           ///< x y x y x y
  std::vector<float> segments;            ///< start (x y), end (x y), centre (x y), radius, angle of the start, sweep
  std::vector<Segment_run> runs;          ///< of `segments`
  static constexpr int segment_size = 9;  ///< floats
};

/// The whole area bounded by the arcs that are drawn (per element; empty: all), by the even-odd rule. The triangles
/// overlap little, so that they cover no more than a small multiple of the area around the loops. O(n log n).
Arc_fill whole_arc_fill(const Primitive_set& set, const std::vector<bool>& drawn, const Point_2& origin);
/// What is in the window, relative to its middle, as triangles only, to a tenth of a pixel at the largest scale.
Arc_fill cut_out_arc_fill(const Primitive_set& set, const std::vector<bool>& drawn, const Window_2& window);

/// Corners, ends included, that a polyline needs to look like any arc of the run at `scale` pixels per unit; 2 where
/// the chords do.
int corners_of_segment(const Segment_run& run, double scale);

}  // namespace mesecina
