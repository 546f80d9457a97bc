// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/buffered_text.h"
#include "core/formats/loose_elements.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

template <class Face>
void write_face(Buffered_text& text, const Face& face) {
  text << std::size(face);
  for (const int vertex : face) text << " " << vertex;
  text << "\n";
}

void write_vertices(Buffered_text& text, const std::vector<Point_3>& vertices) {
  for (const Point_3& p : vertices) text << p.x << " " << p.y << " " << p.z << "\n";
}

void write_comments(Buffered_text& text, const Layer_document& document, const Primitive_set& set,
                    std::size_t segment_count) {
  text << "# layer " << on_one_line(document.layer) << "\n";
  if (!document.input.empty()) text << "# input " << on_one_line(document.input) << "\n";
  if (!document.reason.empty()) text << "# empty: " << on_one_line(document.reason) << "\n";
  const std::size_t left_out = set.rays.size() + set.arcs.size();
  if (left_out != 0) text << "# " << left_out << " rays and arcs are left out\n";
  if (segment_count != 0) text << "# " << segment_count << " segments as faces of two vertices\n";
  if (!set.balls.empty() || !set.radii.empty()) text << "# radii are left out\n";
}

}  // namespace

void write_off_layer(std::ostream& stream, const Layer_document& document) {
  const Primitive_set none;
  const Primitive_set& set = document.primitives ? *document.primitives : none;
  const auto segments = loose_elements(set).segments;
  Buffered_text text(stream);
  text << "OFF\n";
  write_comments(text, document, set, segments.size());
  text << set.vertices.size() << " " << segments.size() + set.triangles.size() + set.polygon_count() << " 0\n";
  write_vertices(text, set.vertices);
  for (const auto& segment : segments) write_face(text, segment);
  for (const auto& triangle : set.triangles) write_face(text, triangle);
  for (std::size_t i = 0; i < set.polygon_count(); ++i) write_face(text, set.polygon(i));
}

void write_off_mesh(std::ostream& stream, const Inputs& inputs) {
  const auto mesh = inputs.get(mesh_input);
  Buffered_text text(stream);
  text << "OFF\n" << (mesh ? mesh->vertices.size() : 0) << " " << (mesh ? mesh->triangles.size() : 0) << " 0\n";
  if (!mesh) return;
  write_vertices(text, mesh->vertices);
  for (const auto& triangle : mesh->triangles) write_face(text, triangle);
}

}  // namespace mesecina
