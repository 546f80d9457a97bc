// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/primitives.h"

namespace mesecina {

struct Color {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Color&) const = default;
};

/// How a layer looks; a plain value that outlives every recomputation. Sizes are in logical pixels.
struct Style {
  bool visible = false;
  Color color{40, 40, 40};
  double opacity = 1;     ///< 0 transparent ... 1; of filled disks of one colour together, else of each element
  double point_size = 6;  ///< diameter
  double line_width = 1.5;
  /// Disks, triangles and polygons: inside painted; else their outline only. Closed curves of arcs: inside painted in
  /// `color` by the even-odd rule, all of them together, below their outlines.
  bool filled = false;
  bool edges = false;     ///< in space: filled triangles and polygons with their edges
  bool vertices = false;  ///< in space: also points that are ends or corners of other primitives of the layer
  bool smooth = false;    ///< in space: triangles and polygons shaded by normals of their vertices, not of their own
  bool sliced = true;     ///< in space: only what the cutting plane leaves is drawn
  std::string value;      ///< the values that choose the colour; empty: `color` for all
  std::string color_map = "viridis";
  bool color_map_reversed = false;
  std::optional<double> range_minimum;  ///< of the colour map; absent: smallest finite value
  std::optional<double> range_maximum;
  std::optional<double> threshold_minimum;  ///< elements whose `value` is less are not drawn
  std::optional<double> threshold_maximum;
  bool operator==(const Style&) const = default;
};

/// A layer ready to be drawn.
struct Scene_layer {
  std::string id;
  std::string label;
  std::shared_ptr<const Primitive_set> primitives;  ///< null when there is nothing to draw (yet)
  std::optional<Cut> cut;
  Style style;
};

/// Layers from bottom to top.
struct Scene {
  std::vector<Scene_layer> layers;
  Color background{255, 255, 255};
  bool transparent_background = false;
};

/// A planar view: the point in the middle of the picture and logical pixels per unit; y points up.
struct View_2 {
  Point_2 center;
  double scale = 1;
  bool operator==(const View_2&) const = default;

  Point_2 to_pixel(const Point_2& p, double width, double height) const {
    return {(p.x - center.x) * scale + width / 2, height / 2 - (p.y - center.y) * scale};
  }
  Point_2 to_plane(const Point_2& pixel, double width, double height) const {
    return {(pixel.x - width / 2) / scale + center.x, (height / 2 - pixel.y) / scale + center.y};
  }
};

/// The view that shows the whole box with a margin of 5 %; a sensible one for an empty box or a single point.
View_2 fit_view(const Box& box, double width, double height);

/// Which elements of the layer are drawn under its cut and its style's thresholds; empty means all of them.
std::vector<bool> drawn_elements(const Scene_layer& layer);

}  // namespace mesecina
