// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layer_list.h"

#include <algorithm>

namespace mesecina {

Layer_list default_layers(const Registry& registry) {
  Layer_list layers;
  layers.reserve(registry.layers().size());
  for (const Layer_spec& spec : registry.layers()) layers.push_back({spec.id, spec.style});
  return layers;
}

Layer_list with_missing_layers(Layer_list listed, const Registry& registry) {
  auto place = listed.begin();
  for (const Layer_spec& spec : registry.layers()) {
    auto found = std::ranges::find(listed, spec.id, &Layer_entry::id);
    if (found == listed.end()) {
      found = listed.insert(place, {spec.id, spec.style});
      found->style.visible = false;
    }
    place = found + 1;
  }
  return listed;
}

const Layer_entry* find_entry(const Layer_list& layers, std::string_view id) {
  const auto it = std::find_if(layers.begin(), layers.end(), [&](const Layer_entry& entry) { return entry.id == id; });
  return it == layers.end() ? nullptr : &*it;
}

Layer_entry* find_entry(Layer_list& layers, std::string_view id) {
  const auto it = std::find_if(layers.begin(), layers.end(), [&](const Layer_entry& entry) { return entry.id == id; });
  return it == layers.end() ? nullptr : &*it;
}

}  // namespace mesecina
