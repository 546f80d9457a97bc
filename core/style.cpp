// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/style.h"

#include <algorithm>

namespace mesecina {

View_2 fit_view(const Box& box, double width, double height) {
  View_2 view;
  if (box.is_empty()) {
    view.scale = std::min(width, height) / 2;
    return view;
  }
  view.center = {(box.lower.x + box.upper.x) / 2, (box.lower.y + box.upper.y) / 2};
  const double box_width = box.upper.x - box.lower.x;
  const double box_height = box.upper.y - box.lower.y;
  constexpr double filled_part = 0.9;
  double scale = std::numeric_limits<double>::infinity();
  if (box_width > 0) scale = std::min(scale, width * filled_part / box_width);
  if (box_height > 0) scale = std::min(scale, height * filled_part / box_height);
  const double size_of_a_point = std::max({1.0, std::abs(view.center.x), std::abs(view.center.y)});
  view.scale = std::isfinite(scale) && scale > 0 ? scale : std::min(width, height) / (2 * size_of_a_point);
  return view;
}

std::vector<bool> drawn_elements(const Scene_layer& layer) {
  if (!layer.primitives) return {};
  const Primitive_set& set = *layer.primitives;
  const Values* cut_values = layer.cut ? set.find_values(layer.cut->value) : nullptr;
  const bool has_threshold = layer.style.threshold_minimum || layer.style.threshold_maximum;
  const Values* values = has_threshold ? set.find_values(layer.style.value) : nullptr;
  if (!cut_values && !values) return {};
  std::vector<bool> drawn(set.element_count(), true);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (cut_values && !(cut_values->data[i] >= layer.cut->minimum)) drawn[i] = false;
    if (values && layer.style.threshold_minimum && !(values->data[i] >= *layer.style.threshold_minimum))
      drawn[i] = false;
    if (values && layer.style.threshold_maximum && !(values->data[i] <= *layer.style.threshold_maximum))
      drawn[i] = false;
  }
  return drawn;
}

}  // namespace mesecina
