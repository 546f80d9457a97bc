// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/film_ranges.h"

#include <algorithm>
#include <cmath>

namespace mesecina {

bool Film_ranges::are_wanted_by(const Scene& scene) {
  return std::ranges::any_of(scene.layers, [](const Scene_layer& layer) {
    const Style& style = layer.style;
    return style.visible && !style.value.empty() && !(style.range_minimum && style.range_maximum);
  });
}

void Film_ranges::widen(const Scene& scene) {
  for (const Scene_layer& layer : scene.layers) {
    const Values* values =
        layer.style.visible && layer.primitives ? layer.primitives->find_values(layer.style.value) : nullptr;
    if (!values) continue;
    const std::vector<bool> drawn = drawn_elements(layer);
    for (std::size_t i = 0; i < values->data.size(); ++i) {
      const double value = values->data[i];
      if (!std::isfinite(value) || (i < drawn.size() && !drawn[i])) continue;
      const auto [range, is_first] = ranges_.try_emplace(layer.id, Range{value, value});
      range->second.minimum = std::min(range->second.minimum, value);
      range->second.maximum = std::max(range->second.maximum, value);
    }
  }
}

void Film_ranges::apply_to(Scene& scene) const {
  for (Scene_layer& layer : scene.layers) {
    const auto range = ranges_.find(layer.id);
    if (range == ranges_.end() || layer.style.value.empty()) continue;
    if (!layer.style.range_minimum) layer.style.range_minimum = range->second.minimum;
    if (!layer.style.range_maximum) layer.style.range_maximum = range->second.maximum;
  }
}

}  // namespace mesecina
