// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/style.h"
#include "layers/clip_2.h"
#include "layers/color_map.h"

namespace mesecina {

/// Receives what a scene looks like on a page, in pixels with y down, from the bottom to the top: what the painter and
/// the file writers have in common, so that they cannot disagree.
class Shape_sink {
 public:
  virtual ~Shape_sink() = default;
  virtual void begin_layer(const Scene_layer& layer, const Layer_colors& colors) = 0;
  virtual void end_layer() = 0;
  /// The whole image fills `place`, which may reach far beyond the page.
  virtual void image(const Image& image, const Pixel_box& place) = 0;
  /// Filled; `odd_even` or else by the winding number. All elements of one colour that touch come in one call.
  virtual void area(const Pixel_rings& rings, bool odd_even, Color color) = 0;
  /// Filled in one even tone, whatever its parts cover twice; `odd_even` or else by the winding number.
  virtual void region(const Pixel_region& region, bool odd_even, Color color) = 0;
  virtual void disk(const Point_2& center, double radius, Color color) = 0;
  virtual void circle(const Point_2& center, double radius, Color color) = 0;
  virtual void outline(std::span<const Point_2> ring, Color color) = 0;
  virtual void arc(const Pixel_arc& arc, Color color) = 0;
  virtual void segment(const Point_2& from, const Point_2& to, Color color) = 0;
  /// Of the layer's point size.
  virtual void dot(const Point_2& center, Color color) = 0;
};

/// A page of `width` x `height` pixels.
struct Page {
  View_2 view;
  double width = 0;
  double height = 0;
  /// Shapes that leave the page by more than this are cut off there; true circles and arcs of a greater radius too.
  double reach = 2000;
};

/// True when something of the layer is on the picture.
bool is_shown(const Scene_layer& layer);

/// Sends the visible layers, bottom to top. Within a layer areas come first, then curves, then points. Elements off the
/// page and such with coordinates that are not finite are left out.
void send_scene(const Scene& scene, const Page& page, Shape_sink& sink);

}  // namespace mesecina
