// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/style.h"

namespace mesecina {

/// Finds what is drawn under a pixel, from the same Scene that the canvases draw.
class Picker_2 {
 public:
  Picker_2();
  ~Picker_2();

  struct Hit {
    std::size_t layer = 0;    ///< index in Scene::layers
    std::size_t element = 0;  ///< element number in its Primitive_set
    double distance = 0;      ///< pixels from the drawn element; 0 inside a filled one
  };

  /// The best visible element within `tolerance` logical pixels: points before curves before areas, then the nearer
  /// one, then the layer drawn later. Only elements drawn under cut and thresholds. An arc is where its line is, also
  /// if the area that arcs bound is filled: that belongs to no element. Index of a Primitive_set is built once (weakly
  /// kept), O(log n) afterwards.
  std::optional<Hit> pick(const Scene& scene, const View_2& view, double width, double height, const Point_2& pixel,
                          double tolerance);

 private:
  struct Index;
  std::map<const Primitive_set*, std::shared_ptr<Index>> indices_;
};

}  // namespace mesecina
