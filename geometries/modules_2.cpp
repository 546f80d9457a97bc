// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/modules_2.h"

#include "geometries/balls_2/module.h"
#include "geometries/crust_2/module.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/dual_2/module.h"
#include "geometries/evolutions_2/module.h"
#include "geometries/inputs_2/module.h"
#include "geometries/labels_2/module.h"
#include "geometries/landmark_disks_2/module.h"
#include "geometries/medial_axis_2/module.h"
#include "geometries/medial_filtrations_2/module.h"
#include "geometries/power_crust_2/module.h"
#include "geometries/regular_2/module.h"
#include "geometries/samples_2/module.h"
#include "geometries/scale_axis_2/module.h"
#include "geometries/union_2/module.h"
#include "geometries/witness_2/module.h"

namespace mesecina {

std::shared_ptr<const Registry> make_registry_2() {
  auto registry = std::make_shared<Registry>();
  register_inputs_2(*registry);
  register_samples_2(*registry);
  register_delaunay_2(*registry);
  register_crust_2(*registry);
  register_labels_2(*registry);
  register_medial_axis_2(*registry);
  register_medial_filtrations_2(*registry);
  register_power_crust_2(*registry);
  register_balls_2(*registry);
  register_regular_2(*registry);
  register_dual_2(*registry);
  register_union_2(*registry);
  register_scale_axis_2(*registry);
  register_evolutions_2(*registry);
  register_witness_2(*registry);
  register_landmark_disks_2(*registry);
  return registry;
}

}  // namespace mesecina
