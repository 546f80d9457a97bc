// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/skin_surface_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/make_skin_surface_mesh_3.h>

#include <string>

#include "core/outcome.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;

}  // namespace

Triangle_mesh_3 skin_surface(const std::vector<Ball_3>& balls, double shrink_factor, Progress& progress) {
  progress.begin_stage("skin surface");
  std::vector<Kernel::Weighted_point_3> points;
  for (const auto& [center, radius] : balls)
    if (radius > 0) points.emplace_back(Kernel::Point_3(center.x, center.y, center.z), radius * radius);
  if (points.empty()) throw Unavailable("there are no balls with a radius");
  if (points.size() > most_skin_balls)
    throw Unavailable("there are " + std::to_string(points.size()) + " balls; skin surfaces are made of at most " +
                      std::to_string(most_skin_balls) +
                      ", as they take long; those of a mesh are fewer with a larger {delta}");
  Polyhedron polyhedron;
  CGAL::make_skin_surface_mesh_3(polyhedron, points.begin(), points.end(), shrink_factor);
  progress.check();
  Triangle_mesh_3 mesh;
  mesh.vertices.reserve(polyhedron.size_of_vertices());
  for (auto vertex = polyhedron.vertices_begin(); vertex != polyhedron.vertices_end(); ++vertex) {
    vertex->id() = mesh.vertices.size();
    mesh.vertices.push_back({vertex->point().x(), vertex->point().y(), vertex->point().z()});
  }
  mesh.triangles.reserve(polyhedron.size_of_facets());
  for (auto facet = polyhedron.facets_begin(); facet != polyhedron.facets_end(); ++facet) {
    const auto corner = facet->halfedge();
    mesh.triangles.push_back({static_cast<int>(corner->vertex()->id()),
                              static_cast<int>(corner->next()->vertex()->id()),
                              static_cast<int>(corner->next()->next()->vertex()->id())});
  }
  return mesh;
}

}  // namespace mesecina
