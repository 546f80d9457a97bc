// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_filtrations_3/medial_scale_3.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "geometries/scale_importance/scale_importance.h"

namespace mesecina {

std::vector<double> scale_of_vertices(const Medial_complex_3& complex, Progress& progress) {
  progress.begin_stage("scale importance");
  return scale_importance(complex.centers, complex.radii, slope_of_vertices(complex, progress), progress).values;
}

Medial_values_3 scale_values(const Medial_complex_3& complex, Progress& progress) {
  const std::vector<double> scale = scale_of_vertices(complex, progress);
  std::vector<double> faces;
  faces.reserve(complex.face_count());
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    double least = std::numeric_limits<double>::infinity();
    for (const int v : complex.face(f)) least = std::min(least, scale[v]);
    faces.push_back(least);
  }
  const Loose_parts_3 loose = loose_parts(complex);
  std::vector<double> edges;
  std::vector<double> vertices;
  edges.reserve(loose.edges.size());
  vertices.reserve(loose.vertices.size());
  for (const auto& [a, b] : loose.edges) edges.push_back(std::min(scale[a], scale[b]));
  for (const int v : loose.vertices) vertices.push_back(scale[v]);
  return values_with_bounds(complex, std::move(faces), edges, vertices);
}

}  // namespace mesecina
