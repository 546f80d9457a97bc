// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/first_look.h"

#include <string_view>

#include "geometries/landmark_disks_2/module.h"
#include "geometries/witness_2/module.h"

namespace mesecina {

namespace {

void show(Layer_list& layers, std::string_view id) {
  if (Layer_entry* entry = find_entry(layers, id)) entry->style.visible = true;
}

void show_axis(Layer_list& layers, std::string_view id) {
  constexpr double width = 2.5;
  show(layers, id);
  if (Layer_entry* entry = find_entry(layers, id)) entry->style.line_width = width;
}

Layer_list look_of_disks(const Registry& registry) {
  Layer_list layers = default_layers(registry);
  show(layers, "union-boundary");
  show_axis(layers, "union-medial-axis");
  return layers;
}

Layer_list look_of_samples(const Registry& registry) {
  Layer_list layers = default_layers(registry);
  show(layers, "voronoi");
  if (Layer_entry* entry = find_entry(layers, "voronoi")) {
    constexpr double faint = 0.35;
    entry->style.opacity = faint;
  }
  show(layers, "one-step-crust");
  show_axis(layers, "medial-axis");
  if (Layer_entry* entry = find_entry(layers, "medial-axis")) entry->style.value = "lambda";
  return layers;
}

Layer_list look_of_landmarks(const Registry& registry) {
  Layer_list layers = default_layers(registry);
  for (const char* id : {"landmark-delaunay", "witness-complex", "landmarks"}) show(layers, id);
  return layers;
}

Layer_list look_of_landmark_disks(const Registry& registry) {
  Layer_list layers = default_layers(registry);
  for (const char* id : {"landmark-disks-grown", "landmark-disks", "landmark-disks-dual"}) show(layers, id);
  return layers;
}

}  // namespace

Layer_list first_look(const Registry& registry, const Inputs& inputs) {
  if (inputs.get(landmarks_input)) return look_of_landmarks(registry);
  if (inputs.get(landmark_disks_input)) return look_of_landmark_disks(registry);
  const bool has_only_disks = inputs.get(disks_input) && !inputs.get(points_input) && !inputs.get(outline_input);
  return has_only_disks ? look_of_disks(registry) : look_of_samples(registry);
}

Layer_list look_at(const Registry& registry, const Inputs& inputs, const Layer_list& layers) {
  const bool is_first_look = layers == look_of_samples(registry) || layers == look_of_disks(registry) ||
                             layers == look_of_landmarks(registry) || layers == look_of_landmark_disks(registry);
  return is_first_look ? first_look(registry, inputs) : layers;
}

}  // namespace mesecina
