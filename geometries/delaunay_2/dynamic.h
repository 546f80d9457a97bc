// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <vector>

#include "geometries/delaunay_2/delaunay_2.h"

namespace mesecina {

/// Index in the arrays of Delaunay_2; -1 for a face that is not in them.
struct Array_index {
  int value = -1;
};

/// CGAL's triangulation behind the arrays. Inserting and removing keep nothing else up to date.
struct Delaunay_2::Dynamic {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Array_index, Kernel>;
  using Face_base = CGAL::Triangulation_face_base_with_info_2<Array_index, Kernel>;
  using Triangulation =
      CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>;
  using Vertex_handle = Triangulation::Vertex_handle;
  using Face_handle = Triangulation::Face_handle;

  Triangulation triangulation;
  std::vector<Vertex_handle> vertex_of_point;  ///< per point the vertex of its site
};

}  // namespace mesecina
