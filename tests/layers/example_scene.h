// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/style.h"

namespace mesecina::test {

/// A visible layer that takes over the set.
inline Scene_layer layer_of(Primitive_set set, std::string id = "layer") {
  Scene_layer layer;
  layer.id = id;
  layer.label = std::move(id);
  layer.primitives = std::make_shared<const Primitive_set>(std::move(set));
  layer.style.visible = true;
  return layer;
}

inline Scene scene_of(Scene_layer layer) {
  Scene scene;
  scene.layers.push_back(std::move(layer));
  return scene;
}

/// The view in which plane coordinates are pixels of a page, from its lower left corner.
inline View_2 pixel_view(double width, double height) { return {{width / 2, height / 2}, 1}; }

}  // namespace mesecina::test
