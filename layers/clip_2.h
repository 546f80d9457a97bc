// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/point.h"

namespace mesecina {

/// Geometry on a page, in pixels with y pointing down. Everything is computed in double, so that shapes of 1e12 pixels
/// are right where they cross the page.

struct Pixel_box {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  Pixel_box grown(double margin) const { return {left - margin, top - margin, right + margin, bottom + margin}; }
  bool contains(const Point_2& p) const { return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom; }
  bool contains(const Pixel_box& box) const {
    return box.left >= left && box.right <= right && box.top >= top && box.bottom <= bottom;
  }
  bool meets(const Pixel_box& box) const {
    return box.left <= right && box.right >= left && box.top <= bottom && box.bottom >= top;
  }
};

/// Smallest box of the points; do not call with none. It meets nothing when a coordinate is not finite.
Pixel_box box_of(std::span<const Point_2> points);

/// Part of a circle. Angles in radians from the x axis towards the (downward) y axis; a negative sweep goes
/// counterclockwise as seen.
struct Pixel_arc {
  Point_2 center;
  double radius = 0;
  double start = 0;
  double sweep = 0;  ///< within [-2π, 2π]
  Point_2 from;      ///< the end points; equal to at(start) and at(start + sweep) up to rounding
  Point_2 to;

  Point_2 at(double angle) const { return {center.x + radius * std::cos(angle), center.y + radius * std::sin(angle)}; }
  bool is_whole_circle() const;
};

Pixel_arc whole_circle(const Point_2& center, double radius);
/// The arc between two points of a circle, in the direction seen on the page.
Pixel_arc arc_between(const Point_2& center, double radius, const Point_2& from, const Point_2& to,
                      bool counterclockwise);

/// Any number of closed polygons in one array.
struct Pixel_rings {
  std::vector<Point_2> points;
  std::vector<std::size_t> ends;  ///< one past the last point of each ring

  bool is_empty() const { return ends.empty(); }
  std::size_t size() const { return ends.size(); }
  std::span<const Point_2> ring(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(points).subspan(begin, ends[i] - begin);
  }
  void add(std::span<const Point_2> ring);
  void clear() {
    points.clear();
    ends.clear();
  }
};

/// An area bounded by polygons and by closed walks along arcs.
struct Pixel_region {
  Pixel_rings rings;
  std::vector<Pixel_arc> arcs;         ///< each starts where the one before it in its loop ends
  std::vector<std::size_t> loop_ends;  ///< one past the last arc of each loop

  bool is_empty() const { return rings.is_empty() && loop_ends.empty(); }
  std::size_t loop_count() const { return loop_ends.size(); }
  std::span<const Pixel_arc> loop(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : loop_ends[i - 1];
    return std::span(arcs).subspan(begin, loop_ends[i] - begin);
  }
  void end_loop() { loop_ends.push_back(arcs.size()); }
};

/// Nullopt when nothing of it lies in the box.
std::optional<std::array<Point_2, 2>> clip_segment(const Point_2& from, const Point_2& to, const Pixel_box& box);
/// `direction` of any positive length.
std::optional<std::array<Point_2, 2>> clip_ray(const Point_2& from, const Point_2& direction, const Pixel_box& box);
/// A ring that has the same inside within the box and stays in it; fewer than 3 points when nothing is left.
std::vector<Point_2> clip_ring(std::span<const Point_2> ring, const Pixel_box& box);
/// The parts of the arc in the box, in its direction.
std::vector<Pixel_arc> clip_arc(const Pixel_arc& arc, const Pixel_box& box);
/// Appends the points after arc.from of a polyline along the arc. The area between the two is less than `tolerance`
/// wide or does not meet the box. O(points), of which there are few outside the box however large the arc is.
void append_polyline(const Pixel_arc& arc, const Pixel_box& box, double tolerance, std::vector<Point_2>& points);
/// The disk's part in the box as a convex polygon within 0.01 pixels; empty when there is none.
std::vector<Point_2> clip_disk(const Point_2& center, double radius, const Pixel_box& box);

/// A cubic Bézier curve after its first point.
struct Bezier {
  Point_2 control_1;
  Point_2 control_2;
  Point_2 to;
};
/// The arc within 0.005 pixels.
std::vector<Bezier> to_beziers(const Pixel_arc& arc);

}  // namespace mesecina
