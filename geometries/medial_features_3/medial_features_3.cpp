// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_features_3/medial_features_3.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/disjoint_sets.h"
#include "geometries/union_3/medial_values_3.h"

namespace mesecina {

namespace {

/// How many of some edges each vertex has.
std::vector<int> degrees_of(const Medial_complex_3& complex, const std::vector<int>& edges) {
  std::vector<int> degrees(complex.centers.size(), 0);
  for (const int e : edges)
    for (const int v : complex.edges[e]) ++degrees[v];
  return degrees;
}

Medial_curves_3 curves_of(const Medial_complex_3& complex, std::vector<int> edges) {
  const std::vector<int> degrees = degrees_of(complex, edges);
  Disjoint_sets parts(edges.size());
  std::vector<int> first_at(complex.centers.size(), -1);
  for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
    for (const int v : complex.edges[edges[i]]) {
      if (degrees[v] != 2) continue;
      if (first_at[v] < 0) {
        first_at[v] = i;
      } else {
        parts.join(first_at[v], i);
      }
    }
  }
  Medial_curves_3 result;
  std::vector<int> curve_of_part(edges.size(), -1);
  for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
    int& curve = curve_of_part[parts.find(i)];
    if (curve < 0) {
      curve = static_cast<int>(result.lengths.size());
      result.lengths.push_back(0);
    }
    result.curves.push_back(curve);
    const auto& [a, b] = complex.edges[edges[i]];
    result.lengths[curve] += distance(complex.centers[a], complex.centers[b]);
  }
  result.edges = std::move(edges);
  return result;
}

void find_junctions(const Medial_complex_3& complex, const std::vector<int>& sheet_of_face,
                    Medial_features_3& features) {
  const std::vector<int> degrees = degrees_of(complex, features.seams.edges);
  std::vector<int> junction_of_vertex(complex.centers.size(), -1);
  for (std::size_t v = 0; v < degrees.size(); ++v) {
    if (degrees[v] == 0 || degrees[v] == 2) continue;
    junction_of_vertex[v] = static_cast<int>(features.junctions.size());
    features.junctions.push_back(static_cast<int>(v));
    features.seams_of_junctions.push_back(degrees[v]);
  }
  std::vector<std::vector<int>> sheets(features.junctions.size());
  for (std::size_t f = 0; f < complex.face_count(); ++f)
    for (const int v : complex.face(f))
      if (junction_of_vertex[v] >= 0) sheets[junction_of_vertex[v]].push_back(sheet_of_face[f]);
  for (auto& around : sheets) {
    std::ranges::sort(around);
    features.sheets_of_junctions.push_back(
        static_cast<int>(std::unique(around.begin(), around.end()) - around.begin()));
  }
}

}  // namespace

Medial_features_3 medial_features(const Medial_complex_3& complex, const std::vector<int>& sheet_of_face) {
  Medial_features_3 features;
  features.faces_of_edges.assign(complex.edges.size(), 0);
  const std::vector<int> sides = edges_of_faces(complex);
  std::vector<int> some_sheet(complex.edges.size(), -1);
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    for (int i = complex.face_offsets[f]; i < complex.face_offsets[f + 1]; ++i) {
      ++features.faces_of_edges[sides[i]];
      some_sheet[sides[i]] = sheet_of_face[f];
    }
  }
  std::vector<int> seams;
  std::vector<int> rims;
  for (int e = 0; e < static_cast<int>(complex.edges.size()); ++e) {
    if (features.faces_of_edges[e] > 2) seams.push_back(e);
    if (features.faces_of_edges[e] == 1) rims.push_back(e);
  }
  features.seams = curves_of(complex, std::move(seams));
  for (const int e : rims) features.sheets_of_rims.push_back(some_sheet[e]);
  features.rims = curves_of(complex, std::move(rims));
  find_junctions(complex, sheet_of_face, features);
  return features;
}

std::vector<double> areas_of_faces(const Medial_complex_3& complex) {
  std::vector<double> areas;
  areas.reserve(complex.face_count());
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    const auto corners = complex.face(f);
    const Point_3& first = complex.centers[corners.front()];
    Point_3 doubled;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      doubled = doubled + cross(complex.centers[corners[i]] - first, complex.centers[corners[i + 1]] - first);
    areas.push_back(std::sqrt(dot(doubled, doubled)) / 2);
  }
  return areas;
}

}  // namespace mesecina
