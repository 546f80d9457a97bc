// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_3/module.h"

#include <string>

#include "core/graph.h"
#include "geometries/samples_3/module.h"

namespace mesecina {

namespace {

Delaunay_3 compute_delaunay(Context& context) {
  const auto cloud = context.input(cloud_input);
  const bool is_cloud = !context.input(mesh_input) && cloud && !cloud->empty();
  Delaunay_3 triangulation =
      delaunay(is_cloud ? *cloud : context.get(surface_samples_3_key)->points, context.progress());
  if (const std::size_t duplicates = triangulation.points.size() - triangulation.site_count; duplicates > 0)
    context.warn(std::to_string(duplicates) + " of " + std::to_string(triangulation.points.size()) +
                 " samples equal another one and are merged with it");
  return triangulation;
}

}  // namespace

void register_delaunay_3(Registry& registry) {
  registry.begin_module({"delaunay-3", "Delaunay and Voronoi", "The diagrams that everything else is read from."});
  registry.add_structure<Delaunay_3>(delaunay_3_key, compute_delaunay);
}

}  // namespace mesecina
