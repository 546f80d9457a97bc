// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

/// What is painted of one element, or of a part of it, on a page in pixels with y down.
struct Space_shape {
  enum class Kind { area, line, dot, ball };
  Kind kind = Kind::area;
  std::size_t layer = 0;        ///< of the scene
  std::vector<Point_2> points;  ///< corners; both ends; the center
  double radius = 0;            ///< of balls
  double line_width = 0;        ///< of lines, and of balls that are not filled (0: filled)
  Color color;                  ///< with light; of balls without
};

/// Of elements, or of shapes that they make.
inline constexpr std::size_t most_space_shapes = 20'000;

/// A scene in space as flat shapes, from the farthest to the nearest: faces, segments and rays, points and balls of
/// what the renderer shows. Faces that cross are split, so that each is painted before what hides it; for each ball its
/// center decides, as circles cannot cross like spheres. A cutting plane cuts faces and lines, and takes away balls and
/// points by their centers; it fills nothing. O(n^2) at worst, for thousands of faces a few seconds.
/// Throws std::invalid_argument where there are more than most_space_shapes elements; its text names the number.
std::vector<Space_shape> space_shapes(const Scene& scene, const View_3& view, int width, int height);

/// The colour of a surface with this normal in eye coordinates, seen from +z, as the renderer lights it.
Color lit_color(const Color& color, const Point_3& normal, const Point_3& to_viewer);

}  // namespace mesecina
