// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/formats/format.h"
#include "core/formats/text_file.h"

namespace mesecina {

/// Collects what mesh files hold: vertices, and faces as polygons over them.
class Polygon_collector {
 public:
  /// A hint, for speed.
  void reserve(std::size_t vertex_count, std::size_t face_count);
  void add_vertex(const Point_3& point) { vertices_.push_back(point); }
  const std::vector<Point_3>& vertices() const { return vertices_; }
  /// Of the face that is being read. By the time of `contents` there must be a vertex of this number.
  void add_corner(int vertex) { corners_.push_back(vertex); }
  /// The next corner belongs to another face. A face of fewer than three corners is left out and counted.
  void end_face();

  /// The mesh, its polygons triangulated; without faces, the cloud of the vertices. Warns of faces left out. Throws
  /// File_error for a polygon that is too large to be triangulated. O(size) for triangles and convex polygons.
  File_contents contents(const std::filesystem::path& path, Warning_list& warnings) &&;

 private:
  std::vector<Point_3> vertices_;
  std::vector<int> corners_;
  std::vector<std::size_t> face_ends_;  ///< in corners_
  std::size_t left_out_ = 0;
};

}  // namespace mesecina
