// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/primitives.h"
#include "core/progress.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

/// Per place in face_vertices the edge from that vertex of the face to its next one. O(n) for few edges per vertex.
std::vector<int> edges_of_faces(const Medial_complex_3& complex, Progress& progress);
/// In one thread.
std::vector<int> edges_of_faces(const Medial_complex_3& complex);

/// One number per vertex, edge and face of a medial complex.
struct Medial_values_3 {
  std::vector<double> vertices;
  std::vector<double> edges;
  std::vector<double> faces;
};

/// Of faces; of edges the largest of their faces; of vertices the largest of their edges. Of edges and vertices that
/// bound nothing their own: loose_edges and loose_vertices, in the order of loose_parts. So what has at least some
/// value is a complex, whatever the value. O(n).
Medial_values_3 values_with_bounds(const Medial_complex_3& complex, std::vector<double> faces,
                                   const std::vector<double>& loose_edges, const std::vector<double>& loose_vertices);

/// Half the distance of the contacts; of an edge without faces the radius of the circle in which the spheres of its
/// ends meet, on which its contacts lie (that of the spheres where its ends coincide); of a lone vertex its radius.
/// O(n).
Medial_values_3 lambda_values(const Medial_complex_3& complex);
/// The largest angle under which contacts are seen, in degrees: angle_of_faces; of an edge without faces the same for
/// opposite points of the circle in which the spheres of its ends meet; of a lone vertex 180. O(n).
Medial_values_3 angle_values(const Medial_complex_3& complex, Progress& progress);

/// Per vertex the slope, in [0,1], at which the distance to the nearest of its known contacts, those of its faces,
/// grows from its center in the direction in which it grows fastest; 1 without any. O(n).
std::vector<double> slope_of_vertices(const Medial_complex_3& complex, Progress& progress);

/// The whole complex: its vertices as points, its edges as segments, its faces as polygons, with radii.
Primitive_set medial_primitives(const Medial_complex_3& complex);
/// Adds values to a set that medial_primitives made of the same complex.
void add_medial_values(Primitive_set& set, std::string name, std::string unit, const Medial_values_3& values);

}  // namespace mesecina
