// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/samples_3/approximations_3.h"

#include <gtest/gtest.h>

#include "geometries/surface_error_3/surface_error_3.h"
#include "geometries/union_3/union_3.h"

namespace mesecina::test {

Ball_approximation_3 approximation_of(const Solid_3& solid, double distance, int threads) {
  Progress progress({}, {}, threads);
  return approximate_by_balls(solid, distance, 1e-4, progress);
}

double error_of(const Solid_3& solid, const Ball_approximation_3& approximation, double distance) {
  Progress progress({}, {}, 2);
  Box box;
  for (const Point_3& p : solid.surface.vertices) box.add(p);
  const double unit = distance / box.diagonal();
  const Surface_error_3 error =
      surface_error(solid, union_boundary(approximation.dual, progress), 0.04 * unit, progress);
  EXPECT_LE(error.resolution, 0.0401 * unit);
  return error.hausdorff() / unit;
}

Topology topology_of_axis(const Ball_approximation_3& approximation) {
  Progress progress({}, {}, 2);
  const Medial_complex_3 axis = union_medial_axis(union_vertices(approximation.dual, progress), progress);
  EXPECT_TRUE(has_topology_of_union(axis, *approximation.dual));
  Primitive_set set;
  set.dimension = 3;
  set.is_complex = true;
  set.vertices = axis.centers;
  for (std::size_t v = 0; v < set.vertices.size(); ++v) set.points.push_back(static_cast<int>(v));
  set.segments = axis.edges;
  set.polygon_offsets = axis.face_offsets;
  set.polygon_vertices = axis.face_vertices;
  return topology(set).value_or(Topology{});
}

}  // namespace mesecina::test
