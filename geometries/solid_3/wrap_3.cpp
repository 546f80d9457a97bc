// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/wrap_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

namespace mesecina {

namespace {

class Cancelling_visitor : public CGAL::Alpha_wraps_3::internal::Wrapping_default_visitor {
 public:
  explicit Cancelling_visitor(const Progress& progress) : progress_(&progress) {}

  template <class Wrapper, class Gate>
  void before_facet_treatment(const Wrapper& wrapper, const Gate& gate) {
    (void)wrapper;
    (void)gate;
    progress_->check();
  }

 private:
  const Progress* progress_;
};

}  // namespace

Triangle_mesh_3 wrap(const Triangle_mesh_3& mesh, double alpha, double offset, Progress& progress) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  std::vector<Kernel::Point_3> points;
  points.reserve(mesh.vertices.size());
  for (const Point_3& p : mesh.vertices) points.emplace_back(p.x, p.y, p.z);
  Surface surface;
  progress.check();
  Cancelling_visitor visitor(progress);
  CGAL::alpha_wrap_3(points, mesh.triangles, alpha, offset, surface, CGAL::parameters::default_values(),
                     CGAL::parameters::visitor(visitor));
  progress.check();
  Triangle_mesh_3 result;
  result.vertices.reserve(surface.number_of_vertices());
  for (const auto v : surface.vertices())
    result.vertices.push_back({surface.point(v).x(), surface.point(v).y(), surface.point(v).z()});
  for (const auto f : surface.faces()) {
    const auto h = surface.halfedge(f);
    const auto next = surface.next(h);
    result.triangles.push_back({static_cast<int>(surface.source(h)), static_cast<int>(surface.target(h)),
                                static_cast<int>(surface.target(next))});
  }
  return result;
}

}  // namespace mesecina
