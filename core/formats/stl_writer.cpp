// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "core/formats/buffered_text.h"
#include "core/formats/number.h"
#include "core/formats/polygon_triangles.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

constexpr std::size_t comment_size = 80;

void append_number(std::string& bytes, std::uint32_t number) {
  for (unsigned shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift & 0xFFU);
}

double in_single_precision(double number) {
  if (!(std::abs(number) <= std::numeric_limits<float>::max()))
    throw std::invalid_argument("expected coordinates that STL can hold, up to 3.4e38, found " + format_number(number) +
                                "; choose another format or scale the data");
  return static_cast<float>(number);
}

Point_3 in_single_precision(const Point_3& p) {
  return {in_single_precision(p.x), in_single_precision(p.y), in_single_precision(p.z)};
}

void append_triangle(std::string& bytes, std::span<const Point_3> vertices, const std::array<int, 3>& triangle) {
  // The normal is that of what is written, so that writing what was read gives the same bytes.
  std::array<Point_3, 3> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = in_single_precision(vertices[triangle[i]]);
  Point_3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = std::sqrt(dot(normal, normal));
  normal = std::isfinite(length) && length > 0 ? (1 / length) * normal : Point_3{};
  for (const Point_3& p : {normal, corners[0], corners[1], corners[2]})
    for (const double number : {p.x, p.y, p.z})
      append_number(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(number)));
  bytes.append(2, '\0');
}

void write_triangles(std::ostream& stream, std::string comment, const Triangle_mesh_3& mesh) {
  if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument("STL holds no more than 4294967295 triangles; choose another format");
  comment.resize(comment_size, ' ');
  append_number(comment, static_cast<std::uint32_t>(mesh.triangles.size()));
  Buffered_text text(stream);
  text << comment;
  std::string bytes;
  for (const auto& triangle : mesh.triangles) {
    bytes.clear();
    append_triangle(bytes, mesh.vertices, triangle);
    text << bytes;
  }
}

}  // namespace

void write_stl_layer(std::ostream& stream, const Layer_document& document) {
  Triangle_mesh_3 mesh;
  std::size_t left_out = 0;
  if (const Primitive_set* set = document.primitives) {
    mesh.vertices = set->vertices;
    mesh.triangles = set->triangles;
    for (std::size_t i = 0; i < set->polygon_count(); ++i)
      if (!append_triangles(mesh, set->polygon(i))) ++left_out;
    left_out += set->element_count() - set->triangles.size() - set->polygon_count();
  }
  // Programs take a file that begins with "solid" for one of text.
  std::string comment = "mesecina " + on_one_line(document.layer);
  if (!document.reason.empty()) comment += ", empty: " + on_one_line(document.reason);
  if (left_out > 0) comment += ", " + std::to_string(left_out) + " elements left out";
  write_triangles(stream, std::move(comment), mesh);
}

void write_stl_mesh(std::ostream& stream, const Inputs& inputs) {
  const auto mesh = inputs.get(mesh_input);
  write_triangles(stream, "mesecina mesh", mesh ? *mesh : Triangle_mesh_3());
}

}  // namespace mesecina
