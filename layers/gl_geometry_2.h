// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/primitives.h"

namespace mesecina {

/// What of a Primitive_set is drawn in one way from one buffer.
enum class Part {
  points,          ///< x y
  segments,        ///< x y x y
  rays,            ///< x y and the unit direction
  arcs,            ///< a circle: centre, radius, angle of the start, angle covered counterclockwise (2 pi: all of it)
  triangles,       ///< x y x y x y
  triangle_edges,  ///< as segments
  polygons,        ///< as triangles: a fan per polygon; the points covered an odd number of times are inside
  polygon_edges,   ///< as segments
  balls            ///< a circle, as arcs
};

inline constexpr int floats_of_far_circle = 13;
int floats_per_instance(Part part);

/// What is uploaded for one part: equally long runs of floats, lengths in units of the plane relative to the origin.
struct Instances {
  Point_2 origin;
  std::vector<float> data;
  std::vector<std::uint32_t> elements;  ///< per instance, the element number in its Primitive_set
};

/// A square of the plane, and the largest scale (pixels per unit) at which what is cut out for it is drawn.
struct Window_2 {
  Point_2 center;
  double half_side = 0;
  double largest_scale = 1;
};

/// Circles with a larger radius in pixels are drawn from their distance and direction to the middle of the window,
/// which stays exact for any radius, instead of from their centre.
inline constexpr double largest_near_radius = 65536;

/// The farthest from `origin` that the part reaches in x or y (rays: that they start), radii included; 0 when empty.
/// +infinity if a coordinate is not finite. O(size).
double farthest_reach(const Primitive_set& set, Part part, const Point_2& origin);
/// Number of instances in the whole part, before any is cut out. O(1) but for polygons: O(#polygons).
bool has_part(const Primitive_set& set, Part part);
/// The whole part relative to `origin`. O(size).
Instances whole_part(const Primitive_set& set, Part part, const Point_2& origin);

/// What of a part meets a window, relative to the middle of the window, cut in double precision at its border so that
/// float coordinates are exact enough whatever the coordinates of the whole.
struct Cut_out {
  Instances near;  ///< laid out as the part; rays have become segments
  Instances far;   ///< circles too large for it: middle of window to centre / radius (x y), distance to the circle
                   ///< (negative inside), 1 / radius, start (x y), end (x y), travel direction at start (x y) and at
                   ///< end (x y), 1 for a whole circle else 0
};
/// O(size).
Cut_out cut_out_part(const Primitive_set& set, Part part, const Window_2& window);

}  // namespace mesecina
