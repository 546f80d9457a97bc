// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/first_look_3.h"

#include <string_view>

namespace mesecina {

namespace {

Style* shown(Layer_list& layers, std::string_view id) {
  Layer_entry* entry = find_entry(layers, id);
  if (!entry) return nullptr;
  entry->style.visible = true;
  return &entry->style;
}

Layer_list nothing(const Registry& registry) {
  Layer_list layers = default_layers(registry);
  for (Layer_entry& entry : layers) entry.style.visible = false;
  return layers;
}

Layer_list look_of_mesh(const Registry& registry) {
  Layer_list layers = nothing(registry);
  if (Style* mesh = shown(layers, "mesh")) {
    constexpr double faint = 0.3;
    mesh->opacity = faint;
    mesh->smooth = true;
  }
  if (Style* axis = shown(layers, "scale-axis")) axis->value = "angle";
  return layers;
}

Layer_list look_of_balls(const Registry& registry) {
  Layer_list layers = nothing(registry);
  if (Style* balls = shown(layers, "given-balls")) balls->value = "radius";
  return layers;
}

Layer_list look_of_points(const Registry& registry) {
  Layer_list layers = nothing(registry);
  if (Style* points = shown(layers, "points")) {
    constexpr double small = 3;
    points->point_size = small;
  }
  shown(layers, "power-crust");
  return layers;
}

/// Of these kinds of data, all of which are shown; the first of mesh, balls and points has its whole look.
Layer_list look_of(const Registry& registry, bool has_mesh, bool has_balls, bool has_points) {
  Layer_list layers = has_mesh     ? look_of_mesh(registry)
                      : has_balls  ? look_of_balls(registry)
                      : has_points ? look_of_points(registry)
                                   : look_of_mesh(registry);
  if (has_balls) shown(layers, "given-balls");
  if (has_points) shown(layers, "points");
  return layers;
}

}  // namespace

Layer_list first_look_3(const Registry& registry, const Inputs& inputs) {
  return look_of(registry, inputs.get(mesh_input) != nullptr, inputs.get(balls_input) != nullptr,
                 inputs.get(cloud_input) != nullptr);
}

Layer_list look_at_3(const Registry& registry, const Inputs& inputs, const Layer_list& layers) {
  bool is_first_look = false;
  for (const bool has_mesh : {false, true})
    for (const bool has_balls : {false, true})
      for (const bool has_points : {false, true})
        is_first_look = is_first_look || layers == look_of(registry, has_mesh, has_balls, has_points);
  return is_first_look ? first_look_3(registry, inputs) : layers;
}

}  // namespace mesecina
