// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/polygon_collector.h"

#include <span>
#include <string>
#include <utility>

#include "core/formats/polygon_triangles.h"

namespace mesecina {

void Polygon_collector::reserve(std::size_t vertex_count, std::size_t face_count) {
  vertices_.reserve(vertex_count);
  corners_.reserve(3 * face_count);
  face_ends_.reserve(face_count);
}

void Polygon_collector::end_face() {
  const std::size_t begin = face_ends_.empty() ? 0 : face_ends_.back();
  if (corners_.size() - begin >= 3) {
    face_ends_.push_back(corners_.size());
  } else {
    corners_.resize(begin);
    ++left_out_;
  }
}

File_contents Polygon_collector::contents(const std::filesystem::path& path, Warning_list& warnings) && {
  if (left_out_ != 0) {
    warnings.add(std::to_string(left_out_) +
                 (left_out_ == 1 ? " face of fewer than three corners is" : " faces of fewer than three corners are") +
                 " not read");
  }
  File_contents contents;
  if (face_ends_.empty()) {
    contents.inputs = contents.inputs.with(cloud_input, std::move(vertices_));
  } else {
    Triangle_mesh_3 mesh{std::move(vertices_), {}};
    mesh.triangles.reserve(corners_.size() - 2 * face_ends_.size());
    std::size_t begin = 0;
    for (std::size_t face = 0; face < face_ends_.size(); ++face) {
      const auto polygon = std::span(corners_).subspan(begin, face_ends_[face] - begin);
      begin = face_ends_[face];
      if (!append_triangles(mesh, polygon)) {
        throw File_error(path, 0,
                         "expected polygons that are convex or have at most " +
                             std::to_string(most_corners_of_nonconvex_polygons) + " corners, found face " +
                             std::to_string(face + 1) + " with " + std::to_string(polygon.size()) +
                             "; split it into triangles");
      }
    }
    contents.inputs = contents.inputs.with(mesh_input, std::move(mesh));
  }
  contents.warnings = warnings.take();
  return contents;
}

}  // namespace mesecina
