// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/scene.h"

#include <algorithm>

namespace mesecina {

std::vector<std::string> shown_layers(const Registry& registry, const Command_line& command_line) {
  if (!command_line.layers.empty() || command_line.session) return command_line.layers;
  std::vector<std::string> ids;
  for (const Layer_spec& layer : registry.layers())
    if (layer.style.visible) ids.push_back(layer.id);
  return ids;
}

Scene make_scene(const Registry& registry, const Command_line& command_line, const Settings& settings,
                 const std::function<std::shared_ptr<const Primitive_set>(const std::string&)>& primitives) {
  const std::vector<std::string> ids = shown_layers(registry, command_line);
  std::vector<const Layer_spec*> layers;
  const auto add = [&](const Layer_spec& layer) {
    if (std::ranges::find(layers, &layer) == layers.end()) layers.push_back(&layer);
  };
  if (command_line.as_listed) {
    for (const std::string& id : ids) add(*registry.find_layer(id));
  } else {
    for (const Layer_spec& layer : registry.layers())
      if (std::ranges::find(ids, layer.id) != ids.end()) add(layer);
  }
  Scene scene;
  scene.transparent_background = command_line.transparent_background;
  scene.background = canvas_color(command_line.background.value_or(Canvas_background::paper), light_window_color);
  for (const Layer_spec* layer : layers) {
    const auto changed = command_line.styles.find(layer->id);
    Scene_layer entry{layer->id, layer->label, primitives(layer->id), registry.cut(*layer, settings),
                      changed == command_line.styles.end() ? layer->style : changed->second};
    entry.style.visible = true;
    scene.layers.push_back(std::move(entry));
  }
  make_visible_on_background(scene);
  return scene;
}

}  // namespace mesecina
