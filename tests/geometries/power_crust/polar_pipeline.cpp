// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/power_crust/polar_pipeline.h"

#include "core/primitives.h"
#include "geometries/primitives_2.h"

namespace mesecina::test {

Polar_pipeline power_crust_of(std::span<const Point_2> samples) {
  Progress progress;
  Polar_pipeline result;
  result.delaunay = std::make_shared<const Delaunay_2>(delaunay(samples, progress));
  const Voronoi_2 vertices = voronoi(*result.delaunay, progress);
  result.poles = std::make_shared<const Poles_2>(find_poles(*result.delaunay, vertices, progress));
  const auto regular = std::make_shared<const Regular_2>(regular_triangulation(result.poles->balls, progress));
  result.polar = label_poles(result.poles, regular, progress);
  result.diagram = polar_power_diagram(result.polar, progress);
  return result;
}

bool Polar_pipeline::is_in_inner_cell(const Point_2& point) const {
  int best = -1;
  double least = 0;
  for (int disk = 0; disk < static_cast<int>(balls().size()); ++disk) {
    const double d = distance(point, balls().centers[disk]);
    const double power = (d - balls().radii[disk]) * (d + balls().radii[disk]);
    if (best >= 0 && power >= least) continue;
    best = disk;
    least = power;
  }
  return polar.is_inner[best] != 0;
}

std::vector<std::array<int, 2>> crust_segments(const Polar_pipeline& pipeline) {
  std::vector<std::array<int, 2>> segments;
  for (const auto& [t, i] : power_crust(pipeline.polar, pipeline.diagram)) {
    const int u = pipeline.polar.regular->neighbors[t][i];
    segments.push_back({pipeline.diagram.vertex_of_triangle[t], u < 0 ? -1 : pipeline.diagram.vertex_of_triangle[u]});
  }
  return segments;
}

namespace {

std::array<int, 2> betti(const Primitive_set& set) {
  const auto numbers = topology(set);
  return {static_cast<int>(numbers->betti[0]), static_cast<int>(numbers->betti[1])};
}

}  // namespace

std::array<int, 2> betti_of_shape(const Polar_pipeline& pipeline) {
  const Power_shape_2 shape = power_shape(pipeline.polar);
  Primitive_set set;
  set.is_complex = true;
  set.vertices = lifted(pipeline.balls().centers);
  set.points = shape.isolated;
  set.segments = shape.edges;
  set.triangles = shape.triangles;
  return betti(set);
}

std::array<int, 2> betti_of_crust(const Polar_pipeline& pipeline) {
  Primitive_set set;
  set.is_complex = true;
  set.vertices = lifted(pipeline.diagram.vertices);
  for (const auto& segment : crust_segments(pipeline))
    if (segment[1] >= 0) set.segments.push_back(segment);
  return betti(set);
}

}  // namespace mesecina::test
