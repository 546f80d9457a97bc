// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/evolutions_2/module.h"

#include "geometries/evolution_settings.h"
#include "geometries/evolutions_2/evolutions.h"

namespace mesecina {

void register_evolutions_2(Registry& registry) {
  registry.begin_module(
      {"evolutions-2", "Evolutions", "Steps that change points, outlines and disks again and again."});
  add_smoothing_settings(registry);
  add_noise_settings(registry);
  add_growing_settings(registry);
  registry.add_evolution(smoothing_2());
  registry.add_evolution(subdivision_2());
  registry.add_evolution(noise_2());
  registry.add_evolution(lloyd_2());
  registry.add_evolution(growing_2());
  registry.add_evolution(shrinking_2());
  registry.add_evolution(stepped_growing_2());
}

}  // namespace mesecina
