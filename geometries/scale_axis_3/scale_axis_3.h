// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "geometries/union_3/medial_values_3.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

/// Balls with their radii times `scale`.
std::vector<Ball_3> grown(const std::vector<Ball_3>& balls, double scale);

/// Sheets of a complex: faces that hang together across edges with two faces.
struct Sheets_3 {
  std::vector<int> sheet_of_face;
  int count = 0;
};

/// Numbered in the order of their first faces. O(n).
Sheets_3 sheets(const Medial_complex_3& complex);
/// The sheet of each face, and of each edge and vertex whose faces are all of one sheet; -1 where several meet, and
/// where there is none. O(n).
Medial_values_3 sheet_values(const Medial_complex_3& complex);

/// A part of a complex, and where its faces are in the whole.
struct Pruned_complex_3 {
  Medial_complex_3 complex;
  Sheets_3 sheets;         ///< of the part
  std::vector<int> faces;  ///< per face its number in the whole complex, ascending
};
/// The complex without the sheets whose largest face angle is less than `min_angle` degrees, the smallest first, as
/// long as it collapses to what is left, so that the topology stays; sheets that become one when another goes count as
/// one. `angles`: per face, in degrees. O(n log n). [B. Miklos: The Scale Axis Transform, 2010, section 6.1.3]
Pruned_complex_3 without_small_sheets(const Medial_complex_3& complex, const std::vector<double>& angles,
                                      double min_angle, Progress& progress);

/// Moves vertices on rims, where faces end and exactly two rim edges meet, toward the middle of their two neighbours,
/// `steps` times. Each ball becomes the largest around its new center within one of its own or its neighbours' old
/// balls.
Medial_complex_3 with_smooth_rims(Medial_complex_3 complex, int steps);

/// A simplicial complex of balls: what the scale axis transform gives.
struct Ball_complex_3 {
  std::vector<Point_3> centers;
  std::vector<double> radii;
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> face_of_triangle;      ///< of the complex that was sampled
  std::vector<std::array<int, 2>> edges;  ///< that no triangle has
  std::vector<int> points;                ///< vertices that no edge has
};

/// Samples a complex so densely that balls at the ends of an edge, with radii divided by `scale`, meet at no less than
/// `min_angle` degrees (179 at most) or contain each other: polygons become triangles, edges are halved. Radii of the
/// result are divided by `scale`. Near a point where balls only touch halving stops after 24 rounds. Throws Unavailable
/// when there would be more than 20 million balls. O(output).
/// [B. Miklos: The Scale Axis Transform, 2010, section 6.1.2]
Ball_complex_3 sampled(const Medial_complex_3& complex, double scale, double min_angle, Progress& progress);

}  // namespace mesecina
