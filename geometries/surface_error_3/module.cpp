// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_error_3/module.h"

#include "core/formats/number.h"
#include "core/graph.h"
#include "geometries/samples_3/module.h"
#include "geometries/union_3/module.h"

namespace mesecina {

namespace {

Surface_error_3 compute_error(Context& context) {
  if (!are_balls_of_mesh(context)) throw Unavailable("there is no mesh that the balls could be compared with");
  const auto solid = context.get(solid_3_key);
  const double delta = context.setting(delta_setting);
  constexpr double part_of_delta = 0.05;
  const Union_boundary_3 boundary = union_boundary(context.get(dual_3_key), context.progress());
  const Surface_error_3 error = surface_error(*solid, boundary, part_of_delta * delta, context.progress());
  context.measure("hausdorff", error.hausdorff());
  context.measure("hausdorff_to_input", error.to_input);
  context.measure("hausdorff_from_input", error.from_input);
  context.measure("resolution", error.resolution);
  if (error.hausdorff() > delta)
    context.warn("The union of balls and the surface differ by up to " + format_number(error.hausdorff()) +
                 " of the diagonal, more than delta (" + format_number(delta) +
                 "): parts of the solid are thinner than the samples can carry. Choose a smaller {delta}.");
  return error;
}

}  // namespace

void register_surface_error_3(Registry& registry) {
  registry.begin_module({"surface-error-3", "Error", "How far the union of balls is from the mesh it stands for."});
  registry.add_structure<Surface_error_3>(surface_error_3_key, compute_error);
}

}  // namespace mesecina
