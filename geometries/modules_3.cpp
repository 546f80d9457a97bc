// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/modules_3.h"

#include "geometries/delaunay_3/module.h"
#include "geometries/delaunay_parts_3/module.h"
#include "geometries/evolutions_3/module.h"
#include "geometries/inputs_3/module.h"
#include "geometries/internals_3/module.h"
#include "geometries/medial_features_3/module.h"
#include "geometries/medial_filtrations_3/module.h"
#include "geometries/power_crust_3/module.h"
#include "geometries/samples_3/module.h"
#include "geometries/scale_axis_3/module.h"
#include "geometries/sides_3/module.h"
#include "geometries/surface_3/module.h"
#include "geometries/surface_error_3/module.h"
#include "geometries/union_3/module.h"

namespace mesecina {

std::shared_ptr<const Registry> make_registry_3() {
  constexpr int dimension = 3;
  auto registry = std::make_shared<Registry>(dimension);
  register_inputs_3(*registry);
  register_samples_3(*registry);
  register_delaunay_3(*registry);
  register_delaunay_parts_3(*registry);
  register_power_crust_3(*registry);
  register_sides_3(*registry);
  register_union_3(*registry);
  register_medial_filtrations_3(*registry);
  register_medial_features_3(*registry);
  register_scale_axis_3(*registry);
  register_scale_axis_features_3(*registry);
  register_surface_3(*registry);
  register_surface_error_3(*registry);
  register_internals_3(*registry);
  register_evolutions_3(*registry);
  return registry;
}

}  // namespace mesecina
