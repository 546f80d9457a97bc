// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometries/union_3/union_3.h"

namespace mesecina {

/// Edges of a medial complex that make curves: they go on through every vertex that has exactly two of them.
struct Medial_curves_3 {
  std::vector<int> edges;       ///< of the complex, ascending
  std::vector<int> curves;      ///< per edge here its curve, numbered in the order of their first edges
  std::vector<double> lengths;  ///< per curve

  std::size_t count() const { return lengths.size(); }
};

/// What a medial complex is made of, beside its sheets.
/// [P. Giblin, B. Kimia: A formal classification of 3D medial axis points and their local geometry, 2004]
struct Medial_features_3 {
  /// Per edge how many faces it has; a face that has it twice counts twice.
  std::vector<int> faces_of_edges;
  Medial_curves_3 seams;            ///< where sheets meet: edges with three or more faces
  Medial_curves_3 rims;             ///< where sheets end: edges with one face
  std::vector<int> sheets_of_rims;  ///< per edge of a rim the sheet of its face
  /// Vertices where seams meet or end: those with one edge of a seam, or three and more; ascending.
  std::vector<int> junctions;
  std::vector<int> seams_of_junctions;   ///< per junction its edges of seams
  std::vector<int> sheets_of_junctions;  ///< per junction the different sheets around it
};

/// `sheet_of_face`: per face of the complex its sheet. O(n log n).
Medial_features_3 medial_features(const Medial_complex_3& complex, const std::vector<int>& sheet_of_face);

/// Per face its area.
std::vector<double> areas_of_faces(const Medial_complex_3& complex);

}  // namespace mesecina
