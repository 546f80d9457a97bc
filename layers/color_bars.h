// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/style.h"
#include "layers/clip_2.h"

namespace mesecina {

/// The legend of one layer coloured by value: what it shows and where it stands on the page.
struct Color_bar {
  /// Ascending from 0 (left end) to 1; two at one position make a hard edge.
  struct Stop {
    double position = 0;
    Color color;
  };
  struct Tick {
    double position = 0;  ///< 0 left end ... 1 right end
    std::string text;
  };
  std::string title;  ///< "Medial axis: lambda (units of the input)", UTF-8
  std::vector<Stop> stops;
  std::vector<Tick> ticks;
  Pixel_box plate;       ///< ground of the whole legend
  Pixel_box strip;       ///< the colours
  Point_2 title_anchor;  ///< left end of the title's base line
  double tick_base = 0;  ///< base line of the tick texts
};

/// Looks shared by all pictures.
struct Color_bar_look {
  static constexpr double text_size = 11;  ///< pixels
  static constexpr double tick_length = 4;
  static constexpr double plate_opacity = 0.85;
  static constexpr const char* font = "DejaVu Sans";
};

/// One bar for each visible layer coloured by value, all of one width, stacked upwards from the lower right corner in
/// layer order; those that do not fit the page are left out. None for layers with a solid or random map. O(elements).
std::vector<Color_bar> color_bars(const Scene& scene, double width, double height);

/// Black or white, whichever reads well on `ground`.
Color ink_on(Color ground);

/// Up to six round numbers within [low, high], at least three where the range has any width; ascending.
std::vector<double> round_ticks(double low, double high);

}  // namespace mesecina
